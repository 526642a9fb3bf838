//! Calls: predicting the first impact before the stroke.

use super::{ActiveGame, FirstHit, GamePhase, ShownStroke};
use crate::game::Strike;
use crate::progress::{Attempt, Predicted, TABLE};
use crate::screens::Context;
use crate::screens::table::calls::call;
use crate::screens::table::computer_stroke::ComputerStroke;
use crate::screens::table::{TableAction, TablePanel};
use crate::widgets::input::RayAction;
use crate::widgets::replay::ImpactPrediction;
use crate::widgets::{Outcome, RayInput};

/// A call that the player is making.
#[derive(Debug, Clone)]
pub(super) struct Calling {
    pub(super) prediction: ImpactPrediction,
    /// The computer's stroke, if the call predicts one.
    of: Option<ComputerStroke>,
}

impl Calling {
    pub(super) fn new(hit: FirstHit, of: Option<ComputerStroke>) -> Self {
        let (impact, rays) = (hit.impact, RayInput::new(hit.impact.collision.side()));
        let prediction = ImpactPrediction { impact, rays };
        Self { prediction, of }
    }

    /// Turns a ray; once both are set, makes the stroke and records the call.
    pub(super) fn act(
        &mut self,
        action: RayAction,
        game: &mut ActiveGame,
        cx: &mut Context,
    ) -> Option<GamePhase> {
        if self.prediction.rays.act(action) != Outcome::Done(()) {
            return None;
        }
        let call = Some(call(&self.prediction.rays.said()?));
        let number = game.history.len();
        let phase = match &self.of {
            Some(stroke) => game.play_for_the_computer(stroke, call, cx),
            None => {
                let strike = game.struck();
                let watching = game.play(Strike { call, ..strike }, cx);
                watching.unwrap_or(GamePhase::Aim)
            }
        };
        game.record_call(number, cx);
        Some(phase)
    }

    /// Whether the player can go back. Before a stroke of their own with an unsteady hand they
    /// cannot, because the picture has already revealed the error of that stroke.
    pub(super) fn can_be_left(&self, game: &ActiveGame) -> bool {
        self.of.is_some() || game.hand().errors().is_none()
    }

    /// Goes back to the aim, or to the computer's aim.
    pub(super) fn leave(&mut self, game: &ActiveGame, cx: &Context) -> GamePhase {
        match self.of.take() {
            Some(stroke) => GamePhase::Show(Box::new(ShownStroke::new(stroke, &game.options, cx))),
            None => GamePhase::Aim,
        }
    }

    /// Writes the collision, and both rays as predicted so far.
    pub(super) fn write(&self, panel: &mut TablePanel) {
        self.prediction.write_facts([false; 2], panel);
        panel.gap();
        panel.heading("Where will they go?");
        panel.part(TableAction::Call, |panel| {
            self.prediction.rays.write_all(panel, "coin", "strike!");
        });
    }
}

impl ActiveGame {
    /// Records the player's call for a move as an answer, unless several people share the keyboard:
    /// then it is unknown which of them made the call.
    fn record_call(&self, number: usize, cx: &mut Context) {
        let called = self.history.past(number).and_then(|past| past.called);
        let Some(called) = called.filter(|_| !self.options.is_shared()) else {
            return;
        };
        let predicted = Predicted {
            player: &cx.settings.player,
            family: TABLE,
            seed: self.game().setup().seed.unwrap_or(0),
            number: u32::try_from(number + 1).unwrap_or(u32::MAX),
            only: None,
        };
        if let Some(attempt) = Attempt::of_prediction(&predicted, &called.collision, &called.said) {
            cx.record(attempt);
        }
    }
}
