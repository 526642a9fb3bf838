//! Finds the contact, and rows in which the two tracks have been exchanged.

use glam::{DVec2, dvec2};

use super::Fault;
use super::model::State;
use super::track::{Leg, Point, Track};
use crate::numbers::counted;

/// The minimum number of points of each body on each side of the contact: a straight line requires
/// two, and an estimate of the noise one more.
pub(super) const FEWEST: usize = 3;

/// Refuses tracks whose bodies change places from one row to the next.
pub(super) fn refuse_exchanged(tracks: &[Track; 2]) -> Result<(), Fault> {
    /// Exchanged tracks jump by the distance between the centres; genuine ones move much less.
    const MUCH_SHORTER: f64 = 0.5;
    let both = together(tracks);
    let mut swaps = both.windows(2).filter_map(|pair| {
        let [(a1, a2), (b1, b2)] = pair else {
            return None;
        };
        let kept = a1.at.distance(b1.at) + a2.at.distance(b2.at);
        let exchanged = a1.at.distance(b2.at) + a2.at.distance(b1.at);
        // Between distant rows, one body may have moved to where the other was.
        (exchanged < MUCH_SHORTER * kept && b1.line - a1.line <= 2).then_some(b1.line)
    });
    match swaps.next() {
        None => Ok(()),
        Some(line) => Err(Fault::on(
            line,
            format!(
                "expected {} to continue its path, found it where {} was and vice versa: the \
                 tracks are exchanged from this row on",
                tracks[0].name, tracks[1].name
            ),
        )),
    }
}

/// The points of both bodies in the rows that contain both.
fn together(tracks: &[Track; 2]) -> Vec<(Point, Point)> {
    let mut second = tracks[1].points.iter().peekable();
    let mut both = Vec::new();
    for first in &tracks[0].points {
        while second.next_if(|it| it.t < first.t).is_some() {}
        if let Some(same) = second.next_if(|it| it.t <= first.t) {
            both.push((*first, *same));
        }
    }
    both
}

/// Up to two guesses at the collision: where two straight lines per body fit best, and where the
/// bodies are nearest to each other (which finds the collision even if the bodies slow down a lot).
///
/// # Errors
/// Returns an error if no guess has enough points of each body on both sides.
pub(super) fn guesses(tracks: &[Track; 2]) -> Result<Vec<State>, Fault> {
    for track in tracks {
        let count = track.points.len();
        if count < 2 * FEWEST {
            return Err(Fault::new(format!(
                "expected at least {FEWEST} points of {} before the contact and {FEWEST} after it, \
                 found {}",
                track.name,
                counted(count, "point")
            )));
        }
    }
    let sums = tracks.each_ref().map(|track| Sums::of(&track.points));
    let mut times: Vec<f64> = { sums.iter().flat_map(|it| &it.times) }.copied().collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    let splits = times.windows(2).filter_map(|pair| {
        let time = 0.5 * (pair.first()? + pair.last()?);
        let costs = sums.each_ref().map(|sums| sums.cost(time));
        Some((time, costs[0]? + costs[1]?))
    });
    let best = splits.min_by(|a, b| a.1.total_cmp(&b.1));
    let both = together(tracks);
    let nearest = both.iter().min_by(|(a1, a2), (b1, b2)| {
        let distance = |a: &Point, b: &Point| a.at.distance_squared(b.at);
        distance(a1, a2).total_cmp(&distance(b1, b2))
    });
    let nearest = nearest.map(|it| it.0.t);
    let state = |time: f64| {
        let [first, second] = sums.each_ref().map(|sums| sums.legs(time));
        let ([c1, u1, v1], [c2, u2, v2]) = (first?, second?);
        Some(State::new(time, [c1, c2], [[u1, v1], [u2, v2]], [0.0; 2]))
    };
    let times = [best.map(|it| it.0), nearest].into_iter().flatten();
    let states: Vec<_> = times.filter_map(state).collect();
    match states.is_empty() {
        false => Ok(states),
        true => Err(refusal(tracks, nearest)),
    }
}

/// Why there is no contact with enough points on both sides.
fn refusal(tracks: &[Track; 2], nearest: Option<f64>) -> Fault {
    let Some(time) = nearest else {
        return Fault::new("expected rows with a point of each body, found none");
    };
    let few = tracks.iter().find_map(|track| {
        let before = track.points.iter().filter(|point| point.t < time).count();
        let after = track.points.len() - before;
        let (count, side) = if before < after {
            (before, "before")
        } else {
            (after, "after")
        };
        (count < FEWEST).then(|| {
            format!(
                "expected at least {FEWEST} points of {} {side} the contact, found {count}",
                track.name
            )
        })
    });
    Fault::new(few.unwrap_or_else(|| "expected a contact with points on both sides".into()))
}

/// The maximum number of points among which the contact is sought; in longer tracks, some points
/// are skipped.
const SOUGHT: usize = 20_000;

/// Running sums over the points of a track, from which the straight line through the points before
/// or after any time follows at once.
struct Sums {
    times: Vec<f64>,
    origin: (f64, DVec2),
    /// The sums of 1, t, t², x, y, xt, yt and x² + y².
    sums: Vec<[f64; 8]>,
}

impl Sums {
    fn of(points: &[Point]) -> Self {
        let step = points.len().div_ceil(SOUGHT).max(1);
        let middle = points.get(points.len() / 2);
        let origin = middle.map_or((0.0, DVec2::ZERO), |point| (point.t, point.at));
        let (mut times, mut sums) = (Vec::new(), vec![[0.0; 8]]);
        let mut total = [0.0; 8];
        for point in points.iter().step_by(step) {
            let (t, at) = (point.t - origin.0, point.at - origin.1);
            let terms = [
                1.0,
                t,
                t * t,
                at.x,
                at.y,
                at.x * t,
                at.y * t,
                at.length_squared(),
            ];
            for (sum, term) in total.iter_mut().zip(terms) {
                *sum += term;
            }
            times.push(point.t);
            sums.push(total);
        }
        Self {
            times,
            origin,
            sums,
        }
    }

    /// The sums over both legs of a contact at `time`, if both legs have enough points.
    fn split(&self, time: f64) -> Option<[[f64; 8]; 2]> {
        let before = self.times.partition_point(|t| *t < time);
        let (sums, all) = (self.sums.get(before)?, self.sums.last()?);
        let rest = std::array::from_fn(|i| all[i] - sums[i]);
        (before >= FEWEST && self.times.len() - before >= FEWEST).then_some([*sums, rest])
    }

    /// The sum of the squared distances of the points from two straight lines, one fitted to each
    /// leg.
    fn cost(&self, time: f64) -> Option<f64> {
        let cost = |sums: &[f64; 8]| {
            let [n, t, tt, x, y, xt, yt, rr] = *sums;
            let spread = tt - t * t / n;
            let (xt, yt) = (xt - x * t / n, yt - y * t / n);
            rr - (x * x + y * y) / n - (xt * xt + yt * yt) / spread
        };
        let [before, after] = self.split(time)?;
        Some(cost(&before).max(0.0) + cost(&after).max(0.0))
    }

    /// The centre at `time` and both velocities.
    fn legs(&self, time: f64) -> Option<[DVec2; 3]> {
        let since = time - self.origin.0;
        let line = |sums: &[f64; 8]| {
            let [n, t, tt, x, y, xt, yt, _] = *sums;
            let spread = tt - t * t / n;
            let velocity = dvec2(xt - x * t / n, yt - y * t / n) / spread;
            (dvec2(x, y) / n + velocity * (since - t / n), velocity)
        };
        let [before, after] = self.split(time)?;
        let ((c, u), (d, v)) = (line(&before), line(&after));
        Some([0.5 * (c + d) + self.origin.1, u, v])
    }
}

/// The points of a body on one side of a time.
pub(super) fn leg(points: &[Point], time: f64, leg: Leg) -> &[Point] {
    let (before, after) = points.split_at(points.partition_point(|point| point.t < time));
    match leg {
        Leg::Before => before,
        Leg::After => after,
    }
}
