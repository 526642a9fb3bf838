//! α particles thrown past an atom's charge: exact hyperbolas.

use std::f64::consts::PI;

use glam::DVec2;
use ratatui::layout::Rect;

use crate::physics::rutherford::{FM, Rutherford};
use crate::widgets::Role;
use crate::widgets::picture::{LabelSide, Pen, Picture, View};

/// Offsets of the particles, in closest approaches d.
const OFFSETS: [f64; 8] = [-2.2, -1.4, -0.8, -0.35, 0.15, 0.5, 1.0, 1.8];
/// Half the width and height of the picture, in d.
const EXTENT: DVec2 = DVec2::new(4.0, 3.4);

/// Some of them, on gold.
pub(super) fn picture(area: Rect) -> Picture {
    let gold = Rutherford::radium_c_on_gold();
    let d = gold.head_on_approach;
    let view = View::fit(area, -EXTENT * d, EXTENT * d);
    let mut picture = Picture::new(view);
    for offset in OFFSETS {
        picture.curve(track(d, offset * d), Pen::new(Role::StrikerOut));
    }
    picture.circle(DVec2::ZERO, d, Pen::new(Role::Arc).dotted());
    picture.disc(DVec2::ZERO, 0.1 * d, Role::Coin, ' ');
    picture.reserve(DVec2::ZERO);
    let text = format!("d = {:.1} fm", d / FM);
    let below = DVec2::new(0.0, -d);
    picture.label(
        &text,
        below,
        &[
            LabelSide::Below,
            LabelSide::BelowRight,
            LabelSide::BelowLeft,
        ],
        Role::Arc,
    );
    let corner = DVec2::new(-0.95 * EXTENT.x, -0.93 * EXTENT.y) * d;
    picture.label("7.69 MeV α on gold", corner, &[LabelSide::Right], Role::Dim);
    picture
}

/// The way of a particle that comes from the left at an offset, as points.
///
/// With a = d/2 and ε = √(1 + (b/a)²) the repelled branch is
/// r = a (ε² − 1) / (ε cos φ − 1), φ from the direction of closest approach.
fn track(d: f64, offset: f64) -> Vec<DVec2> {
    const PIECES: u32 = 240;
    let a = d / 2.0;
    let b = offset.abs();
    let eccentricity = 1.0_f64.hypot(b / a);
    let widest = (1.0 / eccentricity).acos();
    let nearest = PI - widest;
    let point = |i: u32| {
        // Not quite to the ends, which lie at infinity.
        let share = f64::from(i) / f64::from(PIECES) * 2.0 - 1.0;
        let phi = -share * widest * 0.9999;
        let r = b * b / a / (eccentricity * phi.cos() - 1.0);
        let at = r * DVec2::from_angle(nearest + phi);
        DVec2::new(at.x, at.y * offset.signum())
    };
    (0..=PIECES)
        .map(point)
        .filter(|at| at.length() < 20.0 * d)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tracks_leave_at_the_angle_of_rutherford_and_come_as_near_as_he_says() {
        let gold = Rutherford::radium_c_on_gold();
        let d = gold.head_on_approach;
        for offset in OFFSETS {
            let track = track(d, offset * d);
            let theta = gold.scattering_angle(offset.abs() * d);
            let nearest = track
                .iter()
                .map(|at| at.length())
                .fold(f64::INFINITY, f64::min);
            let expected = gold.closest_approach(theta).unwrap();
            assert!((nearest / expected - 1.0).abs() < 1e-9, "{offset}");
            let [.., before, last] = track.as_slice() else {
                panic!("a track has points");
            };
            let leaves = (*last - *before).to_angle();
            assert!(
                (leaves - theta * offset.signum()).abs() < 0.05,
                "{offset}: {leaves} {theta}"
            );
        }
    }
}
