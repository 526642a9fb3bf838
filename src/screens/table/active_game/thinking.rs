//! The computer's strokes and the player's hints.
//!
//! Both are searched for on the spot: while the computer decides nothing moves on the board,
//! and a search takes less time than anyone would notice as a wait (`docs/performance.md`).

use super::{ActiveGame, GamePhase, Hinted, ShownStroke};
use crate::game::opponent;
use crate::screens::Context;
use crate::screens::table::aim::Aim;
use crate::screens::table::computer_stroke::{ComputerStroke, strike};
use crate::screens::table::options::Player;
use crate::screens::table::pointer::Pointer;

impl ActiveGame {
    /// The computer's stroke, to be seen before it is struck.
    pub(super) fn think(&mut self, cx: &Context) -> GamePhase {
        let strength = self.options.strength(self.seat());
        match opponent::think(self.game(), strength, self.next_seed()) {
            Some(decision) => {
                let stroke = ComputerStroke::new(decision, self.game());
                GamePhase::Show(Box::new(ShownStroke::new(stroke, &self.options, cx)))
            }
            None => {
                self.pass();
                GamePhase::Aim
            }
        }
    }

    /// Gives a hint; then all of it; at last sets it.
    pub(super) fn help(&mut self) {
        match &mut self.hint {
            Some(hinted) if hinted.whole => {
                let stroke = hinted.hint.stroke;
                self.aim = Aim::of(&strike(stroke), self.seat());
            }
            Some(hinted) => hinted.whole = true,
            None => self.find_hint(),
        }
    }

    fn find_hint(&mut self) {
        self.history.take_hint();
        let found = opponent::hint(self.game(), self.next_seed());
        if found.is_none() {
            self.notice = Some("There is no stroke to be found here.".into());
        }
        self.hint = found.map(|hint| Hinted {
            pointer: Pointer::of(&hint.reason.story, &strike(hint.stroke), self.game()),
            hint,
            whole: false,
        });
    }

    /// What is left to chance in the next stroke: another each time, and the same
    /// when the game is played again.
    fn next_seed(&self) -> u64 {
        let seed = self.game().setup().seed.unwrap_or(0);
        seed.rotate_left(32) ^ self.history.len() as u64
    }

    /// Lets a person play where the computer cannot: else the game would stand still.
    pub(super) fn hand_to_person(&mut self) {
        let seat = self.seat();
        self.options.set_player(seat, Player::Person);
    }
}
