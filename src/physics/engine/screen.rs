//! Which discs could meet a given one at all: a quick look at every pair that never
//! turns away one that meets, and turns away nearly all others.

use super::bodies::Bodies;
use super::schedule::SAME_TIME;

impl Bodies {
    /// For every disc k a number that is positive only if i and k cannot meet between
    /// `now` and the earlier of their forecasts in `times`.
    ///
    /// Seen from i, k moves by Δ(τ) = d + w τ + ½ a τ² with τ up to h. There is no
    /// contact if
    /// - k stays far along d: contact needs d·Δ ≤ R |d| ≤ (R² + d²)/2, and d·Δ stays
    ///   above the least of its three Bézier coefficients; or
    /// - k stays to one side of w by more than R: Δ × w goes one way from its value
    ///   at 0 to its value at h.
    ///
    /// Written without branches over arrays, so that the compiler makes vector code.
    pub(super) fn screen(&self, i: usize, now: f64, times: &[f64], margins: &mut Vec<f64>) {
        let n = self.len();
        let me = self.at(i, now);
        let (my_x, my_y) = (me.position.x, me.position.y);
        let (my_vx, my_vy) = (me.velocity.x, me.velocity.y);
        let (my_ax, my_ay, my_radius) = (self.ax[i], self.ay[i], self.radius[i]);
        let my_time = times[i];
        margins.resize(n, 0.0);
        let (x, y) = (&self.x[..n], &self.y[..n]);
        let (vx, vy) = (&self.vx[..n], &self.vy[..n]);
        let (ax, ay) = (&self.ax[..n], &self.ay[..n]);
        let (since, radius) = (&self.since[..n], &self.radius[..n]);
        let (times, margins) = (&times[..n], &mut margins[..n]);
        for k in 0..n {
            let t = now - since[k];
            let half = 0.5 * t;
            let dx = x[k] + (vx[k] + ax[k] * half) * t - my_x;
            let dy = y[k] + (vy[k] + ay[k] * half) * t - my_y;
            let wx = vx[k] + ax[k] * t - my_vx;
            let wy = vy[k] + ay[k] * t - my_vy;
            let (ax, ay) = (ax[k] - my_ax, ay[k] - my_ay);
            let reach = radius[k] + my_radius;
            let h = least(times[k], my_time) - now + SAME_TIME;
            let half_h2 = 0.5 * h * h;
            let reach2 = reach * reach;

            let gap = 0.5 * (dx * dx + dy * dy - reach2);
            let closing = (dx * wx + dy * wy) * h;
            let bend = (dx * ax + dy * ay) * half_h2;
            let along = least(least(gap + closing + bend, gap + 0.5 * closing), gap);

            let offset = dx * wy - dy * wx;
            let offset_end = offset + (ax * wy - ay * wx) * half_h2;
            let one_side = least(offset * offset_end, offset_end * offset_end);
            let aside = least(one_side, offset * offset) - reach2 * (wx * wx + wy * wy);

            margins[k] = if along > aside { along } else { aside };
        }
    }
}

/// The lesser of two; `b` if `a` is no number. Without friction and horizon h is
/// infinite and the terms that bend the path come out as 0 · ∞: they must not count,
/// and standing first they do not.
fn least(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}
