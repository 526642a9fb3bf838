//! Finds the discs that a given disc could meet, by a quick test of every other disc, or of those
//! nearby if there is a grid. The test never rules out a disc that meets the given disc, but rules
//! out nearly all others. The given disc is called the seeker.
//!
//! The test has two stages, each of which handles two discs at a time: the first compares the boxes
//! of the discs, and the second compares the motion of the discs whose boxes overlap.

use glam::DVec2;
use wide::f64x2;

use super::super::Motion;
use super::body::Body;
use super::grid::Grid;
use super::lanes::{TwoVectors, of_both};
use super::schedule::SAME_TIME;
use super::work::Work;

/// How much wider a disc's box is than the disc, in metres: far more than the rounding errors.
const MARGIN: f64 = 1e-9;

/// The time limit, in seconds, for a slide that never ends. It is finite because 0 · ∞ would be
/// NaN.
const FOREVER: f64 = 1e100;

/// The number of boxes that are compared before the motion of their discs is compared: one per bit.
const AT_ONCE: usize = u64::BITS as usize;

/// The boxes of all discs, and the working memory of a scan for partners.
#[derive(Debug, Default, Clone)]
pub(super) struct BroadPhase {
    boxes: Vec<TwoBoxes>,
    around: Vec<usize>,
    partners: Vec<usize>,
}

impl BroadPhase {
    pub(super) fn begin(&mut self, discs: usize) {
        self.boxes.clear();
        self.boxes.resize(discs.div_ceil(2), TwoBoxes::NOWHERE);
        // There is room for two more partners than discs, because the last two candidates are
        // written even if they are ruled out.
        self.partners.resize(discs + 2, 0);
    }

    /// Stores the box of a disc, from a given time until the slide ends by itself. If an earlier
    /// contact is then forecast, the box is kept, because a new box would cost more than it saves.
    #[inline]
    pub(super) fn expect(&mut self, i: usize, body: &Body, from: f64, until: f64) {
        self.boxes[i / 2].set(i % 2, sides(body, from, until));
    }

    /// Finds the discs that the seeker could meet before its own forecast or the other disc's,
    /// whichever is earlier. Returns the number of these discs (see [`Self::partner`]), which are
    /// in the order of their indices or of the cells in the grid.
    #[inline]
    pub(super) fn find(&mut self, scan: &Scan, grid: &Grid, work: &mut Work) -> usize {
        let i = scan.disc;
        let limits = self.boxes[i / 2].limits(i % 2);
        let mut count = 0;
        if grid.is_laid() {
            grid.near(i, &mut self.around);
            work.add(self.around.len());
            for near in self.around.chunks(AT_ONCE) {
                let mut overlapping = 0;
                for (bit, &k) in near.iter().enumerate() {
                    let overlaps = self.boxes[k / 2].overlap(&limits) >> (k % 2) & 1;
                    overlapping |= (overlaps & u64::from(k != i)) << bit;
                }
                for seen in scan.have_looked {
                    for (bit, k) in near.iter().enumerate() {
                        overlapping &= !(u64::from(k == seen) << bit);
                    }
                }
                let partners = &mut self.partners[count..];
                count += Candidates(overlapping).sift(|bit| near[bit], scan, partners);
            }
        } else {
            work.add(scan.bodies.len());
            for (n, boxes) in self.boxes.chunks(AT_ONCE / 2).enumerate() {
                let mut overlapping = 0;
                for (pair, boxes) in boxes.iter().enumerate() {
                    overlapping |= boxes.overlap(&limits) << (2 * pair);
                }
                for k in scan.have_looked.iter().chain([&i]) {
                    overlapping &= !(u64::from(k / AT_ONCE == n) << (k % AT_ONCE));
                }
                let first = n * AT_ONCE;
                let partners = &mut self.partners[count..];
                count += Candidates(overlapping).sift(|bit| first + bit, scan, partners);
            }
        }
        count
    }

    /// The disc at position `n` in the result of the latest scan.
    #[inline]
    pub(super) fn partner(&self, n: usize) -> usize {
        self.partners[n]
    }
}

/// The input of a scan.
pub(super) struct Scan<'a> {
    pub(super) seeker: &'a Seeker,
    /// The seeker's index.
    pub(super) disc: usize,
    /// The discs to skip, because they have already been compared with the seeker.
    pub(super) have_looked: &'a [usize],
    pub(super) bodies: &'a [Body],
    /// The forecast times of all discs, padded to whole blocks.
    pub(super) times: &'a [f64],
}

/// The discs whose boxes overlap the seeker's box, with one bit for each disc.
struct Candidates(u64);

impl Candidates {
    /// Writes the discs that can meet the seeker and returns their number.
    ///
    /// Every disc is written; if it is ruled out, the next disc overwrites it. There is no branch,
    /// because a processor could not predict which discs are ruled out.
    #[inline(always)]
    fn sift(mut self, disc: impl Fn(usize) -> usize, scan: &Scan, partners: &mut [usize]) -> usize {
        let (seeker, bodies) = (scan.seeker, scan.bodies);
        let times = &scan.times[..bodies.len()];
        let mut count = 0;
        while let Some((one, other)) = self.next_two() {
            let (a, b) = (disc(one), disc(other));
            let missed = seeker.misses([&bodies[a], &bodies[b]], [times[a], times[b]]);
            partners[count] = a;
            count += usize::from(missed & 1 == 0);
            partners[count] = b;
            count += usize::from((missed & 2 == 0) & (one != other));
        }
        count
    }

    /// Removes and returns the next two candidates; if only one is left, returns it twice.
    #[inline(always)]
    fn next_two(&mut self) -> Option<(usize, usize)> {
        if self.0 == 0 {
            return None;
        }
        let one = self.0.trailing_zeros() as usize;
        self.0 &= self.0 - 1;
        let next = self.0.trailing_zeros() as usize;
        let other = if self.0 == 0 { one } else { next };
        self.0 &= self.0.wrapping_sub(1);
        Some((one, other))
    }
}

/// The boxes of two discs. A box is axis-aligned and contains everything that a disc can touch
/// between two moments of its slide.
///
/// Each box has four numbers: the smallest x and y, and the largest x and y with reversed signs, so
/// that all four can be compared in the same way.
#[derive(Debug, Clone, Copy)]
struct TwoBoxes([f64x2; 4]);

impl TwoBoxes {
    /// Boxes that overlap nothing.
    const NOWHERE: Self = Self([f64x2::new([f64::NAN; 2]); 4]);

    #[inline]
    fn set(&mut self, lane: usize, sides: [f64; 4]) {
        // Both lanes are written together, as they will be read together: reading a value that was
        // written in parts stalls the processor.
        let is_it = f64x2::splat(lane as f64).simd_eq(f64x2::new([0.0, 1.0]));
        let set = |at: usize| (is_it & f64x2::splat(sides[at])) | (!is_it & self.0[at]);
        self.0 = [set(0), set(1), set(2), set(3)];
    }

    /// The limits within which the sides of another box must lie if it overlaps this box.
    #[inline]
    fn limits(&self, lane: usize) -> [f64x2; 4] {
        let limit = |side: f64x2| f64x2::splat(-side.to_array()[lane]);
        let [left, bottom, right, top] = self.0;
        [limit(right), limit(top), limit(left), limit(bottom)]
    }

    /// Which of the two boxes overlap the box with these limits, with one bit for each box.
    #[inline(always)]
    fn overlap(&self, limits: &[f64x2; 4]) -> u64 {
        let [left, bottom, right, top] = self.0;
        let within = left.simd_le(limits[0])
            & bottom.simd_le(limits[1])
            & right.simd_le(limits[2])
            & top.simd_le(limits[3]);
        u64::from(within.to_bitmask())
    }
}

/// The box of a disc between two moments of its slide. The path is straight, so its two ends
/// determine the box.
#[inline]
fn sides(body: &Body, from: f64, until: f64) -> [f64; 4] {
    // Contacts slightly after the forecast are included. A path without an end is followed up to
    // the largest finite time.
    let until = (until + SAME_TIME).min(f64::MAX);
    let (a, b) = (body.at(from).position, body.at(until).position);
    let margin = body.radius + MARGIN;
    let (least, greatest) = (a.min(b) - margin, a.max(b) + margin);
    [least.x, least.y, -greatest.x, -greatest.y]
}

/// The current state of the seeker.
#[derive(Debug, Clone, Copy)]
pub(super) struct Seeker {
    pub(super) now: f64,
    /// The time of the seeker's own forecast: later contacts do not matter.
    until: f64,
    pub(super) here: Motion,
    pub(super) acceleration: DVec2,
    pub(super) radius: f64,
    pub(super) moving: bool,
}

impl Seeker {
    /// Prepares the search for a disc's contacts between `now` and `until`.
    #[inline]
    pub(super) fn new(body: &Body, now: f64, until: f64) -> Self {
        Self {
            now,
            until: until.min(FOREVER),
            here: body.at(now),
            acceleration: body.acceleration,
            radius: body.radius,
            moving: body.moving,
        }
    }

    /// Which of two other discs the seeker cannot meet before its own forecast or the other disc's
    /// forecast, at `times`, whichever is earlier. There is one bit for each disc.
    ///
    /// In the seeker's frame the other disc is at Δ(τ) = d + w τ + ½ a τ² for τ up to h. There is
    /// no contact if
    /// - it stays far away along d: contact needs d·Δ ≤ R |d| ≤ (R² + d²)/2, and d·Δ stays
    ///   above the least of its three Bernstein coefficients (as in
    ///   [`first_root`](super::quartic::first_root)); or
    /// - it stays to one side of w by more than R: Δ × w changes monotonically from its value at 0
    ///   to its value at h.
    #[inline(always)]
    fn misses(&self, others: [&Body; 2], times: [f64; 2]) -> u32 {
        let half = f64x2::splat(0.5);
        let elapsed = f64x2::splat(self.now) - of_both(others, |body| body.since);
        let position = TwoVectors::of_both(others, |body| body.start.position);
        let velocity = TwoVectors::of_both(others, |body| body.start.velocity);
        let acceleration = TwoVectors::of_both(others, |body| body.acceleration);

        let way = (velocity + acceleration * (half * elapsed)) * elapsed;
        let d = position + way - self.here.position;
        let w = velocity + acceleration * elapsed - self.here.velocity;
        let a = acceleration - self.acceleration;
        let contact_distance = of_both(others, |body| body.radius) + f64x2::splat(self.radius);
        let until = f64x2::new(times).fast_min(f64x2::splat(self.until));
        let h = until - f64x2::splat(self.now) + f64x2::splat(SAME_TIME);
        let half_h2 = half * h * h;
        let distance2 = contact_distance * contact_distance;

        let gap = half * (d.dot(d) - distance2);
        let closing = d.dot(w) * h;
        let bend = d.dot(a) * half_h2;
        let at_end = gap + closing + bend;
        let along = at_end.fast_min(gap + half * closing).fast_min(gap);

        let offset = d.perp_dot(w);
        let offset_end = offset + a.perp_dot(w) * half_h2;
        let one_side = (offset * offset_end).fast_min(offset_end * offset_end);
        let aside = one_side.fast_min(offset * offset) - distance2 * w.dot(w);

        along.fast_max(aside).simd_gt(f64x2::ZERO).to_bitmask()
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64;

    use super::super::contact::contact;
    use super::*;
    use crate::physics::Disc;

    /// The discs are scattered over a board, and every other disc is at rest. The numbers of discs
    /// include odd numbers and two that exceed the number of bits.
    #[test]
    fn no_disc_that_meets_the_seeker_is_ruled_out() {
        let mut rng = Pcg64::seed_from_u64(7);
        let (mut found, mut meetings) = (0, 0);
        for round in 0..400 {
            let count = [2, 5, 20, 63, 64, 65, 131][round % 7];
            let deceleration = [0.0, 1.2][round % 2];
            let disc = Disc::from_g_mm(5.5, 15.9);
            let side = 0.05 * f64::from(count).sqrt();
            let bodies: Vec<Body> = (0..count)
                .map(|k| {
                    let mut number = |most: f64| rng.random_range(-most..most);
                    let position = DVec2::new(number(side), number(side));
                    let speed = if k % 2 == 0 { number(3.0) } else { 0.0 };
                    let velocity = speed * DVec2::from_angle(number(3.0));
                    Body::new(&disc, Motion::new(position, velocity), deceleration)
                })
                .collect();
            let times: Vec<f64> = bodies
                .iter()
                .map(|body| {
                    let stops = 1.0 / body.relative_deceleration;
                    rng.random_range(0.01..0.3_f64).min(stops)
                })
                .collect();
            let mut broad_phase = BroadPhase::default();
            broad_phase.begin(bodies.len());
            for (k, body) in bodies.iter().enumerate() {
                broad_phase.expect(k, body, 0.0, times[k]);
            }
            for i in (0..bodies.len()).step_by(2) {
                let seeker = Seeker::new(&bodies[i], 0.0, times[i]);
                let mut work = Work::up_to(0);
                let grid = Grid::default();
                let scan = Scan {
                    seeker: &seeker,
                    disc: i,
                    have_looked: &[],
                    bodies: &bodies,
                    times: &times,
                };
                let partners = broad_phase.find(&scan, &grid, &mut work);
                let partners = &broad_phase.partners[..partners];
                assert!(partners.is_sorted() && !partners.contains(&i));
                found += partners.len();
                for k in (0..bodies.len()).filter(|&k| k != i) {
                    let until = times[i].min(times[k]) + SAME_TIME;
                    if contact(&seeker, &bodies[k], until).is_some() {
                        meetings += 1;
                        assert!(partners.contains(&k), "{i} meets {k} of {count}");
                    }
                }
            }
        }
        assert!(
            meetings > 10_000 && found < 3 * meetings,
            "{found} for {meetings}"
        );
    }
}
