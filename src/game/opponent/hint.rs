//! A hint for the player: the same search, told in two steps.

use glam::DVec2;

use super::reason::Reason;
use super::words::{self, Teller, pocket_seen_from};
use crate::game::{BaseLines, Piece};
use crate::numbers::capital;
use crate::physics::Motion;
use crate::physics::units::{deg_from_rad, mm_from_m};

/// The best stroke that was found for the player.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StrokeHint {
    /// The stroke, if it is struck exactly so.
    pub stroke: Motion,
    /// What it does.
    pub reason: Reason,
    /// Whether the striker falls in it all the same, because no stroke was found in
    /// which it does not.
    pub fouls: bool,
}

impl StrokeHint {
    /// How far to the player's right of the middle the striker stands, in metres.
    pub fn along(&self) -> f64 {
        self.reason.seat.turn_back(self.stroke.position).x
    }

    /// The direction of the stroke in radians, anticlockwise from the player's
    /// right.
    pub fn direction(&self) -> f64 {
        let DVec2 { x, y } = self.reason.seat.turn_back(self.stroke.velocity);
        y.atan2(x)
    }

    /// The first step: which piece, and where to.
    pub fn which(&self) -> String {
        let story = &self.reason.story;
        match (story.fall, story.first_hit) {
            (Some(fall), _) => {
                let pocket = pocket_seen_from(self.reason.seat, fall.corner);
                let driven = match fall.sent_by {
                    Piece::Striker => String::new(),
                    Piece::Queen => " The queen can drive it there.".to_owned(),
                    other => format!(" Another coin, a {other}, can drive it there."),
                };
                let cushion = match fall.cushions {
                    0 => "",
                    _ => " It can go by a cushion.",
                };
                format!(
                    "Look at the {} and the {pocket}.{driven}{cushion}",
                    fall.piece
                )
            }
            (None, Some(hit)) => format!(
                "No coin is sure to fall from here. Play the {} for a better next stroke.",
                hit.piece
            ),
            (None, None) => "No coin is within reach from here. Play a quiet stroke.".to_owned(),
        }
    }

    /// The second step: where to stand, where to aim and how hard, and why.
    pub fn how(&self) -> String {
        let along = mm_from_m(self.along());
        let side = if along > 0.0 { "right" } else { "left" };
        let circle = mm_from_m(BaseLines::base_circle_along());
        let place = if along.abs() < 0.5 {
            "in the middle".to_owned()
        } else if (along.abs() - circle).abs() < 0.05 {
            format!("on the {side} circle")
        } else {
            format!("{:.0} mm {side} of the middle", along.abs())
        };
        let aim = deg_from_rad(self.direction());
        let speed = self.stroke.velocity.length();
        let why = capital(&words::met(&self.reason.story, Teller::You));
        let mut told =
            format!("Place the striker {place}, aim at {aim:.1}° and strike with {speed:.1} m/s.");
        if !why.is_empty() {
            told = format!("{told} {why}");
        }
        if self.fouls {
            told += " Mind: the striker will fall too. No stroke without that was found.";
        }
        told
    }
}
