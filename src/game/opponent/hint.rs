//! A hint for the player, found by the opponent's search and shown in two steps.

use super::story::Reason;
use super::words::{self, Teller};
use crate::game::{Piece, Stand};
use crate::numbers::capital;
use crate::physics::Motion;

/// The best stroke that was found for the player.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StrokeHint {
    /// The position of the striker.
    pub stand: Stand,
    /// The exact stroke.
    pub stroke: Motion,
    /// The effect of the stroke.
    pub reason: Reason,
    /// Whether the striker falls too; this is true only if every stroke that was found pockets it.
    pub fouls: bool,
}

impl StrokeHint {
    /// The first step of the hint: which piece to pocket, and where.
    pub fn which(&self) -> String {
        let story = &self.reason.story;
        match (story.fall, story.first_hit) {
            (Some(fall), _) => {
                let pocket = words::pocket(fall.corner);
                let driven = match fall.sent_by {
                    Piece::Striker => String::new(),
                    Piece::Queen => " The queen can drive it there.".to_owned(),
                    other => format!(" Another coin, a {other}, can drive it there."),
                };
                let cushion = match fall.cushions {
                    0 => "",
                    _ => " It can go off a cushion.",
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

    /// The second step of the hint: the striker's position, the aim, the speed and the reason.
    pub fn how(&self) -> String {
        let place = self.stand.phrase();
        let velocity = self.stroke.velocity;
        let aim = velocity.to_angle().to_degrees().rem_euclid(360.0);
        let speed = velocity.length();
        let why = capital(&words::met(&self.reason.story, Teller::You));
        let mut described =
            format!("Place the striker {place}, aim at {aim:.1}° and strike at {speed:.1} m/s.");
        if !why.is_empty() {
            described = format!("{described} {why}");
        }
        if self.fouls {
            described += " But the striker will fall too. No stroke was found that avoids that.";
        }
        described
    }
}
