//! The triangle of momenta, in the corner of the picture that is most free.

use glam::DVec2;

use super::stage::Stage;
use crate::widgets::Role;
use crate::widgets::ink::{Sheet, Side};

/// Width and height of the inset as a share of the picture.
const SHARE: DVec2 = DVec2::new(0.26, 0.30);

/// Draws total = p₁ + p₂, tail to tip, in the corner furthest from `busy`, the
/// directions in which something is drawn. Momenta are in kg·m/s.
pub(super) fn triangle(sheet: &mut Sheet, stage: &Stage, p1: DVec2, p2: DVec2, busy: &[DVec2]) {
    let total = p1 + p2;
    let points = [DVec2::ZERO, p1, total];
    let low = points.into_iter().fold(DVec2::INFINITY, DVec2::min);
    let high = points.into_iter().fold(DVec2::NEG_INFINITY, DVec2::max);
    let half = stage.half_extent();
    let size = 2.0 * SHARE * half;
    let spread = high - low;
    let scale = (size.x / spread.x).min(size.y / spread.y);
    if !scale.is_finite() || scale <= 0.0 {
        return;
    }
    let corner = freest_corner(half, busy);
    let middle = corner * (half - size / 2.0);
    let place = |p: DVec2| middle + scale * (p - (low + high) / 2.0);
    let [tail, joint, tip] = points.map(place);
    sheet.line(tail, tip, Role::Incoming);
    sheet.line(tail, joint, Role::StrikerOut);
    sheet.line(joint, tip, Role::CoinOut);
    if p1.length() > 0.05 * total.length() && p2.length() > 0.05 * total.length() {
        let side = 0.16 * p1.length().min(p2.length()) * scale;
        if p1.normalize().dot(p2.normalize()).abs() < 1e-9 && side > 1.2 * stage.view.per_column() {
            sheet.square_corner(joint, tail - joint, tip - joint, side, Role::SquareCorner);
        }
    }
    // The name goes below the base, where no side of the triangle is.
    let below = [tail, joint, tip]
        .into_iter()
        .fold(f64::INFINITY, |y, p| y.min(p.y));
    let caption = DVec2::new(middle.x, below);
    sheet.label(
        "p = p₁ + p₂",
        caption,
        &[Side::Below, Side::Above],
        Role::Dim,
    );
}

/// The corner, as signs of x and y, that keeps furthest from all busy directions.
fn freest_corner(half: DVec2, busy: &[DVec2]) -> DVec2 {
    let corners = [
        DVec2::new(-1.0, 1.0),
        DVec2::new(-1.0, -1.0),
        DVec2::new(1.0, 1.0),
        DVec2::new(1.0, -1.0),
    ];
    let crowding = |corner: &DVec2| {
        let direction = (corner * half).normalize();
        busy.iter()
            .filter_map(|b| b.try_normalize())
            .map(|b| b.dot(direction))
            .fold(-1.0, f64::max)
    };
    corners
        .into_iter()
        .min_by(|a, b| crowding(a).total_cmp(&crowding(b)))
        .unwrap_or(DVec2::NEG_ONE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_corner_away_from_everything_is_taken() {
        let half = DVec2::new(4.0, 3.0);
        let busy = [DVec2::new(1.0, 1.0), DVec2::new(1.0, -0.5), DVec2::NEG_X];
        let corner = freest_corner(half, &busy);
        assert!(corner.x < 0.0);
        let busy = [
            DVec2::new(-1.0, 0.4),
            DVec2::new(1.0, 1.0),
            DVec2::new(1.0, -1.0),
        ];
        assert_eq!(freest_corner(half, &busy), DVec2::new(-1.0, -1.0));
    }
}
