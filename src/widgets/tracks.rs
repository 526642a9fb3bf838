//! Ways of particles past a nucleus, in the picture's own units of length.

use std::f64::consts::PI;

use glam::{DVec2, dvec2};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::ink::{Pen, Sheet, Side, View};
use super::{Look, Role};
use crate::numbers::degrees;
use crate::physics::rutherford::Rutherford;

/// Straight pieces of a way.
const PIECES: u32 = 160;

/// Draws a way and the head of an arrow where it leaves the picture; gives the tip of
/// that and its direction, if the way is seen at all.
pub fn draw_way(sheet: &mut Sheet, points: &[DVec2], pen: Pen) -> Option<(DVec2, DVec2)> {
    sheet.polyline(points.iter().copied(), pen);
    let view = *sheet.view();
    let (from, tip) = exit(points, |at| view.cell_at(*at).is_some())?;
    let direction = (tip - from).normalize_or_zero();
    sheet.arrow(tip - direction * 6.0 * view.per_column(), tip, pen);
    Some((tip, direction))
}

/// The last piece of a way that is shown: where it comes from, and its last point shown.
fn exit(points: &[DVec2], shown: impl Fn(&DVec2) -> bool) -> Option<(DVec2, DVec2)> {
    // Long straight pieces are gone along in small steps.
    let steps = points.windows(2).flat_map(|pair| {
        let (from, to) = (pair[0], pair[1]);
        (0..200).map(move |i| (from, from.lerp(to, f64::from(i + 1) / 200.0)))
    });
    steps.filter(|(_, at)| shown(at)).last()
}

/// Draws two particles that a nucleus turns by these angles in radians, one on either
/// side, each on its exact hyperbola, with the angles written beside.
pub fn draw_tracks(
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
    rutherford: &Rutherford,
    angles: [f64; 2],
) {
    // Head-on, or not turned at all, has no place beside another one.
    let angles = angles.map(|angle| angle.clamp(0.01, PI));
    let offsets = angles.map(|angle| rutherford.impact_parameter(angle).unwrap_or(0.0));
    let widest = offsets[0].max(offsets[1]);
    let half = (1.9 * widest).max(1.6 * rutherford.head_on_approach);
    let view = View::fit(area, dvec2(-half, -half), dvec2(half, half));
    let mut sheet = Sheet::new(view, look.charset);
    // To the corners of the picture, however wide it is.
    let reach = 1.2
        * view
            .to_world(dvec2(f64::from(area.right()), 0.0))
            .x
            .hypot(half);
    let axis = Pen::new(Role::Axis).dotted();
    sheet.line(dvec2(-reach, 0.0), dvec2(reach, 0.0), axis);
    sheet.disc(DVec2::ZERO, 1e-3 * half, Role::Marble, ' ');
    sheet.label(
        "nucleus",
        DVec2::ZERO,
        &[Side::Right, Side::BelowRight],
        Role::Dim,
    );
    let roles = [Role::StrikerOut, Role::CoinOut];
    for (i, side) in [1.0, -1.0].into_iter().enumerate() {
        let offset = side * offsets[i];
        let points = rutherford.path(offset).points(reach, PIECES);
        // Where the straight ways in and out cross: the angle is measured there.
        let corner = dvec2(-rutherford.head_on_approach / 2.0, offset);
        let aim = Pen::new(Role::Aim).dashed();
        sheet.line(corner, dvec2(reach, offset), aim);
        let turned = side * angles[i];
        let radius = 0.3 * half;
        sheet.arc(corner, radius, 0.0, turned, Role::Arc);
        let way = draw_way(&mut sheet, &points, Pen::new(roles[i]).bold());
        let middle = DVec2::from_angle(turned / 2.0);
        let (anchor, towards) = match way {
            // A narrow angle is told at the end of its way.
            Some((tip, direction)) if angles[i] < 0.4 => (tip, direction),
            _ => (corner + radius * middle, middle),
        };
        let text = degrees(angles[i]);
        sheet.label(&text, anchor, &Side::towards(towards), roles[i]);
    }
    sheet.draw(buf, &look.theme);
}
