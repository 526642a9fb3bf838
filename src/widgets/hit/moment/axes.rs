//! The line of impact and the tangent, the masses and the impact angle.

use glam::DVec2;

use super::Moment;
use crate::numbers::significant;
use crate::physics::units::g_from_kg;
use crate::widgets::Role;
use crate::widgets::hit::sketch::Sketch;

impl Moment<'_> {
    /// Draws the tangent and the line of impact; if `outside` is set, only the part of the line
    /// outside the discs.
    pub(super) fn axes(&self, sketch: &mut Sketch, outside: bool, n: DVec2, t: DVec2) {
        let unit = self.stage.unit();
        let ends = [
            self.stage.centres[0] - 1.5 * unit * n,
            self.stage.centres[1] + 1.5 * unit * n,
        ];
        let pen = self.pen(Role::LineOfImpact).dashed();
        if outside {
            // The arrows inside the discs must stay readable.
            for (body, end) in ends.into_iter().enumerate() {
                let centre = self.stage.centres[body];
                let rim = centre + self.stage.radius(body) * (end - centre).normalize_or_zero();
                sketch.picture.line(rim, end, pen);
            }
        } else {
            sketch.picture.line(ends[0], ends[1], pen);
        }
        let top = 1.7 * unit * t;
        let pen = self.pen(Role::TangentLine).dotted();
        sketch.picture.line(-top, top, pen);
        sketch.label("n", ends[0], -n, Role::LineOfImpact);
        sketch.label("t", top, t, Role::TangentLine);
    }

    /// Draws the masses, and the angle between the striker's path and the line of impact.
    pub(super) fn measures(&self, sketch: &mut Sketch) {
        let [c1, c2] = self.stage.centres;
        let apart = (c2 - c1).normalize_or(DVec2::X);
        let collision = &self.stage.collision;
        if let Some(alpha) = collision.alpha() {
            let end = c2 + 1.5 * self.stage.unit() * apart;
            let text = format!("α = {:.1}°", alpha.to_degrees().abs());
            sketch.label(text, end, apart, Role::LineOfImpact);
        }
        for (disc, out) in [(collision.striker, -apart), (collision.target, apart)] {
            let body = usize::from(out == apart);
            let rim = self.stage.centres[body] + disc.radius * out;
            let text = format!("{} g", significant(g_from_kg(disc.mass)));
            sketch.label(text, rim, out, Role::Text);
        }
    }
}
