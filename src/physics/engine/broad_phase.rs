//! Which discs could meet a given one at all: a quick look at every pair that never
//! turns away one that meets, and turns away nearly all others.

use glam::DVec2;

use super::super::Motion;
use super::bodies::Bodies;
use super::schedule::SAME_TIME;

/// The disc whose partners are sought, as it is now.
#[derive(Debug, Clone, Copy)]
pub(super) struct Seeker {
    now: f64,
    /// Its own forecast: later meetings do not matter.
    until: f64,
    here: Motion,
    acceleration: DVec2,
    radius: f64,
}

impl Bodies {
    /// Disc `i` as a seeker of meetings between `now` and `until`.
    pub(super) fn seeker(&self, i: usize, now: f64, until: f64) -> Seeker {
        Seeker {
            now,
            until,
            here: self.at(i, now),
            acceleration: self.acceleration(i),
            radius: self.radius[i],
        }
    }

    /// The clearances of all discs; `times` are their forecasts. Without branches over
    /// arrays, so that the compiler makes vector code of it.
    pub(super) fn clearances(&self, seeker: &Seeker, times: &[f64], clearances: &mut Vec<f64>) {
        let n = self.x.len();
        clearances.resize(n, 0.0);
        let (x, y) = (&self.x[..n], &self.y[..n]);
        let (vx, vy) = (&self.vx[..n], &self.vy[..n]);
        let (ax, ay) = (&self.ax[..n], &self.ay[..n]);
        let (since, radius) = (&self.since[..n], &self.radius[..n]);
        let (times, clearances) = (&times[..n], &mut clearances[..n]);
        for k in 0..n {
            let other = [
                x[k], y[k], vx[k], vy[k], ax[k], ay[k], since[k], radius[k], times[k],
            ];
            clearances[k] = seeker.clearance(other);
        }
    }

    /// The clearance of one disc with a forecast for `time`.
    pub(super) fn clearance(&self, seeker: &Seeker, k: usize, time: f64) -> f64 {
        seeker.clearance([
            self.x[k],
            self.y[k],
            self.vx[k],
            self.vy[k],
            self.ax[k],
            self.ay[k],
            self.since[k],
            self.radius[k],
            time,
        ])
    }
}

impl Seeker {
    /// A number that is positive only if the other cannot be met before the earlier of
    /// both forecasts.
    ///
    /// Seen from the seeker the other moves by Δ(τ) = d + w τ + ½ a τ² for τ up to h.
    /// There is no contact if
    /// - it stays far along d: contact needs d·Δ ≤ R |d| ≤ (R² + d²)/2, and d·Δ stays
    ///   above the least of its three Bernstein coefficients (as in
    ///   [`first_root`](super::quartic::first_root)); or
    /// - it stays to one side of w by more than R: Δ × w goes one way from its value
    ///   at 0 to its value at h.
    #[inline(always)]
    fn clearance(&self, [x, y, vx, vy, ax, ay, since, radius, time]: [f64; 9]) -> f64 {
        let Motion { position, velocity } = self.here;
        let t = self.now - since;
        let half = 0.5 * t;
        let dx = x + (vx + ax * half) * t - position.x;
        let dy = y + (vy + ay * half) * t - position.y;
        let wx = vx + ax * t - velocity.x;
        let wy = vy + ay * t - velocity.y;
        let (ax, ay) = (ax - self.acceleration.x, ay - self.acceleration.y);
        let contact_distance = radius + self.radius;
        let h = least(time, self.until) - self.now + SAME_TIME;
        let half_h2 = 0.5 * h * h;
        let distance2 = contact_distance * contact_distance;

        let gap = 0.5 * (dx * dx + dy * dy - distance2);
        let closing = (dx * wx + dy * wy) * h;
        let bend = (dx * ax + dy * ay) * half_h2;
        let along = least(least(gap + closing + bend, gap + 0.5 * closing), gap);

        let offset = dx * wy - dy * wx;
        let offset_end = offset + (ax * wy - ay * wx) * half_h2;
        let one_side = least(offset * offset_end, offset_end * offset_end);
        let aside = least(one_side, offset * offset) - distance2 * (wx * wx + wy * wy);

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
