//! The picture after a collision: the original and final paths, with their angles, but no masses or
//! speeds.

use glam::DVec2;
use ratatui::layout::Rect;

use super::sketch::{ArrowScale, Sketch};
use super::{Face, HitLayout};
use crate::physics::Collision;
use crate::widgets::Role;
use crate::widgets::picture::{Pen, Picture};

/// The length of every arrow that has room for it, in radii of the larger disc; it is the same for
/// every speed.
const ARROW: f64 = 2.1;

/// The paths of a striker and a coin before and after a collision, with both angles.
pub(crate) fn after_picture(area: Rect, collision: &Collision) -> Picture {
    let mut sketch = Sketch::new(HitLayout::new(area, collision));
    let stage = sketch.stage;
    let outcome = collision.outcome();
    let (before, after) = ([collision.u1, collision.u2], [outcome.v1, outcome.v2]);
    let scale = ArrowScale::fit(&stage, before, after);
    let room = |from, direction| stage.room(from, direction).min(ARROW * stage.unit());
    for (body, face) in Face::STRIKER_AND_COIN.into_iter().enumerate() {
        let (centre, radius) = (stage.centres[body], stage.radius(body));
        sketch.picture.disc(centre, radius, face.role, face.letter);
        if let Some(direction) = scale.direction(before[body]) {
            let rim = centre - radius * direction;
            let tail = rim - room(rim, -direction) * direction;
            sketch.picture.arrow(tail, rim, Role::Incoming);
            let across = direction.perp() * stage.collision.side();
            sketch.label("before", rim.lerp(tail, 0.6), across, Role::Incoming);
        }
        let role = [Role::StrikerOut, Role::CoinOut][body];
        let Some(direction) = scale.direction(after[body]) else {
            let below = centre + radius * DVec2::NEG_Y;
            sketch.label("at rest", below, DVec2::NEG_Y, role);
            continue;
        };
        let rim = centre + radius * direction;
        let tip = rim + room(rim, direction) * direction;
        sketch.picture.arrow(rim, tip, Pen::new(role).bold());
        sketch.label("after", tip, direction, role);
        let heading = stage.heading();
        sketch.arc(body, [heading, direction], "", Role::Arc.into());
        if !Sketch::has_arc(heading, direction) {
            sketch.angle("", 0.0, tip, direction);
        }
    }
    sketch.picture.reserve(DVec2::ZERO);
    sketch.picture
}
