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

/// Speeds below this part of the discs' own are rounding.
const ROUNDING: f64 = 1e-14;

/// Seconds from `now` until discs `i` and `k` meet, approaching, if they do so within
/// `end` seconds and neither changes its slide before.
pub(super) fn contact(bodies: &Bodies, i: usize, k: usize, now: f64, end: f64) -> Option<f64> {
    if !(bodies.moving[i] || bodies.moving[k]) {
        return None;
    }
    let (at_i, at_k) = (bodies.at(i, now), bodies.at(k, now));
    let (a_i, a_k) = (bodies.acceleration(i), bodies.acceleration(k));
    let reach = bodies.radius[i] + bodies.radius[k];
    let pair = Pair {
        d: at_k.position - at_i.position,
        w: at_k.velocity - at_i.velocity,
        a: a_k - a_i,
        reach,
    };
    let gap = pair.d.length_squared() - reach * reach;
    let parting = pair.d.dot(pair.w);
    let slides = a_i != DVec2::ZERO || a_k != DVec2::ZERO;
    let time = if gap <= 2.0 * reach * TOUCHING {
        let speed = parting / reach;
        if slides && speed.abs() <= SIDE_BY_SIDE {
            let distance = pair.d.length();
            let bottom = (distance - PRESS).max(reach - DEEPEST);
            let room = (distance - bottom) * (distance + bottom);
            if room > 0.0 {
                pair.curved(room, end)
            } else if parting < 0.0 {
                Some(0.0)
            } else {
                pair.after_touch(end)
            }
        } else if parting < 0.0 && gap <= 0.0 {
            let own = at_i.velocity.length() + at_k.velocity.length();
            (-speed > ROUNDING * own).then_some(0.0)
        } else if gap <= 0.0 {
            pair.after_touch(end)
        } else {
            pair.apart(gap, end)
        }
    } else if !bodies.moving[k] {
        glide(pair.d, at_i.velocity, a_i, reach, gap)
    } else if !bodies.moving[i] {
        glide(-pair.d, at_k.velocity, a_k, reach, gap)
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
            straight(self.d, self.w, self.reach, gap)
        } else {
            self.curved(gap, end)
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

/// Time until a moving disc meets one at rest: the path is straight, so the distance
/// along it comes from a triangle, and the time from s = v t − ½ a t².
///
/// `d` points from the mover to the other, `gap` is |d|² − reach².
fn glide(d: DVec2, v: DVec2, a: DVec2, reach: f64, gap: f64) -> Option<f64> {
    let ahead = d.dot(v);
    let speed2 = v.length_squared();
    if ahead <= 0.0 {
        return None;
    }
    // All lengths times the speed: no need to draw its root.
    let offset = d.perp_dot(v);
    let room = reach * reach * speed2 - offset * offset;
    if room <= 0.0 {
        return None;
    }
    slowed(gap / (ahead + room.sqrt()), -a.dot(v) / speed2)
}

/// Time until |d + w t| comes down to `reach`, at constant velocities.
fn straight(d: DVec2, w: DVec2, reach: f64, gap: f64) -> Option<f64> {
    glide(d, -w, DVec2::ZERO, reach, gap)
}
