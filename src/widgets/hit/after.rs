//! The picture after a hit, as somebody has seen it: the ways in and out, and how far
//! each one was turned. It gives away neither masses nor speeds.

use glam::DVec2;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::angles;
use super::labels::Labels;
use super::stage::Stage;
use super::watch::Face;
use crate::physics::Collision;
use crate::widgets::ink::{Pen, Sheet, Side};
use crate::widgets::{Look, Role};

/// Length of every arrow, in radii of the larger disc: none tells of a speed.
const ARROW: f64 = 2.1;

/// A speed below this share of the fastest counts as none.
const STILL: f64 = 1e-9;

/// Draws the ways that a striker and a coin came and went, with both angles.
pub fn draw_after(area: Rect, buf: &mut Buffer, look: &Look, collision: &Collision) {
    let stage = Stage::new(area, collision);
    let outcome = collision.outcome();
    let mut sheet = Sheet::new(stage.view, look.charset);
    let mut labels = Labels::default();
    let (before, after) = ([collision.u1, collision.u2], [outcome.v1, outcome.v2]);
    let fastest = before.iter().chain(&after).map(|v| v.length());
    let still = STILL * fastest.fold(0.0, f64::max);
    let moving = |v: DVec2| v.try_normalize().filter(|_| v.length() > still);
    for (body, face) in Face::STRIKER_AND_COIN.into_iter().enumerate() {
        let (centre, radius) = (stage.centres[body], stage.radius(body));
        sheet.disc(centre, radius, face.role, face.letter);
        if let Some(direction) = moving(before[body]) {
            let rim = centre - radius * direction;
            let tail = rim - room(&stage, rim, -direction) * direction;
            let pen = Pen::new(Role::Incoming);
            sheet.arrow(tail, rim, pen);
            let across = direction.perp() * stage.side();
            let middle = rim.lerp(tail, 0.6);
            labels.add("before", middle, Side::towards(across), Role::Incoming);
        }
        let role = [Role::StrikerOut, Role::CoinOut][body];
        let Some(direction) = moving(after[body]) else {
            let below = centre + radius * DVec2::NEG_Y;
            let text = "stands still";
            labels.add(text, below, Side::towards(DVec2::NEG_Y), role);
            continue;
        };
        let rim = centre + radius * direction;
        let tip = rim + room(&stage, rim, direction) * direction;
        sheet.arrow(rim, tip, Pen::new(role).bold());
        labels.add("after", tip, Side::towards(direction), role);
        if let Some(middle) = angles::arc(&mut sheet, &stage, body, direction, Role::Arc.into()) {
            let turn = stage.heading().angle_to(direction).to_degrees();
            labels.angle(turn.abs(), middle, middle - centre);
        } else {
            labels.angle(0.0, tip, direction);
        }
    }
    sheet.reserve(DVec2::ZERO);
    labels.write(&mut sheet);
    sheet.draw(buf, &look.theme);
}

/// Length of an arrow from `from` in this direction.
fn room(stage: &Stage, from: DVec2, direction: DVec2) -> f64 {
    stage.room(from, direction).min(ARROW * stage.unit())
}
