//! α-particles passing the charge of an atom: exact hyperbolas.

use glam::DVec2;
use ratatui::layout::Rect;

use crate::physics::rutherford::{FM, Rutherford};
use crate::widgets::Role;
use crate::widgets::picture::{LabelSide, Pen, Picture, View};

/// Offsets of the particles, in units of d, the closest approach of a head-on particle.
const OFFSETS: [f64; 8] = [-2.2, -1.4, -0.8, -0.35, 0.15, 0.5, 1.0, 1.8];
/// The distance from the charge at which a path ends, in units of d, and the number of straight
/// segments of a path.
const FARTHEST: f64 = 20.0;
const PIECES: u32 = 240;
/// Half the width and height of the picture, in d.
const EXTENT: DVec2 = DVec2::new(4.0, 3.4);

/// The paths of some α-particles past a gold nucleus.
pub(super) fn picture(area: Rect) -> Picture {
    use LabelSide::{Below, BelowLeft, BelowRight, Right};
    let gold = Rutherford::radium_c_on_gold();
    let d = gold.head_on_approach;
    let view = View::fit(area, -EXTENT * d, EXTENT * d);
    let mut picture = Picture::new(view);
    for offset in OFFSETS {
        let way = gold.path(offset * d).points(FARTHEST * d, PIECES);
        picture.curve(way, Pen::new(Role::StrikerOut));
    }
    picture.circle(DVec2::ZERO, d, Pen::new(Role::Arc).dotted());
    picture.disc(DVec2::ZERO, 0.1 * d, Role::Coin, ' ');
    picture.reserve(DVec2::ZERO);
    let text = format!("d = {:.1} fm", d / FM);
    let below = DVec2::new(0.0, -d);
    picture.label(&text, below, &[Below, BelowRight, BelowLeft], Role::Arc);
    let corner = DVec2::new(-0.95 * EXTENT.x, -0.93 * EXTENT.y) * d;
    picture.label("7.69 MeV α on gold", corner, &[Right], Role::Dim);
    picture
}
