//! The computer's intended stroke, shown before it is played and afterwards beside the actual one.

use super::aim::Aim;
use super::pointer::Pointer;
use super::preview::Preview;
use crate::game::opponent::Decision;
use crate::game::{Game, Strike};
use crate::numbers::fixed;

/// The smallest error of the hand that is reported, in degrees.
const SMALLEST_SLIP_DEG: f64 = 0.05;

/// The computer's decision and its intention.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ComputerStroke {
    pub(super) decision: Decision,
    /// The intended stroke, in the form in which a player would set it.
    pub(super) aim: Aim,
    /// The first contact of the intended stroke.
    pub(super) preview: Option<Preview>,
    /// The coin that the stroke was meant to pocket, with the pocket, or else the coin that it was
    /// meant to hit first.
    pub(super) pointer: Option<Pointer>,
}

impl ComputerStroke {
    /// The stroke in `decision`, for the seat whose turn it is in `game`.
    pub(super) fn new(decision: Decision, game: &Game) -> Self {
        let meant = Strike::from(decision.meant);
        Self {
            aim: Aim::of(&meant, game.seat()),
            preview: Preview::of(&meant, game),
            pointer: Pointer::of(&decision.reason.story, &meant, game),
            decision,
        }
    }

    /// The stroke with the error of the hand, then the intended stroke, in case the first cannot be
    /// played.
    pub(super) fn strikes(&self) -> [Strike; 2] {
        [self.decision.struck(), self.decision.meant].map(Strike::from)
    }

    /// The error of the direction, as shown; `None` if it is too small to report.
    pub(super) fn off(&self) -> Option<String> {
        let degrees = self.decision.slip.turn.atan().abs().to_degrees();
        let words = || format!("{}° off", fixed(degrees, 1));
        (degrees >= SMALLEST_SLIP_DEG).then(words)
    }
}
