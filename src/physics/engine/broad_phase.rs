//! Which discs could meet a given one at all: a quick look at every pair that never
//! turns away one that meets, and turns away nearly all others.
//!
//! It looks twice: at the boxes of all discs, and then, at those whose boxes overlap, by
//! how they move.

use glam::DVec2;

use super::super::Motion;
use super::body::Body;
use super::grid::Grid;
use super::schedule::SAME_TIME;
use super::work::Work;

/// How much wider than a disc its box is, in metres: far more than rounding takes away.
const MARGIN: f64 = 1e-9;

/// The boxes of all discs, and the working memory of the search for partners.
#[derive(Debug, Default, Clone)]
pub(super) struct BroadPhase {
    boxes: Vec<SweptBox>,
    around: Vec<usize>,
    overlapping: Vec<usize>,
    partners: Vec<usize>,
}

impl BroadPhase {
    pub(super) fn begin(&mut self, discs: usize) {
        self.boxes.resize(discs, SweptBox::default());
        self.overlapping.resize(discs, 0);
        self.partners.resize(discs, 0);
    }

    /// Takes down where a disc can be from a time until its slide ends by itself. A meeting
    /// may end it before: the box stays as it is, as a new one costs more than it saves.
    pub(super) fn expect(&mut self, i: usize, body: &Body, from: f64, until: f64) {
        self.boxes[i] = SweptBox::new(body, from, until);
    }

    /// Finds the discs that disc `i`, the seeker, could meet before either's forecast, of
    /// which `times` are the times, and returns how many: see [`Self::partner`].
    pub(super) fn search(
        &mut self,
        i: usize,
        seeker: &Seeker,
        bodies: &[Body],
        times: &[f64],
        grid: &Grid,
        work: &mut Work,
    ) -> usize {
        let own = self.boxes[i];
        let boxes = &self.boxes[..bodies.len()];
        let overlaps = |k: usize| (k != i) & boxes[k].overlaps(&own);
        let overlapping = if grid.is_laid() {
            grid.near(i, &mut self.around);
            work.add(self.around.len());
            sift(&mut self.overlapping, self.around.iter().copied(), overlaps)
        } else {
            work.add(bodies.len());
            sift(&mut self.overlapping, 0..bodies.len(), overlaps)
        };
        let overlapping = self.overlapping[..overlapping].iter().copied();
        let can_meet = |k: usize| seeker.clearance(&bodies[k], times[k]) <= 0.0;
        sift(&mut self.partners, overlapping, can_meet)
    }

    /// One of the discs found by the latest search.
    pub(super) fn partner(&self, n: usize) -> usize {
        self.partners[n]
    }
}

/// Writes down the candidates that pass and returns how many.
///
/// Each is written in any case, and the next one over it unless it passes: which of them
/// pass a processor cannot guess, and so there is no branch at which to guess.
#[inline(always)]
fn sift(
    passed: &mut [usize],
    candidates: impl Iterator<Item = usize>,
    passes: impl Fn(usize) -> bool,
) -> usize {
    let mut count = 0;
    for k in candidates {
        passed[count] = k;
        count += usize::from(passes(k));
    }
    count
}

/// A box, with its sides along the axes, around all that a disc can touch from one time of
/// its slide to another.
#[derive(Debug, Clone, Copy, Default)]
struct SweptBox {
    least: DVec2,
    greatest: DVec2,
}

impl SweptBox {
    /// As a disc goes straight, the two ends of its way span the box.
    fn new(body: &Body, from: f64, until: f64) -> Self {
        // Contacts are sought a little beyond the forecast. A way without end is followed
        // for the longest finite time: 0 · ∞ would be no place.
        let until = (until + SAME_TIME).min(f64::MAX);
        let (a, b) = (body.at(from).position, body.at(until).position);
        let margin = body.radius + MARGIN;
        Self {
            least: a.min(b) - margin,
            greatest: a.max(b) + margin,
        }
    }

    #[inline(always)]
    fn overlaps(&self, other: &Self) -> bool {
        (self.least.x <= other.greatest.x)
            & (self.least.y <= other.greatest.y)
            & (self.greatest.x >= other.least.x)
            & (self.greatest.y >= other.least.y)
    }
}

/// The disc whose partners are sought, as it is now.
#[derive(Debug, Clone, Copy)]
pub(super) struct Seeker {
    pub(super) now: f64,
    /// Its own forecast: later meetings do not matter.
    until: f64,
    pub(super) here: Motion,
    pub(super) acceleration: DVec2,
    pub(super) radius: f64,
    pub(super) moving: bool,
}

impl Seeker {
    /// A disc as a seeker of meetings between `now` and `until`.
    pub(super) fn new(body: &Body, now: f64, until: f64) -> Self {
        Self {
            now,
            until,
            here: body.at(now),
            acceleration: body.acceleration,
            radius: body.radius,
            moving: body.moving,
        }
    }

    /// A number that is positive only if another disc, with a forecast for `time`, cannot be
    /// met before the earlier of both forecasts.
    ///
    /// Seen from the seeker the other moves by Δ(τ) = d + w τ + ½ a τ² for τ up to h.
    /// There is no contact if
    /// - it stays far along d: contact needs d·Δ ≤ R |d| ≤ (R² + d²)/2, and d·Δ stays
    ///   above the least of its three Bernstein coefficients (as in
    ///   [`first_root`](super::quartic::first_root)); or
    /// - it stays to one side of w by more than R: Δ × w goes one way from its value
    ///   at 0 to its value at h.
    #[inline(always)]
    fn clearance(&self, other: &Body, time: f64) -> f64 {
        let Motion { position, velocity } = other.at(self.now);
        let d = position - self.here.position;
        let w = velocity - self.here.velocity;
        let a = other.acceleration - self.acceleration;
        let contact_distance = other.radius + self.radius;
        let h = least(time, self.until) - self.now + SAME_TIME;
        let half_h2 = 0.5 * h * h;
        let distance2 = contact_distance * contact_distance;

        let gap = 0.5 * (d.length_squared() - distance2);
        let closing = d.dot(w) * h;
        let bend = d.dot(a) * half_h2;
        let along = least(least(gap + closing + bend, gap + 0.5 * closing), gap);

        let offset = d.perp_dot(w);
        let offset_end = offset + a.perp_dot(w) * half_h2;
        let one_side = least(offset * offset_end, offset_end * offset_end);
        let aside = least(one_side, offset * offset) - distance2 * w.length_squared();

        if along > aside { along } else { aside }
    }
}

/// The lesser of two; `b` if `a` is no number. Without friction and horizon h is
/// infinite and the terms that bend the path come out as 0 · ∞: they must not count,
/// and standing first they do not.
#[inline(always)]
fn least(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}
