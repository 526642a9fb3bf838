//! The motion of both bodies as a function of its parameters, and its least-squares fit.
//!
//! Each body moves to the contact and away from it along straight lines; on each of these two legs
//! it may slow down at a constant rate, even to a stop. The legs meet at the position of the body's
//! centre at the time of contact; this time is the same for both bodies. The fit is by Gauss-Newton
//! steps with Levenberg's damping.

#![allow(
    clippy::needless_range_loop,
    reason = "sums over a matrix are read by their indices"
)]

use glam::{DVec2, dvec2};

use super::track::{Leg, Point};

/// The number of parameters: two coordinates of each body's centre at contact, two of each of the
/// four velocities, the time of contact, and the deceleration of each body.
pub(super) const PARAMETERS: usize = 15;
const TIME: usize = 12;
/// The number of coordinates that have separate noise: x and y of each body.
pub(super) const CHANNELS: usize = 4;

pub(super) type Vector = [f64; PARAMETERS];
pub(super) type Matrix = [Vector; PARAMETERS];

const ZERO: Matrix = [[0.0; PARAMETERS]; PARAMETERS];

const fn centre(body: usize) -> usize {
    2 * body
}

const fn velocity(body: usize, leg: Leg) -> usize {
    4 + 4 * body + 2 * (leg as usize)
}

const fn slowing(body: usize) -> usize {
    13 + body
}

/// The motion of both bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct State(pub(super) Vector);

impl State {
    /// A collision at `time` with these centres and velocities (of each body, before and after),
    /// and these decelerations.
    pub(crate) fn new(
        time: f64,
        centres: [DVec2; 2],
        velocities: [[DVec2; 2]; 2],
        slowings: [f64; 2],
    ) -> Self {
        let mut all = [0.0; PARAMETERS];
        all[TIME] = time;
        for body in 0..2 {
            put(&mut all, centre(body), centres[body]);
            put(&mut all, velocity(body, Leg::Before), velocities[body][0]);
            put(&mut all, velocity(body, Leg::After), velocities[body][1]);
            all[slowing(body)] = slowings[body];
        }
        Self(all)
    }

    /// The centre of a body at the contact, in metres.
    pub(crate) fn centre(&self, body: usize) -> DVec2 {
        self.pair(centre(body))
    }

    /// The velocity of a body just before or just after the contact, in m/s.
    pub(crate) fn velocity(&self, body: usize, leg: Leg) -> DVec2 {
        self.pair(velocity(body, leg))
    }

    /// The time of contact in seconds.
    pub(crate) fn time(&self) -> f64 {
        self.0[TIME]
    }

    /// The deceleration of a body in m/s².
    pub(crate) fn slowing(&self, body: usize) -> f64 {
        self.0[slowing(body)]
    }

    pub(super) fn set_slowing(&mut self, body: usize, rate: f64) {
        self.0[slowing(body)] = rate;
    }

    pub(super) fn set_velocity(&mut self, body: usize, leg: Leg, to: DVec2) {
        put(&mut self.0, velocity(body, leg), to);
    }

    pub(super) fn set_time(&mut self, time: f64) {
        self.0[TIME] = time;
    }

    fn pair(&self, at: usize) -> DVec2 {
        dvec2(self.0[at], self.0[at + 1])
    }

    /// The position of a body at a time.
    pub(crate) fn at(&self, body: usize, t: f64, model: &Model) -> DVec2 {
        self.centre(body) + self.moved(body, t, model).by
    }

    fn moved(&self, body: usize, t: f64, model: &Model) -> Moved {
        let leg = if t < self.time() {
            Leg::Before
        } else {
            Leg::After
        };
        let (velocity, since) = (self.velocity(body, leg), t - self.time());
        let speed = velocity.length();
        if !model.slows[body][leg as usize] || speed <= 0.0 {
            return Moved {
                leg,
                by: velocity * since,
                since,
                along: None,
            };
        }
        let rate = self.slowing(body);
        // The body slows down to a stop and stays there.
        let since = if rate > 0.0 {
            since.min(speed / rate)
        } else {
            since
        };
        let distance = (speed - 0.5 * rate * since) * since;
        let along = velocity / speed;
        Moved {
            leg,
            by: along * distance,
            since,
            along: Some((along, distance / speed, speed - rate * since)),
        }
    }
}

fn put(all: &mut Vector, at: usize, value: DVec2) {
    all[at] = value.x;
    all[at + 1] = value.y;
}

/// Where a body is relative to its centre at contact.
struct Moved {
    leg: Leg,
    by: DVec2,
    /// The time since the contact, but at most until the body stops.
    since: f64,
    /// If the body slows down: its direction, the distance moved since the contact divided by the
    /// speed at contact, and its speed at the time `since`.
    along: Option<(DVec2, f64, f64)>,
}

/// What the fit may adjust.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Model {
    /// On which of its legs each body slows down.
    pub(crate) slows: [[bool; 2]; 2],
    /// The sum of the radii and its standard uncertainty, if it is used to find the contact.
    pub(crate) apart: Option<(f64, f64)>,
}

impl Model {
    pub(super) fn slows(&self, body: usize) -> bool {
        self.slows[body].contains(&true)
    }

    /// The number of parameters for slowing down.
    pub(super) fn rates(&self) -> usize {
        usize::from(self.slows(0)) + usize::from(self.slows(1))
    }

    fn adjusts(&self, parameter: usize) -> bool {
        match parameter.checked_sub(slowing(0)) {
            Some(body) => self.slows(body),
            None => true,
        }
    }
}

/// The normal equations of each channel with weight 1, at one state.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Normal {
    matrix: [Matrix; CHANNELS],
    gradient: [Vector; CHANNELS],
    /// The sum of the squared residuals in each channel.
    pub(super) squares: [f64; CHANNELS],
    /// The number of points in each channel.
    pub(super) count: [f64; CHANNELS],
}

impl Normal {
    pub(super) fn new(state: &State, model: &Model, tracks: [&[Point]; 2]) -> Self {
        let mut it = Self {
            matrix: [ZERO; CHANNELS],
            gradient: [[0.0; PARAMETERS]; CHANNELS],
            squares: [0.0; CHANNELS],
            count: [0.0; CHANNELS],
        };
        for (body, points) in tracks.into_iter().enumerate() {
            for point in points {
                it.add(state, model, body, point);
            }
        }
        it
    }

    fn add(&mut self, state: &State, model: &Model, body: usize, point: &Point) {
        let moved = state.moved(body, point.t, model);
        let missed = point.at - state.centre(body) - moved.by;
        let at = velocity(body, moved.leg);
        for axis in 0..2 {
            let unit = if axis == 0 { DVec2::X } else { DVec2::Y };
            let mut row = [
                (centre(body) + axis, 1.0),
                (at, 0.0),
                (at + 1, 0.0),
                (TIME, 0.0),
                (slowing(body), 0.0),
            ];
            match moved.along {
                None => {
                    row[1 + axis].1 = moved.since;
                    row[3].1 = -unit.dot(state.velocity(body, moved.leg));
                }
                Some((along, turned, speed)) => {
                    let share = unit.dot(along);
                    let by = along * (share * (moved.since - turned)) + unit * turned;
                    (row[1].1, row[2].1) = (by.x, by.y);
                    row[3].1 = -share * speed;
                    row[4].1 = -0.5 * share * moved.since * moved.since;
                }
            }
            let channel = 2 * body + axis;
            let missed = unit.dot(missed);
            self.squares[channel] += point.weight * missed * missed;
            self.count[channel] += 1.0;
            for (i, a) in row {
                self.gradient[channel][i] += point.weight * a * missed;
                for (j, b) in row {
                    self.matrix[channel][i][j] += point.weight * a * b;
                }
            }
        }
    }

    /// The weighted matrix and gradient, with the sum of the radii as one more observation.
    fn weighted(
        &self,
        state: &State,
        model: &Model,
        weights: &[f64; CHANNELS],
    ) -> (Matrix, Vector) {
        let (mut matrix, mut gradient) = (ZERO, [0.0; PARAMETERS]);
        for channel in 0..CHANNELS {
            for i in 0..PARAMETERS {
                gradient[i] += weights[channel] * self.gradient[channel][i];
                for j in 0..PARAMETERS {
                    matrix[i][j] += weights[channel] * self.matrix[channel][i][j];
                }
            }
        }
        if let Some((missed, n, sigma)) = missed_apart(state, model) {
            let row = [(0, -n.x), (1, -n.y), (2, n.x), (3, n.y)];
            for (i, a) in row {
                gradient[i] += a * missed / (sigma * sigma);
                for (j, b) in row {
                    matrix[i][j] += a * b / (sigma * sigma);
                }
            }
        }
        for i in (0..PARAMETERS).filter(|i| !model.adjusts(*i)) {
            for j in 0..PARAMETERS {
                (matrix[i][j], matrix[j][i]) = (0.0, 0.0);
            }
            (matrix[i][i], gradient[i]) = (1.0, 0.0);
        }
        (matrix, gradient)
    }

    /// The weighted sum of squares.
    pub(super) fn chi2(&self, state: &State, model: &Model, weights: &[f64; CHANNELS]) -> f64 {
        let points: f64 = self.squares.iter().zip(weights).map(|(s, w)| s * w).sum();
        let apart = missed_apart(state, model).map_or(0.0, |(missed, _, sigma)| missed / sigma);
        points + apart * apart
    }

    /// The covariance of the parameters, with the inverse variances of the channels as weights.
    pub(super) fn covariance(
        &self,
        state: &State,
        model: &Model,
        weights: &[f64; CHANNELS],
    ) -> Option<Matrix> {
        let mut inverse = inverse(&self.weighted(state, model, weights).0)?;
        for i in (0..PARAMETERS).filter(|i| !model.adjusts(*i)) {
            inverse[i][i] = 0.0;
        }
        Some(inverse)
    }

    /// The number of parameters that each channel determines: the trace of its part of the hat
    /// matrix.
    pub(super) fn used(&self, covariance: &Matrix, weights: &[f64; CHANNELS]) -> [f64; CHANNELS] {
        let mut used = [0.0; CHANNELS];
        for channel in 0..CHANNELS {
            for i in 0..PARAMETERS {
                for j in 0..PARAMETERS {
                    let part = weights[channel] * self.matrix[channel][j][i];
                    used[channel] += covariance[i][j] * part;
                }
            }
        }
        used
    }

    /// The product of a channel's matrix and the vector x.
    pub(super) fn times(&self, channel: usize, x: &Vector) -> Vector {
        self.matrix[channel].map(|row| dot(&row, x))
    }
}

/// The difference between the sum of the radii and the distance between the centres, the direction
/// from centre 1 to centre 2, and the σ of the sum.
fn missed_apart(state: &State, model: &Model) -> Option<(f64, DVec2, f64)> {
    let (apart, sigma) = model.apart?;
    let between = state.centre(1) - state.centre(0);
    let length = between.length();
    (length > 0.0).then(|| (apart - length, between / length, sigma))
}

/// The state with the least weighted sum of squares near `start`; `None` if the points do not
/// determine it.
pub(super) fn descend(
    start: State,
    model: &Model,
    weights: &[f64; CHANNELS],
    tracks: [&[Point]; 2],
) -> Option<(State, Normal)> {
    const STEPS: usize = 60;
    const ENOUGH: f64 = 1e-10;
    let mut state = start;
    let mut normal = Normal::new(&state, model, tracks);
    let mut chi2 = normal.chi2(&state, model, weights);
    let mut damping = 1e-4;
    for _ in 0..STEPS {
        let (mut matrix, gradient) = normal.weighted(&state, model, weights);
        for (i, row) in matrix.iter_mut().enumerate() {
            row[i] *= 1.0 + damping;
        }
        let Some(step) = inverse(&matrix).map(|inverse| inverse.map(|row| dot(&row, &gradient)))
        else {
            damping *= 10.0;
            if damping > 1e8 {
                return None;
            }
            continue;
        };
        let mut next = state;
        for (value, step) in next.0.iter_mut().zip(step) {
            *value += step;
        }
        let trial = Normal::new(&next, model, tracks);
        let reached = trial.chi2(&next, model, weights);
        if reached <= chi2 {
            let gained = chi2 - reached;
            (state, normal) = (next, trial);
            chi2 = reached;
            damping = (0.1 * damping).max(1e-14);
            if gained <= ENOUGH * (chi2 + f64::MIN_POSITIVE) {
                break;
            }
        } else {
            damping *= 10.0;
            if damping > 1e10 {
                break;
            }
        }
    }
    chi2.is_finite().then_some((state, normal))
}

pub(super) fn dot(a: &Vector, b: &Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The inverse of a symmetric positive definite matrix by Cholesky decomposition, after scaling
/// to a unit diagonal.
fn inverse(matrix: &Matrix) -> Option<Matrix> {
    /// Below this pivot, a parameter would be determined by rounding errors alone.
    const SINGULAR: f64 = 1e-13;
    let mut scale = [0.0; PARAMETERS];
    for i in 0..PARAMETERS {
        let diagonal = matrix[i][i];
        if !(diagonal > 0.0 && diagonal.is_finite()) {
            return None;
        }
        scale[i] = 1.0 / diagonal.sqrt();
    }
    let mut lower = ZERO;
    for i in 0..PARAMETERS {
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| lower[i][k] * lower[j][k]).sum();
            let rest = matrix[i][j] * scale[i] * scale[j] - known;
            if i == j {
                if rest <= SINGULAR {
                    return None;
                }
                lower[i][i] = rest.sqrt();
            } else {
                lower[i][j] = rest / lower[j][j];
            }
        }
    }
    let mut inverse = ZERO;
    for column in 0..PARAMETERS {
        let mut x = [0.0; PARAMETERS];
        for i in column..PARAMETERS {
            let known: f64 = (column..i).map(|k| lower[i][k] * x[k]).sum();
            x[i] = (f64::from(u8::from(i == column)) - known) / lower[i][i];
        }
        for i in (0..PARAMETERS).rev() {
            let known: f64 = (i + 1..PARAMETERS).map(|k| lower[k][i] * x[k]).sum();
            x[i] = (x[i] - known) / lower[i][i];
        }
        for i in 0..PARAMETERS {
            inverse[i][column] = x[i] * scale[i] * scale[column];
        }
    }
    Some(inverse)
}
