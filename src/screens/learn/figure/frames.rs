//! One collision in the laboratory frame and in the centre-of-mass frame, at the same moment.

use ratatui::layout::Rect;

use super::FigureArea;
use crate::physics::{Collision, Frame};
use crate::widgets::hit::{Overlay, Overlays, Watch};
use crate::widgets::picture::Picture;
use crate::widgets::{Lines, Role, areas};

/// The two frames: laboratory, centre of mass.
pub(super) fn watches(collision: &Collision) -> [Watch; 2] {
    let layers = Overlays::default().without([Overlay::Triangle, Overlay::Lines]);
    [Frame::Laboratory, Frame::CentreOfMass].map(|frame| {
        let watch = Watch::revealed(*collision).at_once();
        watch.with_layers(layers).seen_from(frame)
    })
}

/// The areas of the two pictures: side by side if there is room, otherwise one above the other.
fn halves(area: Rect) -> [Rect; 2] {
    let wide = area.width + 2 >= area.height.saturating_mul(2);
    if wide {
        // Both have the same size, so that they are drawn to the same scale. If the width is odd,
        // they share the middle column.
        let width = area.width.div_ceil(2);
        let x = area.right() - width;
        [Rect { width, ..area }, Rect { x, width, ..area }]
    } else {
        areas::upper(area, area.height / 2)
    }
}

/// Both pictures, each with its name above it.
pub(super) fn lay_out(watches: &[Watch], figure: FigureArea) -> Vec<Picture> {
    let (area, buf, look) = (figure.area, figure.buf, figure.look);
    let names = ["the board", "centre of mass"];
    let words = watches.first().map(|board| revealed(board.collision()));
    let words = names.into_iter().zip(words.into_iter().flatten());
    let each = watches.iter().zip(halves(area)).zip(words);
    each.map(|((watch, half), (name, revealed))| {
        let mut lines = Lines::new(half, buf, *look);
        lines.line(name, Role::Dim);
        lines.line(&revealed, Role::Text);
        watch.picture(areas::upper(half, lines.written())[1])
    })
    .collect()
}

/// V, which relates the two pictures, and the scattering angle Θ.
fn revealed(collision: &Collision) -> [String; 2] {
    let speed = collision.centre_of_mass_velocity().length();
    let angle = collision.cm_deflection();
    let turn = match angle {
        Some(_) if collision.coalesces() => "they coalesce".into(),
        Some(angle) => format!("Θ = {:.1}°", angle.to_degrees().abs()),
        None => "Θ: none".into(),
    };
    [format!("V = {speed:.2} m/s"), turn]
}
