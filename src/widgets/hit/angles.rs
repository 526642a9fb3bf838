//! Arcs of the scattering and the recoil angle, and the square corner.

use glam::DVec2;

use super::stage::Stage;
use crate::widgets::ink::{Pen, Sheet};

/// Radius of an arc, in radii of its disc.
const ARC: f64 = 1.55;
/// An angle this near 90° is square, in radians.
const SQUARE: f64 = 1e-9;

/// The arc from the striker's direction to `v`, round the centre of `body`, with
/// the line it is measured from. Gives the middle of the arc, for its label.
pub(super) fn arc(
    sheet: &mut Sheet,
    stage: &Stage,
    body: usize,
    v: DVec2,
    pen: Pen,
) -> Option<DVec2> {
    let heading = stage.heading();
    let direction = v.try_normalize()?;
    let turn = heading.angle_to(direction);
    if turn.abs() < 1e-6 {
        return None;
    }
    let centre = stage.centres[body];
    let radius = ARC * stage.radius(body);
    let start = heading.to_angle();
    sheet.line(
        centre + stage.radius(body) * heading,
        centre + 1.25 * radius * heading,
        pen.dotted(),
    );
    sheet.arc(centre, radius, start, start + turn, pen);
    Some(centre + radius * DVec2::from_angle(start + turn / 2.0))
}

/// The square corner between two departures, at the striker's centre: both lines
/// pass through it, the one along the tangent, the other along the line of impact.
pub(super) fn square_corner(sheet: &mut Sheet, stage: &Stage, v1: DVec2, v2: DVec2, pen: Pen) {
    if let (Some(a), Some(b)) = (v1.try_normalize(), v2.try_normalize())
        && a.dot(b).abs() <= SQUARE
    {
        let size = 0.42 * stage.radius(0);
        sheet.square_corner(stage.centres[0], a, b, size, pen);
    }
}
