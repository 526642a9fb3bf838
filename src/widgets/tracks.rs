//! Pictures of particles' paths past a nucleus.

use std::f64::consts::PI;

use glam::{DVec2, dvec2};
use ratatui::layout::Rect;

use super::Role;
use super::picture::{LabelSide, Pen, Picture, View};
use crate::numbers::degrees;
use crate::physics::rutherford::Rutherford;

/// The number of straight pieces of a path.
const PIECES: u32 = 160;

/// The length of the arrow at the point where a path leaves the picture, in columns.
const ARROW: f64 = 5.0;

/// Draws a path, with an arrow where the path leaves the picture; returns the tip and the direction
/// of the arrow, if the path is visible.
pub(crate) fn draw_way(
    picture: &mut Picture,
    points: &[DVec2],
    pen: Pen,
) -> Option<(DVec2, DVec2)> {
    picture.curve(points.iter().copied(), pen);
    let view = *picture.view();
    // Each straight piece is divided into small steps, because it may be long.
    let steps = points.windows(2).flat_map(|pair| {
        let (from, to) = (pair[0], pair[1]);
        (0..=200).map(move |i| from.lerp(to, f64::from(i) / 200.0))
    });
    let steps: Vec<_> = steps.collect();
    let last = steps.iter().rposition(|at| view.cell_at(*at).is_some())?;
    let (tip, length) = (steps[last], ARROW * view.per_column());
    let mut before = steps[..last].iter().rev();
    let tail = *before.find(|at| at.distance(tip) >= length)?;
    picture.arrow(tail, tip, pen);
    Some((tip, (tip - tail).normalize_or_zero()))
}

/// Two particles that a nucleus deflects by these angles in radians, one on each side of the
/// nucleus. Each follows its exact hyperbola, with the angle beside it.
pub(crate) fn tracks_picture(area: Rect, rutherford: &Rutherford, angles: [f64; 2]) -> Picture {
    // A particle that is not deflected cannot be drawn, because its offset is infinite.
    let angles = angles.map(|angle| angle.clamp(0.01, PI));
    let offsets = angles.map(|angle| rutherford.impact_parameter(angle).unwrap_or(0.0));
    let widest = offsets[0].max(offsets[1]);
    let half = (1.9 * widest).max(1.6 * rutherford.head_on_approach);
    let view = View::fit(area, dvec2(-half, -half), dvec2(half, half));
    let mut picture = Picture::new(view);
    // The paths reach the corners of the picture, whatever its width.
    let right = view.to_world(dvec2(f64::from(area.right()), 0.0)).x;
    let reach = 1.2 * right.hypot(half);
    let axis = Pen::new(Role::Axis).dotted();
    picture.line(dvec2(-reach, 0.0), dvec2(reach, 0.0), axis);
    picture.disc(DVec2::ZERO, 1e-3 * half, Role::Marble, ' ');
    let beside = [LabelSide::Right, LabelSide::BelowRight];
    picture.label("nucleus", DVec2::ZERO, &beside, Role::Dim);
    let roles = [Role::StrikerOut, Role::CoinOut];
    for (i, side) in [1.0, -1.0].into_iter().enumerate() {
        let offset = side * offsets[i];
        let points = rutherford.path(offset).points(reach, PIECES);
        // The angle is measured where the straight lines along the initial and the final path
        // cross.
        let corner = dvec2(-rutherford.head_on_approach / 2.0, offset);
        let aim = Pen::new(Role::Aim).dashed();
        picture.line(corner, dvec2(reach, offset), aim);
        let turned = side * angles[i];
        let out = corner + 2.0 * reach * DVec2::from_angle(turned);
        picture.line(corner, out, Pen::new(Role::Dim).dotted());
        let radius = 0.3 * half;
        picture.arc(corner, radius, 0.0, turned, Role::Arc);
        let way = draw_way(&mut picture, &points, Pen::new(roles[i]).bold());
        let middle = DVec2::from_angle(turned / 2.0);
        let (anchor, towards) = match way {
            // A small angle is labelled at the end of its path.
            Some((tip, direction)) if angles[i] < 0.4 => (tip, direction),
            _ => (corner + radius * middle, middle),
        };
        let text = degrees(angles[i]);
        picture.label(&text, anchor, &LabelSide::towards(towards), roles[i]);
    }
    picture
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::widgets::picture::Mark;

    #[test]
    fn the_nucleus_is_tiny_and_the_paths_stay_away_from_it() {
        // The angles are 180° and 60°: the head-on particle turns back at the distance d, and the
        // other particle is closest at (d/2)(1 + 1/sin 30°) = 1.5 d.
        let gold = Rutherford::radium_c_on_gold();
        let area = Rect::new(0, 0, 44, 18);
        let picture = tracks_picture(area, &gold, [PI, PI / 3.0]);
        let ways = picture.marks.iter().filter_map(|mark| match mark {
            Mark::Curve { points, .. } => Some(points),
            _ => None,
        });
        let nearest = ways.map(|points| {
            let distances = points.iter().map(|at| at.length());
            distances.fold(f64::INFINITY, f64::min) / gold.head_on_approach
        });
        let nearest: Vec<_> = nearest.collect();
        assert_eq!(nearest.len(), 2);
        for (found, expected) in nearest.into_iter().zip([1.0, 1.5]) {
            assert!((found - expected).abs() < 0.01, "{found}");
        }
    }
}
