//! The fit to both tracks: the kind of motion that the data require, the noise, and the estimate of
//! any quantity with its uncertainty.

use std::array::from_fn;
use std::f64::consts::PI;

use glam::DVec2;

use super::contact::{FEWEST, guesses, leg, refuse_exchanged};
use super::model::{CHANNELS, Matrix, Model, Normal, PARAMETERS, State, Vector, descend, dot};
use super::student::{beyond_f, beyond_t, t_beyond};
use super::track::{LEGS, Leg, Point, Track, thinned};
use super::{Fault, SlowingDown};

/// Straight lines are rejected in favour of slowing down if chance alone would improve the fit as
/// much in less than this fraction of all measurements.
pub const LEVEL: f64 = 0.01;
/// With fewer degrees of freedom than this, the noise of each body alone would be too uncertain.
/// Both bodies then share one noise level in x and one in y.
const FEW: f64 = 25.0;
/// The standard uncertainty of the sum of two radii, as measured with a calliper, in metres.
const RADII_SIGMA: f64 = 1e-4;
/// A quantity smaller than its uncertainty times this factor is not clearly different from zero: it
/// has no direction, and nothing is divided by it.
const CLEAR: f64 = 4.0;
/// If the distance between the centres at contact differs from the sum of the radii by more than
/// this number of standard uncertainties, the tracks contradict the radii.
const CONTRADICTS: f64 = 3.0;
/// The probability that a standard normal variable is outside ±1.
pub(super) const ONE_SIGMA: f64 = 0.317_310_507_862_914;

/// A quantity as a function of the state.
type OfState<'f> = dyn Fn(&State) -> Option<f64> + 'f;

/// A quantity with its uncertainty.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The value, in SI units and radians.
    pub value: f64,
    /// The standard deviation.
    pub deviation: f64,
    /// The degrees of freedom of the standard deviation.
    pub freedom: f64,
}

impl Estimate {
    /// Half the width of the interval that covers the truth in 68 % of all measurements: the
    /// standard deviation, widened by Student's t if there are few points.
    pub fn uncertainty(&self) -> f64 {
        self.deviation * t_beyond(ONE_SIGMA, self.freedom)
    }

    /// Half the width of the 95 % interval.
    pub fn uncertainty95(&self) -> f64 {
        self.deviation * t_beyond(0.05, self.freedom)
    }

    /// The distance from a value, as a number of standard uncertainties.
    pub fn sigmas(&self, from: f64) -> f64 {
        (self.value - from).abs() / self.uncertainty().max(f64::MIN_POSITIVE)
    }

    /// The probability of an estimate at least as far from `truth` as this one if `truth` is the
    /// true value.
    pub fn chance(&self, truth: f64) -> f64 {
        beyond_t(
            (self.value - truth).abs() / self.deviation.max(f64::MIN_POSITIVE),
            self.freedom,
        )
    }

    /// Whether the value is clearly different from zero.
    pub(super) fn is_clear(&self) -> bool {
        self.value.abs() > CLEAR * self.uncertainty()
    }
}

/// The test that decides between straight lines and slowing down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlowingTest {
    /// The F ratio.
    pub f: f64,
    /// The probability that a ratio this large occurs by chance.
    pub p: f64,
    /// Whether both bodies slow down as fitted (and not speed up).
    pub is_slowing: bool,
}

/// The distance between the centres at contact, compared with the radii.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Apart {
    /// The distance found from the tracks alone.
    pub found: Estimate,
    /// The sum of the radii, in metres.
    pub radii: f64,
    /// Whether the two agree and the sum of the radii was used to find the contact.
    pub agrees: bool,
}

/// The fit to both tracks.
#[derive(Debug, Clone, PartialEq)]
pub struct TracksFit {
    pub(crate) state: State,
    pub(crate) model: Model,
    /// The standard deviation of the noise in x and y of each body, in metres.
    pub noise: [f64; CHANNELS],
    /// The test for slowing down, if one was made.
    pub test: Option<SlowingTest>,
    /// The distance between the centres at contact, if the radii are known.
    pub apart: Option<Apart>,
    /// How strongly neighbouring residuals are correlated, as a number of standard deviations of
    /// the values expected by chance.
    pub alike: f64,
    /// The number of points of each body before and after the contact.
    pub counts: [[usize; 2]; 2],
    /// The longer of the two bodies' gaps between points around the contact, and the median time
    /// between points, in seconds.
    pub gap: (f64, f64),
    normal: Normal,
    weights: [f64; CHANNELS],
    covariance: Matrix,
    freedom: [f64; CHANNELS],
    /// Whether the noise along each axis is estimated for both bodies together, because there are
    /// few points.
    is_pooled: bool,
}

impl TracksFit {
    /// Fits two tracks. `radii` is the sum of the radii, if it is known.
    ///
    /// # Errors
    /// Returns an error if the tracks contain no measurable collision.
    pub(super) fn new(
        tracks: &[Track; 2],
        radii: Option<f64>,
        slowing: SlowingDown,
    ) -> Result<Self, Fault> {
        refuse_exchanged(tracks)?;
        let guesses = guesses(tracks)?;
        let middle = guesses.first().map_or(0.0, State::time);
        let thin = tracks
            .each_ref()
            .map(|track| thinned(&track.points, middle));
        let points = [thin[0].as_slice(), thin[1].as_slice()];
        let mut fit = Self::of_points(&guesses, points, slowing)?;
        if !fit.is_collision() {
            return Err(Fault::new(
                "expected a collision, found two paths without a clear change of velocity: the \
                 bodies miss each other, or the noise hides the contact",
            ));
        }
        fit.use_radii(radii, points);
        fit.alike = alike(&fit, points);
        let time = fit.state.time();
        for (body, track) in tracks.iter().enumerate() {
            for side in LEGS {
                let count = leg(&track.points, time, side).len();
                if count < FEWEST {
                    return Err(Fault::new(format!(
                        "expected at least {FEWEST} points of {} {side} the contact at {time:.3} s, \
                         found {count}",
                        track.name
                    )));
                }
                fit.counts[body][side as usize] = count;
            }
        }
        fit.gap = gap(tracks, time);
        Ok(fit)
    }

    fn of_points(
        guesses: &[State],
        points: [&[Point]; 2],
        slowing: SlowingDown,
    ) -> Result<Self, Fault> {
        let unfit = || {
            Fault::new(
                "expected a collision, found tracks that do not determine a contact: the bodies \
                 miss each other, do not move, or have too few points",
            )
        };
        let starts = guesses.iter().flat_map(|it| around(it, points));
        let straight = Self::best(starts, &Model::default(), points).ok_or_else(unfit)?;
        if slowing == SlowingDown::Never {
            return Ok(straight);
        }
        let moves = |fit: &Self, body, side| {
            let speed = fit.estimate(|state| Some(state.velocity(body, side).length()));
            speed.is_some_and(|it| it.is_clear())
        };
        let mut model = straight.model;
        for body in 0..2 {
            let [before, after] = LEGS.map(|side| moves(&straight, body, side));
            // If a body stops soon after the contact, its motion is clear only before the contact.
            model.slows[body] = [before, before || after];
        }
        let starts: Vec<_> = guesses.iter().chain([&straight.state]).collect();
        let mut slow = None;
        for _ in 0..=2 {
            let starts = starts.iter().flat_map(|it| slower(it, &model, points));
            slow = Self::best(starts, &model, points).filter(|it| it.freedom() >= 1.0);
            let mut slowing = (0..2).filter(|body| model.slows[*body][0]);
            // If straight lines are fitted to the paths of slowing bodies, a body at rest seems to
            // move.
            let at_rest = match &slow {
                Some(fit) => slowing.find(|body| !moves(fit, *body, Leg::Before)),
                None => slowing.min_by(|a, b| {
                    let speed = |body: &usize| straight.state.velocity(*body, Leg::Before).length();
                    speed(a).total_cmp(&speed(b))
                }),
            };
            let Some(body) = at_rest else { break };
            model.slows[body] = [false, moves(&straight, body, Leg::After)];
        }
        let Some(slow) = slow else {
            return Ok(straight);
        };
        let model = slow.model;
        let again = descend(straight.state, &straight.model, &slow.weights, points);
        let (state, normal) = again.ok_or_else(unfit)?;
        let chi2 = slow.normal.chi2(&slow.state, &slow.model, &slow.weights);
        let more = normal.chi2(&state, &straight.model, &slow.weights) - chi2;
        let (rates, freedom) = (model.rates().max(1) as f64, slow.freedom());
        let f = (more / rates) / (chi2 / freedom);
        let test = SlowingTest {
            f,
            p: beyond_f(f, rates, freedom),
            is_slowing: (0..2).all(|body| slow.state.slowing(body) >= 0.0),
        };
        let slows = slowing == SlowingDown::Always || test.p < LEVEL;
        let chosen = if slows { slow } else { straight };
        Ok(Self {
            test: Some(test),
            ..chosen
        })
    }

    /// The best fit from any of these starts, with the noise estimated from its residuals.
    fn best(
        starts: impl Iterator<Item = State>,
        model: &Model,
        points: [&[Point]; 2],
    ) -> Option<Self> {
        let fits = starts.filter_map(|start| {
            let (state, normal) = descend(start, model, &[1.0; CHANNELS], points)?;
            let chi2 = normal.chi2(&state, model, &[1.0; CHANNELS]);
            Some((state, chi2))
        });
        let (state, _) = fits.min_by(|a, b| a.1.total_cmp(&b.1))?;
        Self::weighted(state, model, [1.0; CHANNELS], points)
    }

    /// The fit near a state, with each channel weighted by its own noise.
    fn weighted(
        mut state: State,
        model: &Model,
        mut weights: [f64; CHANNELS],
        points: [&[Point]; 2],
    ) -> Option<Self> {
        const ROUNDS: usize = 4;
        let mut last = None;
        let mut is_pooled = false;
        for _ in 0..ROUNDS {
            let (next, normal) = descend(state, model, &weights, points)?;
            state = next;
            let covariance = normal.covariance(&state, model, &weights)?;
            let used = normal.used(&covariance, &weights);
            // Positions printed to a few figures have at least this noise.
            let least = 1e-9 * extent(points);
            let freedom: [f64; CHANNELS] = from_fn(|channel| normal.count[channel] - used[channel]);
            if freedom.iter().any(|freedom| *freedom < 0.5) {
                return None;
            }
            is_pooled = freedom.iter().any(|freedom| *freedom < FEW);
            let noise: [f64; CHANNELS] = from_fn(|channel| {
                let apart = if is_pooled { 2 } else { 0 };
                let other = (channel + apart) % CHANNELS;
                let squares = normal.squares[channel] + normal.squares[other];
                let variance = squares / (freedom[channel] + freedom[other]);
                variance.sqrt().max(least)
            });
            weights = noise.map(|sigma| 1.0 / (sigma * sigma));
            last = Some((normal, freedom, noise));
        }
        let (normal, freedom, noise) = last?;
        let covariance = normal.covariance(&state, model, &weights)?;
        Some(Self {
            state,
            model: *model,
            noise,
            test: None,
            apart: None,
            alike: 0.0,
            counts: [[0; 2]; 2],
            gap: (0.0, 0.0),
            normal,
            weights,
            covariance,
            freedom,
            is_pooled,
        })
    }

    /// Uses the sum of the radii to find the contact more precisely, unless the tracks contradict
    /// this sum.
    fn use_radii(&mut self, radii: Option<f64>, points: [&[Point]; 2]) {
        let between = |state: &State| Some(state.centre(0).distance(state.centre(1)));
        let (Some(radii), Some(found)) = (radii, self.estimate(between)) else {
            return;
        };
        let sigma = found.uncertainty().hypot(RADII_SIGMA);
        let model = Model {
            apart: Some((radii, RADII_SIGMA)),
            ..self.model
        };
        let agrees = (found.value - radii).abs() <= CONTRADICTS * sigma;
        let better = agrees.then(|| Self::weighted(self.state, &model, self.weights, points));
        let better = better.flatten();
        let apart = Apart {
            found,
            radii,
            agrees: better.is_some(),
        };
        if let Some(better) = better {
            let test = self.test;
            *self = Self { test, ..better };
        }
        self.apart = Some(apart);
    }

    /// Whether the relative velocity changes clearly.
    fn is_collision(&self) -> bool {
        let relative = |state: &State, leg| state.velocity(0, leg) - state.velocity(1, leg);
        let change = |state: &State| relative(state, Leg::Before) - relative(state, Leg::After);
        let along = change(&self.state).normalize_or_zero();
        let change = self.estimate(|state| Some(change(state).dot(along)));
        change.is_some_and(|change| change.is_clear())
    }

    fn freedom(&self) -> f64 {
        self.freedom.iter().sum()
    }

    /// A quantity that follows from the state, with its uncertainty by linear propagation; `None`
    /// if it is not defined.
    pub(super) fn estimate(&self, of: impl Fn(&State) -> Option<f64>) -> Option<Estimate> {
        self.propagate(of, |difference| difference)
    }

    /// Like [`Self::estimate`], but for an angle in radians, which may wrap around at ±π.
    pub(super) fn estimate_angle(&self, of: impl Fn(&State) -> Option<f64>) -> Option<Estimate> {
        self.propagate(of, |difference| (difference + PI).rem_euclid(2.0 * PI) - PI)
    }

    fn propagate(
        &self,
        of: impl Fn(&State) -> Option<f64>,
        difference: impl Fn(f64) -> f64,
    ) -> Option<Estimate> {
        let value = of(&self.state).filter(|value| value.is_finite())?;
        let gradient = self.gradient(&of, &difference)?;
        let reach: Vector = self.covariance.map(|row| dot(&row, &gradient));
        let variance = dot(&gradient, &reach).max(0.0);
        let (mut spread, mut extra) = (0.0, 0.0);
        for group in self.groups() {
            let freedom: f64 = group.iter().map(|it| self.freedom[*it]).sum();
            let mut pull = [0.0; PARAMETERS];
            for channel in *group {
                let part = self.normal.times(*channel, &reach);
                for (sum, part) in pull.iter_mut().zip(part) {
                    *sum += self.weights[*channel] * part;
                }
            }
            // Welch and Satterthwaite: each share of the variance has its own degrees of freedom.
            let share = dot(&reach, &pull);
            spread += share * share / freedom;
            // Kenward and Roger (Biometrics 53, 983, 1997): weights that are themselves estimated
            // combine the channels less well than the true ones.
            let back = self.covariance.map(|row| dot(&row, &pull));
            extra += 4.0 * (share - dot(&pull, &back)).max(0.0) / freedom;
        }
        let most = self.freedom();
        let freedom = if spread > 0.0 {
            (variance * variance / spread).max(1.0)
        } else {
            most
        };
        Some(Estimate {
            value,
            deviation: (variance + extra).sqrt(),
            freedom,
        })
    }

    /// The channels that share an estimate of the noise.
    fn groups(&self) -> &'static [&'static [usize]] {
        match self.is_pooled {
            true => &[&[0, 2], &[1, 3]],
            false => &[&[0], &[1], &[2], &[3]],
        }
    }

    /// The probability that two quantities whose true values are zero are at least this far from
    /// zero.
    pub(super) fn chance_of_zero(&self, of: [&OfState; 2]) -> Option<f64> {
        let [a, b] = of.map(|of| self.estimate(of));
        let (a, b) = (a?, b?);
        let [first, second] = of.map(|of| self.gradient(&of, &|difference| difference));
        let (first, second) = (first?, second?);
        let reach: Vector = self.covariance.map(|row| dot(&row, &first));
        let both = dot(&second, &reach);
        let [va, vb] = [a, b].map(|it| it.deviation * it.deviation);
        let determinant = va * vb - both * both;
        let distance =
            vb * a.value * a.value - 2.0 * both * a.value * b.value + va * b.value * b.value;
        let freedom = a.freedom.min(b.freedom);
        (determinant > 0.0).then(|| beyond_f(0.5 * distance / determinant, 2.0, freedom))
    }

    fn gradient(
        &self,
        of: &impl Fn(&State) -> Option<f64>,
        difference: &impl Fn(f64) -> f64,
    ) -> Option<Vector> {
        let moved = |parameter: usize, by: f64| {
            let mut state = self.state;
            state.0[parameter] += by;
            of(&state)
        };
        let mut gradient = [0.0; PARAMETERS];
        for (i, slope) in gradient.iter_mut().enumerate() {
            let step = 0.1 * self.covariance[i][i].max(0.0).sqrt();
            if step > 0.0 {
                *slope = difference(moved(i, step)? - moved(i, -step)?) / (2.0 * step);
            }
        }
        Some(gradient)
    }

    /// The residual of a body's point, in x and y, as multiples of the noise.
    fn residual(&self, body: usize, point: &Point) -> DVec2 {
        let missed = point.at - self.state.at(body, point.t, &self.model);
        let noise = DVec2::from_slice(&self.noise[2 * body..]);
        point.weight.sqrt() * missed / noise
    }
}

/// A guess, and the same state with a slightly earlier and a slightly later time of contact.
/// From the guess alone, the fit could get stuck at a time of contact at which a row passes from
/// one leg to the other.
fn around(guess: &State, points: [&[Point]; 2]) -> [State; 3] {
    let times = || points.into_iter().flatten().map(|point| point.t);
    let first = times().fold(f64::MAX, f64::min);
    let last = times().fold(f64::MIN, f64::max);
    let step = (last - first) / points[0].len().max(2) as f64;
    [-1.0, 0.0, 1.0].map(|by| {
        let mut start = *guess;
        start.set_time(guess.time() + by * step);
        start
    })
}

/// Starting states for bodies that slow down: from a small deceleration to a stop well before
/// the last point.
fn slower(start: &State, model: &Model, points: [&[Point]; 2]) -> [State; 3] {
    let duration = |body: usize| {
        let last = points[body].last().map_or(0.0, |point| point.t);
        (last - start.time()).max(1e-9)
    };
    let slowed = |share: f64| {
        let mut state = *start;
        for body in (0..2).filter(|body| model.slows(*body)) {
            let moves_after = model.slows[body][1];
            let side = if moves_after { Leg::After } else { Leg::Before };
            let speed = start.velocity(body, side).length();
            let rate = share * speed / duration(body);
            // The body covers the same distance in the same time as in `start`, so its speed at
            // contact is `first` times its mean speed.
            let first = if share < 2.0 {
                1.0 + 0.5 * share
            } else {
                (2.0 * share).sqrt()
            };
            state.set_slowing(body, rate);
            if moves_after {
                state.set_velocity(body, Leg::After, first * start.velocity(body, Leg::After));
            }
        }
        state
    };
    [0.1, 1.0, 4.0].map(slowed)
}

/// The size of the region that the tracks cover, in metres.
fn extent(points: [&[Point]; 2]) -> f64 {
    let all = || points.into_iter().flatten().map(|point| point.at);
    let (low, high) = (all().reduce(DVec2::min), all().reduce(DVec2::max));
    low.zip(high).map_or(0.0, |(low, high)| low.distance(high))
}

/// How strongly neighbouring residuals are correlated (von Neumann's ratio, converted to a standard
/// normal variable). Bent paths, a third body, a cushion and smoothed tracking correlate them.
fn alike(fit: &TracksFit, points: [&[Point]; 2]) -> f64 {
    let (mut products, mut count) = (0.0, 0.0);
    for (body, points) in points.into_iter().enumerate() {
        for side in LEGS {
            let points = leg(points, fit.state.time(), side).iter();
            let residuals: Vec<_> = points.map(|point| fit.residual(body, point)).collect();
            for pair in residuals.windows(2) {
                let [a, b] = pair else { continue };
                products += a.dot(*b);
                count += 2.0;
            }
        }
    }
    // Fitting lines gives neighbours a slight negative correlation; adding a half per parameter
    // compensates for it.
    (products + PARAMETERS as f64 * 0.5) / f64::max(count, 1.0).sqrt()
}

/// The longer of the two bodies' gaps between points around the contact, and the median time
/// between points.
fn gap(tracks: &[Track; 2], time: f64) -> (f64, f64) {
    let mut longest = 0.0_f64;
    let mut steps = Vec::new();
    for track in tracks {
        let before = leg(&track.points, time, Leg::Before).last();
        let after = leg(&track.points, time, Leg::After).first();
        if let (Some(before), Some(after)) = (before, after) {
            longest = longest.max(after.t - before.t);
        }
        let pairs = track.points.windows(2);
        steps.extend(pairs.filter_map(|pair| Some(pair.last()?.t - pair.first()?.t)));
    }
    steps.sort_by(f64::total_cmp);
    (longest, steps.get(steps.len() / 2).copied().unwrap_or(0.0))
}
