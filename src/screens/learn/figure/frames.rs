//! One hit seen from the board and from the centre of mass, at the same moment.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::messages::Key;
use crate::physics::frames::cm_scattering_angle;
use crate::physics::{Bond, Collision, Frame};
use crate::widgets::hit::{Layer, Layers, Watch};
use crate::widgets::{Lines, Look, Role};

/// The two: from the board, from the centre of mass.
pub(super) fn watches(collision: &Collision, reduced: bool) -> [Watch; 2] {
    let mut layers = Layers::default();
    for layer in [Layer::Triangle, Layer::Lines] {
        layers.toggle(layer);
    }
    let watch = || Watch::new(*collision, None, reduced).with_layers(layers);
    let mut moving = watch();
    while moving.frame() != Frame::CentreOfMass && moving.update(Key::Char('f')) {}
    [watch(), moving]
}

/// Draws them side by side where there is room, else one above the other.
pub(super) fn draw(watches: &[Watch; 2], area: Rect, buf: &mut Buffer, look: &Look) {
    let wide = area.width + 2 >= area.height.saturating_mul(2);
    let halves = if wide {
        // Of one size, so that they are drawn alike: the middle column may be shared.
        let width = area.width.div_ceil(2);
        [
            Rect { width, ..area },
            Rect {
                x: area.right() - width,
                width,
                ..area
            },
        ]
    } else {
        let height = area.height / 2;
        [
            Rect { height, ..area },
            Rect {
                y: area.y + height,
                height: area.height - height,
                ..area
            },
        ]
    };
    let names = ["the board", "centre of mass"];
    let [board, _] = watches;
    let told = told(board.collision());
    for (((watch, half), name), told) in watches.iter().zip(halves).zip(names).zip(told) {
        let head = 2.min(half.height);
        let picture = Rect {
            y: half.y + head,
            height: half.height - head,
            ..half
        };
        watch.draw(picture, buf, look);
        let mut lines = Lines::new(half, buf, *look);
        lines.line(name, Role::Dim);
        lines.line(&told, Role::Text);
    }
}

/// What takes the one picture to the other, V, and what happens in the other, the turn
/// by Θ.
fn told(collision: &Collision) -> [String; 2] {
    let speed = collision.centre_of_mass_velocity().length();
    let angle = collision
        .alpha()
        .and_then(|alpha| cm_scattering_angle(alpha, collision.restitution));
    let turn = match (angle, collision.bond) {
        (Some(_), Bond::Stick) => "they stick".into(),
        (Some(angle), Bond::Slip) => format!("Θ = {:.1}°", angle.to_degrees().abs()),
        (None, _) => "Θ: none".into(),
    };
    [format!("V = {speed:.2} m/s"), turn]
}
