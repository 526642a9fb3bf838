//! What is written into the picture: gathered while drawing, written at the end,
//! so that every label knows what is there to keep clear of.

use std::iter;

use glam::DVec2;

use super::arrows::Arrows;
use super::stage::Stage;
use crate::widgets::Role;
use crate::widgets::ink::{Sheet, Side};

/// One label and the sides it would like.
struct Label {
    text: String,
    anchor: DVec2,
    sides: [Side; 8],
    role: Role,
    /// Another anchor, with its sides, where there is no room at the first.
    spare: Option<(DVec2, [Side; 8])>,
}

/// Labels waiting to be written, the most important first.
#[derive(Default)]
pub(super) struct Labels {
    waiting: Vec<Label>,
}

impl Labels {
    /// A label at `anchor`.
    pub(super) fn add(&mut self, text: &str, anchor: DVec2, sides: [Side; 8], role: Role) {
        self.waiting.push(Label {
            text: text.into(),
            anchor,
            sides,
            role,
            spare: None,
        });
    }

    /// Speed of a disc that arrives, beside the visible part of its arrow.
    pub(super) fn incoming(&mut self, stage: &Stage, name: &str, at: DVec2, radius: f64, v: DVec2) {
        let Some(direction) = v.try_normalize() else {
            return;
        };
        let room = stage.room(at, -direction);
        let anchor = at - (radius + 0.55 * (room - radius).max(0.0)) * direction;
        // Across the arrow, on the side away from the coin.
        let across = DVec2::from_angle(stage.side()).rotate(direction).perp() * stage.side();
        let text = format!("{name} = {:.2} m/s", v.length());
        self.add(&text, anchor, Side::towards(across), Role::Incoming);
    }

    /// Speed of a disc that leaves, at the tip of its arrow; or that it stops.
    pub(super) fn outgoing(
        &mut self,
        name: &str,
        tip: Option<DVec2>,
        centre: DVec2,
        radius: f64,
        v: DVec2,
        role: Role,
    ) {
        let (text, anchor, towards) = match tip {
            Some(tip) => (format!("{name} = {:.2} m/s", v.length()), tip, v),
            None => (
                format!("{name} = 0: it stands still"),
                centre + radius * DVec2::NEG_Y,
                DVec2::NEG_Y,
            ),
        };
        self.add(&text, anchor, Side::towards(towards), role);
        // Beside the disc, as after a head-on hit the arrow may be on the other disc.
        let across = v.perp().normalize_or_zero();
        let across = across * 1.0_f64.copysign(across.y);
        if let Some(label) = self.waiting.last_mut() {
            label.spare = Some((centre + radius * across, Side::towards(across)));
        }
    }

    /// An angle in degrees, outside the middle of its arc.
    pub(super) fn angle(&mut self, degrees: f64, middle: DVec2, outwards: DVec2) {
        let text = format!("{degrees:.1}°");
        self.add(&text, middle, Side::towards(outwards), Role::Arc);
    }

    /// The names of the two parts of u.
    pub(super) fn split(&mut self, stage: &Stage, arrows: &Arrows, u: DVec2, n: DVec2, t: DVec2) {
        let from = stage.centres[0];
        // Beyond the discs, which a label never covers.
        let beyond = [
            stage.collision.contact_distance() + stage.radius(1),
            stage.radius(0),
        ];
        let parts = [("uₙ", n, Role::NormalPart), ("uₜ", t, Role::TangentPart)];
        for ((name, axis, role), beyond) in parts.into_iter().zip(beyond) {
            let part = u.dot(axis) * axis;
            if arrows.is_still(part) {
                continue;
            }
            let text = format!("{name} = {:.2} m/s", part.length());
            let reach = (arrows.per_speed * part.length()).max(beyond);
            let end = from + reach * part.normalize();
            self.add(&text, end, Side::towards(part), role);
        }
    }

    /// The speed that is split, where no arrow outside the disc tells it.
    pub(super) fn whole(&mut self, stage: &Stage, arrows: &Arrows, u: DVec2) {
        let reach = (arrows.per_speed * u.length()).max(stage.radius(0));
        let end = stage.centres[0] + reach * u.normalize_or_zero();
        let text = format!("u = {:.2} m/s", u.length());
        let away = u.perp() * stage.side();
        self.add(&text, end, Side::towards(u + 0.5 * away), Role::Incoming);
    }

    /// Writes all of them.
    pub(super) fn write(self, sheet: &mut Sheet) {
        for label in &self.waiting {
            sheet.expect_label(label.anchor);
        }
        let mut left = Vec::new();
        for label in self.waiting {
            let mut places = iter::once((label.anchor, label.sides)).chain(label.spare);
            let mut write = |(anchor, sides): (DVec2, [Side; 8])| {
                sheet.label(&label.text, anchor, &sides, label.role)
            };
            if !places.any(&mut write) {
                left.push(label);
            }
        }
        for label in left {
            sheet.label_far(&label.text, label.anchor, &label.sides, label.role);
        }
    }
}
