//! The time of the next contact of two discs.

use glam::DVec2;

use super::super::slide::{slowed, time_to_distance};
use super::body::Body;
use super::broad_phase::Seeker;
use super::quartic::first_root;

/// The gap, in metres, below which two discs count as touching: far larger than the rounding error
/// after an impact, and far too small to see.
pub(super) const TOUCHING: f64 = 1e-13;

/// How far, in metres, a pair that slides in contact may overlap before this counts as another
/// impact. Discs that touch and decelerate differently can press against each other for a while;
/// strictly speaking, they would collide infinitely often.
pub(super) const PRESS: f64 = 3e-10;

/// If a touching pair decelerates and its approach is no faster than this (in m/s), the discs press
/// against each other or stop without an impact. This ends a series of ever smaller impacts.
const PRESSING_SPEED: f64 = 1e-6;

/// The largest overlap, in metres, that a pair can reach.
const DEEPEST: f64 = 9e-10;

/// An approach speed below this fraction of the discs' speeds is considered a rounding error.
const ROUNDING: f64 = 1e-14;

/// The time in seconds until the seeker and another disc meet while approaching each other; `None`
/// if they do not meet within `end` seconds. Neither disc may start a new slide before `end`.
#[inline]
pub(super) fn contact(a: &Seeker, b: &Body, end: f64) -> Option<f64> {
    let (at_a, at_b) = (a.here, b.at(a.now));
    let pair = Pair {
        d: at_b.position - at_a.position,
        w: at_b.velocity - at_a.velocity,
        a: b.acceleration - a.acceleration,
        contact_distance: a.radius + b.radius,
    };
    let gap = pair.d.length_squared() - pair.contact_distance * pair.contact_distance;
    let time = if gap <= 2.0 * pair.contact_distance * TOUCHING {
        let speed = at_a.velocity.length() + at_b.velocity.length();
        pair.touching(gap, speed, end)
    } else if !b.moving || !a.moving {
        // In the frame of the disc at rest, the other disc moves in a straight line.
        pair.straight(gap)
    } else {
        pair.apart(gap, end)
    };
    time.filter(|&t| t <= end)
}

/// Two discs in the frame of the first disc: Δ(t) = d + w t + ½ a t².
struct Pair {
    d: DVec2,
    w: DVec2,
    a: DVec2,
    /// The sum of the radii.
    contact_distance: f64,
}

impl Pair {
    /// The coefficients of |Δ(t)|² without the constant term.
    fn quartic(&self) -> [f64; 4] {
        [
            2.0 * self.d.dot(self.w),
            self.w.length_squared() + self.d.dot(self.a),
            self.w.dot(self.a),
            0.25 * self.a.length_squared(),
        ]
    }

    /// The contact of a pair with a gap between the discs: |d|² − R² = `gap` > 0, where R is the
    /// sum of the radii.
    fn apart(&self, gap: f64, end: f64) -> Option<f64> {
        if self.a == DVec2::ZERO {
            self.straight(gap)
        } else {
            self.curved(gap, end)
        }
    }

    /// The next contact of a pair that is in contact, apart from rounding errors. `speed` is the
    /// sum of the speeds of the discs.
    #[cold]
    fn touching(&self, gap: f64, speed: f64, end: f64) -> Option<f64> {
        let parting = self.d.dot(self.w) / self.contact_distance;
        let pressing = -(self.w.length_squared() + self.d.dot(self.a)) / self.contact_distance;
        // The first limit is √(½ PRESS · pressing). If a pair starts pressing from rest, its
        // approach speed is twice this limit when its overlap reaches PRESS. An impact at that
        // point separates the pair so fast that it no longer counts as gentle.
        let gentle = parting * parting <= 0.5 * PRESS * pressing || parting.abs() <= PRESSING_SPEED;
        let slides = self.a != DVec2::ZERO;
        if (gentle && slides) || parting.abs() <= ROUNDING * speed {
            let distance = self.d.length();
            let bottom = (distance - PRESS).max(self.contact_distance - DEEPEST);
            let room = (distance - bottom) * (distance + bottom);
            if !slides {
                return None;
            } else if room > 0.0 {
                return self.curved(room, end);
            }
        }
        if gap > 0.0 {
            self.apart(gap, end)
        } else if parting < 0.0 {
            Some(0.0)
        } else {
            self.after_touch(end)
        }
    }

    fn curved(&self, gap: f64, end: f64) -> Option<f64> {
        let [c1, c2, c3, c4] = self.quartic();
        first_root([gap, c1, c2, c3, c4], end)
    }

    /// The next contact of a pair that touches and separates: the root at zero is divided out, and
    /// the remaining cubic gives the time.
    fn after_touch(&self, end: f64) -> Option<f64> {
        let [c1, c2, c3, c4] = self.quartic();
        let parts = self.a != DVec2::ZERO && c1 > 0.0;
        parts.then(|| first_root([c1, c2, c3, c4, 0.0], end))?
    }

    /// The contact of a pair with a gap between the discs, if a is zero or opposite to w: the path
    /// is straight, so the distance follows from a triangle and the time from s = v t − ½ a t².
    fn straight(&self, gap: f64) -> Option<f64> {
        let time = time_to_distance(self.d, self.w, self.contact_distance, gap)?;
        slowed(time, -self.a.dot(self.w) / self.w.length_squared())
    }
}
