//! The triangle of momenta and the proof in three steps.
//!
//! All momenta are divided by m₁, so that for equal masses they are the velocities: u = v₁ +
//! (m₂/m₁) v₂.

use glam::DVec2;
use ratatui::layout::Rect;

use super::FigureArea;
use crate::numbers::fixed;
use crate::physics::Collision;
use crate::widgets::picture::{LabelSide, Pen, Picture, View};
use crate::widgets::{Role, areas, text};

/// The corners: where the arrows begin, where v₁ ends, where u ends.
fn corners(collision: &Collision) -> [DVec2; 3] {
    let outcome = collision.outcome();
    let ratio = collision.target.mass / collision.striker.mass;
    let joint = outcome.v1;
    [DVec2::ZERO, joint, joint + ratio * outcome.v2]
}

fn equal_masses(collision: &Collision) -> bool {
    (collision.striker.mass / collision.target.mass - 1.0).abs() < 1e-9
}

pub(super) fn title(collision: &Collision) -> &'static str {
    match equal_masses(collision) {
        true => "the triangle of velocities",
        false => "the triangle of momenta",
    }
}

/// The number of lines of text below the picture.
const LINES: u16 = 2;

/// The view of the triangle; in the second step it has room for the squares on the sides.
fn view(collision: &Collision, step: u8, area: Rect) -> View {
    let u = collision.u1.length();
    let squares = f64::from(u8::from(step == 2));
    let low = DVec2::new(-0.55 * squares - 0.08, -squares - 0.1) * u;
    let high = DVec2::new(1.08 + 0.55 * squares, 0.62 + 0.72 * squares) * u;
    View::fit(area, low, high)
}

/// The impact angle α, in degrees, at which v₂ lies along the line from this cell to the tip of u.
pub(super) fn alpha_at(
    collision: &Collision,
    step: u8,
    area: Rect,
    (column, row): (u16, u16),
) -> Option<f64> {
    let [picture, _] = areas::upper(area, area.height.saturating_sub(LINES));
    let at = view(collision, step, picture).world_at(column, row);
    // If the tip of v₁ is at this point, v₂ runs from it to the tip of u, at an angle α below u.
    let left = collision.u1 - at;
    let is_inside = picture.contains((column, row).into());
    is_inside.then(|| at.y.atan2(left.x).to_degrees())
}

/// The triangle at a step of the proof, with the text of the step below it.
pub(super) fn lay_out(collision: &Collision, step: u8, figure: FigureArea) -> Picture {
    use LabelSide::{Above, Below, Over};
    let (area, mut lines) = figure.split(LINES);
    let mut picture = Picture::new(view(collision, step, area));
    let [tail, joint, tip] = corners(collision);
    let last = match equal_masses(collision) {
        true => "v₂",
        false => "(m₂/m₁) v₂",
    };
    let sides = [
        (tail, tip, "u", Role::Incoming),
        (tail, joint, "v₁", Role::StrikerOut),
        (joint, tip, last, Role::CoinOut),
    ];
    let middle = (tail + joint + tip) / 3.0;
    if step == 2 {
        for (from, to, _, role) in sides {
            square(&mut picture, from, to, middle, role);
        }
    }
    for (from, to, _, role) in sides {
        picture.arrow(from, to, Pen::new(role).bold());
    }
    let [a, b] = [joint - tail, tip - joint];
    let square_corner = a.normalize_or_zero().dot(b.normalize_or_zero()).abs() < 1e-9;
    if step == 3 && square_corner {
        let size = (0.12 * collision.u1.length()).min(0.4 * a.length().min(b.length()));
        picture.square_corner(joint, [-a, b], size, Role::SquareCorner);
    }
    for (from, to, name, role) in sides {
        let length = (to - from).length();
        if length < 0.05 * collision.u1.length() {
            continue;
        }
        let centre = (from + to) / 2.0;
        let text = match step {
            2 => format!("{name}² = {:.2}", length * length),
            _ => format!("{name} = {length:.2}"),
        };
        let outwards = outwards(from, to, middle);
        // The label is in the middle of a square if there is room, otherwise outside it.
        let columns = length / picture.view().per_column();
        let roomy = columns > text::width(&text) as f64 + 2.0;
        let towards = LabelSide::towards(outwards);
        let (share, sides) = match step {
            2 if roomy => (0.5, &[Over, Above, Below][..]),
            2 => (1.0, &towards[..]),
            _ => (0.0, &towards[..]),
        };
        picture.label(&text, centre + share * length * outwards, sides, role);
    }
    let alpha = collision.alpha().map_or(0.0, f64::to_degrees);
    lines.line(&format!("α = {alpha:.0}°"), Role::Dim);
    lines.line(&words(collision, step, [a, b]), Role::Text);
    picture
}

/// The direction away from the middle of the triangle, perpendicular to a side.
fn outwards(from: DVec2, to: DVec2, middle: DVec2) -> DVec2 {
    let across = (to - from).perp().normalize_or_zero();
    let away = (from + to) / 2.0 - middle;
    match across.dot(away) >= 0.0 {
        true => across,
        false => -across,
    }
}

fn square(picture: &mut Picture, from: DVec2, to: DVec2, middle: DVec2, role: Role) {
    let out = outwards(from, to, middle) * (to - from).length();
    picture.curve([from, from + out, to + out, to], Pen::new(role).dotted());
}

/// The text of a step, with the numbers of the shot.
fn words(collision: &Collision, step: u8, [a, b]: [DVec2; 2]) -> String {
    let u = collision.u1.length();
    let (uu, aa, bb) = (u * u, a.length_squared(), b.length_squared());
    let both = 2.0 * a.dot(b);
    let both = if both.abs() < 1e-9 * uu { 0.0 } else { both };
    match step {
        1 => "The triangle closes: u = v₁ + v₂.".into(),
        2 => format!("{uu:.2} = {aa:.2} + {bb:.2}{}", spare(both)),
        _ => format!("2 v₁·v₂ = {uu:.2} − {aa:.2} − {bb:.2} = {}", fixed(both, 2)),
    }
}

/// The difference between the square of u and the sum of the squares of the other two sides, as a
/// signed term; empty if it rounds to zero.
fn spare(both: f64) -> String {
    match both {
        both if both.abs() < 0.005 => String::new(),
        both if both > 0.0 => format!(" + {both:.2}"),
        both => format!(" − {:.2}", -both),
    }
}
