//! Two particles past a nucleus, for worksheets.

use std::f64::consts::PI;

use glam::{DVec2, dvec2};

use super::{Anchor, Ink, Stroke, Svg};
use crate::numbers::degrees;
use crate::physics::rutherford::Rutherford;

/// Half the side of the picture, in its own units.
const HALF: f64 = 105.0;
/// What is left free around it for what is written at the ends of the ways.
const MARGIN: f64 = 26.0;
/// Straight pieces of a way.
const PIECES: u32 = 160;

/// Draws two particles that a nucleus turns by these angles in radians, 0 to π, one on
/// either side of it, each on its exact hyperbola with its angle beside it. They come
/// from the left; the scale is the same both ways.
#[must_use]
pub fn tracks_picture(rutherford: &Rutherford, angles: [f64; 2]) -> Svg {
    // Head-on, or not turned at all, has no place beside another one.
    let angles = angles.map(|angle| angle.clamp(0.01, PI));
    let offsets = angles.map(|angle| rutherford.impact_parameter(angle).unwrap_or(0.0));
    let widest = offsets[0].max(offsets[1]);
    let reach = (3.2 * widest).max(2.6 * rutherford.head_on_approach);
    let place = |at: DVec2| HALF / reach * dvec2(at.x, -at.y);
    let words = "Two particles pass a nucleus, each turned by an angle";
    let corner = DVec2::splat(HALF + MARGIN);
    let mut svg = Svg::new(words, 0.0, 0.0).framed(-corner, corner);
    let axis = Stroke::new(Ink::Faint);
    svg.line(dvec2(-HALF, 0.0), dvec2(HALF, 0.0), axis);
    let mut labels = Vec::new();
    for (i, side) in [1.0, -1.0].into_iter().enumerate() {
        let stroke = Stroke::new([Ink::Text, Ink::Accent][i]).wide(2.0);
        let points = rutherford.path(side * offsets[i]).points(reach, PIECES);
        let points: Vec<_> = points.into_iter().map(place).collect();
        if let [.., before, last] = points[..] {
            svg.polyline(points.iter().copied(), stroke);
            let way = (last - before).normalize_or_zero();
            svg.arrow(last - 14.0 * way, last, stroke);
        }
        // Where the straight ways in and out cross: the angle is measured there.
        let corner = dvec2(-rutherford.head_on_approach / 2.0, side * offsets[i]);
        let ahead = dvec2(
            (reach * reach - corner.y * corner.y).max(0.0).sqrt(),
            corner.y,
        );
        svg.line(place(corner), place(ahead), Stroke::new(Ink::Dim).dashed());
        let radius = 0.3 * HALF;
        let turned = side * angles[i];
        svg.arc(place(corner), radius, 0.0, turned, Stroke::new(Ink::Dim));
        let middle = DVec2::from_angle(turned / 2.0);
        // A narrow angle is told beyond the end of its way, where there is room.
        let out = if angles[i] < 0.4 {
            place(DVec2::from_angle(turned) * reach) + dvec2(0.0, -side * 12.0)
        } else {
            place(corner) + (radius + 20.0) * dvec2(middle.x, -middle.y)
        };
        labels.push((degrees(angles[i]), out));
    }
    svg.circle(DVec2::ZERO, 3.5, Some(Ink::Text), None);
    for (text, at) in labels {
        svg.label(&text, at, Anchor::Middle, Ink::Text);
    }
    svg.label("nucleus", dvec2(9.0, 0.0), Anchor::Start, Ink::Dim);
    svg
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_way_has_its_angle() {
        for angles in [[60.0, 120.0], [15.0, 90.0], [5.0, 10.0], [180.0, 0.0]] {
            let gold = Rutherford::radium_c_on_gold();
            let file = tracks_picture(&gold, angles.map(f64::to_radians)).file();
            assert!(!file.contains("NaN"));
            roxmltree::Document::parse(&file).unwrap();
            for angle in angles.into_iter().filter(|angle| *angle > 1.0) {
                assert!(file.contains(&format!(">{angle:.1}°<")), "{file}");
            }
        }
    }

    #[test]
    fn the_nucleus_is_tiny_and_the_ways_keep_away_from_it() {
        // 180° and 60°: the head-on particle turns at d, the other at (d/2)(1 + 1/sin 30°)
        // = 1.5 d; the picture reaches to 3.2 b = 3.2 · (d/2) cot 30° = 2.771 d.
        let gold = Rutherford::radium_c_on_gold();
        let file = tracks_picture(&gold, [PI, PI / 3.0]).file();
        let read = roxmltree::Document::parse(&file).unwrap();
        let ways: Vec<Vec<DVec2>> = read
            .descendants()
            .filter_map(|it| it.attribute("d"))
            .filter(|d| d.matches('L').count() > 100)
            .map(|d| {
                let points = d[1..].split('L');
                let point = |it: &str| {
                    let (x, y) = it.split_once(' ').unwrap();
                    dvec2(x.parse().unwrap(), y.parse().unwrap())
                };
                points.map(point).collect()
            })
            .collect();
        let scale = HALF / (3.2 * 0.5 * 3_f64.sqrt());
        for (way, nearest) in ways.iter().zip([1.0, 1.5]) {
            let found = way
                .iter()
                .map(|it| it.length())
                .fold(f64::INFINITY, f64::min);
            // Points stand every two units or closer; they are written to a hundredth.
            assert!((found - nearest * scale).abs() < 0.1, "{found}");
        }
        assert_eq!(ways.len(), 2);
    }
}
