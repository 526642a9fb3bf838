//! When two discs next meet.

use glam::DVec2;

use super::super::slide::slowed;
use super::bodies::Bodies;
use super::quartic::first_root;

/// A gap in metres below which two discs count as touching: far above what rounding
/// leaves after an impact, far below anything that could be seen.
const TOUCHING: f64 = 1e-13;

/// A touching pair on a board with friction whose centres approach or part slower
/// than this (m/s) slides side by side.
const SIDE_BY_SIDE: f64 = 1e-5;

/// How far in metres a pair that slides side by side may be pressed into each other
/// before it counts as an impact. Without it a pair pressed together by the
/// difference of their decelerations would meet infinitely often.
const PRESS: f64 = 1e-10;

/// No pair may come deeper than this, in metres.
const DEEPEST: f64 = 9e-10;

/// Speeds of approach below this part of the discs' own are rounding.
const ROUNDING: f64 = 1e-14;

/// Seconds from `now` until discs `i` and `k` meet, approaching, if they do so within
/// `end` seconds and neither changes its slide before.
pub(super) fn contact(bodies: &Bodies, i: usize, k: usize, now: f64, end: f64) -> Option<f64> {
    let (at_i, at_k) = (bodies.at(i, now), bodies.at(k, now));
    let pair = Pair {
        d: at_k.position - at_i.position,
        w: at_k.velocity - at_i.velocity,
        a: bodies.acceleration(k) - bodies.acceleration(i),
        reach: bodies.radius[i] + bodies.radius[k],
    };
    let gap = pair.d.length_squared() - pair.reach * pair.reach;
    let time = if gap <= 2.0 * pair.reach * TOUCHING {
        let speed = at_i.velocity.length() + at_k.velocity.length();
        let slides = bodies.slowing[i] > 0.0 || bodies.slowing[k] > 0.0;
        pair.touching(gap, speed, slides, end)
    } else if !bodies.moving[k] || !bodies.moving[i] {
        // Seen from the one at rest, the other goes straight.
        straight(pair.d, pair.w, pair.a, pair.reach, gap)
    } else {
        pair.apart(gap, end)
    };
    time.filter(|&t| t <= end)
}

/// Two discs seen from the first: Δ(t) = d + w t + ½ a t².
struct Pair {
    d: DVec2,
    w: DVec2,
    a: DVec2,
    /// Sum of the radii.
    reach: f64,
}

impl Pair {
    /// The coefficients of |Δ(t)|² after the constant.
    fn quartic(&self) -> [f64; 4] {
        [
            2.0 * self.d.dot(self.w),
            self.w.length_squared() + self.d.dot(self.a),
            self.w.dot(self.a),
            0.25 * self.a.length_squared(),
        ]
    }

    /// A pair with room between them: |d|² − reach² = `gap` > 0.
    fn apart(&self, gap: f64, end: f64) -> Option<f64> {
        if self.a == DVec2::ZERO {
            straight(self.d, self.w, self.a, self.reach, gap)
        } else {
            self.curved(gap, end)
        }
    }

    /// A pair in contact but for rounding. `speed` is the sum of the discs' speeds,
    /// `slides` whether friction slows either.
    #[cold]
    fn touching(&self, gap: f64, speed: f64, slides: bool, end: f64) -> Option<f64> {
        let parting = self.d.dot(self.w) / self.reach;
        if slides && parting.abs() <= SIDE_BY_SIDE {
            let distance = self.d.length();
            let bottom = (distance - PRESS).max(self.reach - DEEPEST);
            let room = (distance - bottom) * (distance + bottom);
            if room > 0.0 {
                self.curved(room, end)
            } else if parting < 0.0 {
                Some(0.0)
            } else {
                self.after_touch(end)
            }
        } else if gap > 0.0 {
            self.apart(gap, end)
        } else if parting < 0.0 {
            (-parting > ROUNDING * speed).then_some(0.0)
        } else {
            self.after_touch(end)
        }
    }

    fn curved(&self, gap: f64, end: f64) -> Option<f64> {
        let [c1, c2, c3, c4] = self.quartic();
        first_root([gap, c1, c2, c3, c4], end)
    }

    /// A pair that touches and parts: the root at zero is divided out and what is
    /// left of the quartic, a cubic, says when they meet again.
    fn after_touch(&self, end: f64) -> Option<f64> {
        if self.a == DVec2::ZERO {
            return None;
        }
        let [c1, c2, c3, c4] = self.quartic();
        if c1 > 0.0 {
            first_root([c1, c2, c3, c4, 0.0], end)
        } else {
            None
        }
    }
}

/// Time until d + w t + ½ a t² comes down to the length `reach`, if a is against w or
/// zero: the path is straight, so the way to go comes from a triangle and the time
/// from s = v t − ½ a t². `gap` is |d|² − reach² > 0.
fn straight(d: DVec2, w: DVec2, a: DVec2, reach: f64, gap: f64) -> Option<f64> {
    let ahead = -d.dot(w);
    if ahead <= 0.0 {
        return None;
    }
    // All lengths times the speed: no need to draw its root.
    let speed2 = w.length_squared();
    let offset = d.perp_dot(w);
    let room = reach * reach * speed2 - offset * offset;
    if room <= 0.0 {
        return None;
    }
    slowed(gap / (ahead + room.sqrt()), -a.dot(w) / speed2)
}
