//! The computer's strokes and the player's hints: asked for, and what comes back.

use super::{ActiveGame, Hinted, TablePhase};
use crate::game::opponent::StrokeHint;
use crate::messages::{Found, SearchResult, Wanted};
use crate::screens::Context;
use crate::screens::table::aim::Aim;
use crate::screens::table::computer_stroke::{ComputerStroke, strike};
use crate::screens::table::options::Player;
use crate::screens::table::pointer::Pointer;

impl ActiveGame {
    /// Whether the computer is to play and has not been asked yet.
    pub(super) fn is_computers_turn(&self) -> bool {
        matches!(self.phase, TablePhase::Aim)
            && self.options.player(self.seat()) == Player::Computer
    }

    /// Asks the computer for its stroke, if it is to play.
    pub(super) fn hand_over(&mut self, cx: &mut Context) {
        if self.is_computers_turn() {
            let wanted = Wanted::Stroke(self.options.strength(self.seat()));
            let ticket = cx.think(self.game().clone(), self.next_seed(), wanted);
            self.phase = TablePhase::Think { ticket };
        }
    }

    /// Asks for a hint; once it is there, tells more of it; at last sets it.
    pub(super) fn ask_for_hint(&mut self, cx: &mut Context) {
        match &mut self.hint {
            Some(Hinted::Told { hint, whole, .. }) if *whole => {
                let stroke = hint.stroke;
                self.aim = Aim::of(&strike(stroke), self.seat());
                self.look_ahead();
            }
            Some(Hinted::Told { whole, .. }) => *whole = true,
            Some(Hinted::Asked { .. }) => {}
            None => {
                let ticket = cx.think(self.game().clone(), self.next_seed(), Wanted::Hint);
                self.history.take_hint();
                self.hint = Some(Hinted::Asked { ticket });
            }
        }
    }

    /// What is left to chance in the next stroke: another each time, and the same
    /// when the game is played again.
    fn next_seed(&self) -> u64 {
        let seed = self.game().setup().seed.unwrap_or(0);
        seed.rotate_left(32) ^ self.history.len() as u64
    }

    /// Takes the result of a search in, if it is still waited for.
    pub(super) fn take_result(&mut self, result: &SearchResult, cx: &Context) {
        let is_it = |ticket: u64| ticket == result.ticket;
        let thinks = matches!(self.phase, TablePhase::Think { ticket } if is_it(ticket));
        let hints = matches!(self.hint, Some(Hinted::Asked { ticket }) if is_it(ticket));
        match result.found {
            Found::Stroke(Some(decision)) if thinks => {
                self.show(ComputerStroke::new(decision, self.game()), cx);
            }
            Found::Stroke(None) if thinks => self.pass(),
            Found::Hint(hint) if hints => self.take_hint(hint),
            Found::Failed if thinks => {
                self.phase = TablePhase::Aim;
                self.hand_to_person();
                let notice =
                    "The computer has come upon a fault of its own. Please play on in its place.";
                self.notice = Some(notice.into());
            }
            Found::Failed if hints => {
                self.hint = None;
                self.notice =
                    Some("No hint: the computer has come upon a fault of its own.".into());
            }
            _ => {}
        }
    }

    /// Lets a person play where the computer cannot: else the game would stand still.
    pub(super) fn hand_to_person(&mut self) {
        let seat = self.seat();
        self.options.set_player(seat, Player::Person);
    }

    fn take_hint(&mut self, hint: Option<StrokeHint>) {
        self.hint = match hint {
            Some(hint) => Some(Hinted::Told {
                pointer: Pointer::of(&hint.reason.story, &strike(hint.stroke), self.game()),
                hint: Box::new(hint),
                whole: false,
            }),
            None => {
                self.notice = Some("There is no stroke to be found here.".into());
                None
            }
        };
    }
}
