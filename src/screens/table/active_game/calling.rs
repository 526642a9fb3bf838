//! Calls: predicting the first impact before the stroke.

use ratatui::layout::Rect;

use super::{ActiveGame, After, GamePhase, ShownStroke};
use crate::game::{Move, Strike};
use crate::messages::{Mouse, MouseKind};
use crate::progress::{Attempt, Predicted, TABLE};
use crate::screens::Context;
use crate::screens::table::TableAction;
use crate::screens::table::calls::call;
use crate::screens::table::computer_stroke::ComputerStroke;
use crate::screens::table::preview::FirstHit;
use crate::widgets::hit::{Face, Markings, point_at, setup_picture};
use crate::widgets::input::{KeyTable, RayAction};
use crate::widgets::panel::Panel;
use crate::widgets::panels::{contact_distance, masses, offset};
use crate::widgets::picture::Picture;
use crate::widgets::{Outcome, RayInput, Role};

/// A call that the player is making.
#[derive(Debug, Clone)]
pub(in crate::screens::table) struct Calling {
    hit: FirstHit,
    rays: RayInput,
    /// The computer's stroke, if the call predicts one.
    of: Option<ComputerStroke>,
}

impl Calling {
    pub(super) fn new(hit: FirstHit, of: Option<ComputerStroke>) -> Self {
        let rays = RayInput::new(hit.impact.collision.side());
        Self { hit, rays, of }
    }

    pub(super) fn keys(&self) -> KeyTable<RayAction> {
        self.rays.keys("next, then strike")
    }

    /// Turns a ray; once both are set, makes the stroke and records the call.
    pub(super) fn act(
        &mut self,
        action: RayAction,
        game: &mut ActiveGame,
        cx: &mut Context,
    ) -> Option<GamePhase> {
        if self.rays.act(action) != Outcome::Done(()) {
            return None;
        }
        let call = Some(call(&self.rays.said()?));
        let number = game.history.len();
        let phase = match &self.of {
            Some(stroke) => game.play_for_the_computer(stroke, call, cx),
            None => {
                let strike = game.struck();
                let watching = game.play(Move::Strike(Strike { call, ..strike }), cx);
                watching.unwrap_or(GamePhase::Aim)
            }
        };
        game.record_call(number, cx);
        Some(phase)
    }

    /// Whether the aim can still be changed. If the hand is unsteady, the picture has already
    /// revealed the error of this stroke.
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

    pub(super) fn point(&mut self, mouse: &Mouse, area: Rect) -> After {
        let pressed = mouse.kind == MouseKind::Down;
        if !mouse.is_held() || !area.contains(mouse.cell().into()) {
            return After::Ignored;
        }
        let collision = &self.hit.impact.collision;
        point_at(area, collision, &mut self.rays, mouse.place(), pressed);
        After::Same
    }

    pub(super) fn picture(&self, area: Rect) -> Picture {
        // The impact angle is hidden, because the coin leaves along the line of impact.
        let shown = Markings {
            angle: false,
            ..Markings::ALL
        };
        let collision = &self.hit.impact.collision;
        let rays = Some(&self.rays);
        setup_picture(area, Face::STRIKER_AND_COIN, collision, shown, rays)
    }

    /// Writes the collision, and both rays as predicted so far.
    pub(super) fn write(&self, panel: &mut Panel<TableAction>) {
        let collision = &self.hit.impact.collision;
        offset(collision, panel);
        // The impact angle is left out, because it would reveal the coin's direction.
        contact_distance(collision, panel);
        masses(collision, [false; 2], panel);
        panel.gap();
        panel.heading("Where will they go?");
        panel.part(TableAction::Call, |panel| {
            self.rays.write(panel, "coin");
            panel.gap();
            panel.paragraph(self.rays.about("coin"), Role::Text);
            panel.gap();
            self.rays.write_prompt(panel, "coin", "strike!");
        });
    }
}

impl ActiveGame {
    /// Records the call of a move as an answer of the player, unless several people share the
    /// keyboard: then it is unknown which of them made the call.
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
