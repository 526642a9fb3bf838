//! Laying coins out, in practice.

use glam::DVec2;

use super::{ActiveGame, TablePhase};
use crate::game::{Coin, GameError, Move, Piece};
use crate::messages::{Mouse, MouseKind};
use crate::screens::Context;
use crate::screens::table::keys::TableAction;

/// A small step of the hand, in metres.
const STEP: f64 = 0.002;

/// What is said where there is nothing to take.
const NO_COIN: &str = "There is no coin under the hand.";

impl ActiveGame {
    pub(super) fn act_on_layout(&mut self, action: TableAction) {
        match action {
            TableAction::Hand(x, y) => {
                self.move_hand(STEP * DVec2::new(f64::from(x), f64::from(y)));
            }
            TableAction::TakeOrLay => self.take_or_drop(),
            TableAction::NextCoin => self.next_coin(),
            TableAction::Add(piece) => self.add(piece),
            TableAction::RemoveCoin => self.remove(),
            TableAction::Undo => {
                if self.history.undo() {
                    self.begin_turn();
                }
                if let TablePhase::Arrange(arrange) = &mut self.phase {
                    arrange.held = None;
                }
            }
            _ => {}
        }
    }

    pub(super) fn arranging_mouse(&mut self, mouse: &Mouse, cx: &Context) -> bool {
        let (at, inside) = Self::pointed(mouse, cx);
        let game = self.history.game();
        let TablePhase::Arrange(arrange) = &mut self.phase else {
            return false;
        };
        match mouse.kind {
            MouseKind::Down if inside => {
                arrange.put_hand(at, game);
                arrange.held = arrange.under(game);
            }
            MouseKind::Drag => arrange.put_hand(at, game),
            MouseKind::Up if arrange.held.is_some() => self.take_or_drop(),
            _ => return false,
        }
        true
    }

    fn move_hand(&mut self, step: DVec2) {
        let game = self.history.game();
        if let TablePhase::Arrange(arrange) = &mut self.phase {
            arrange.put_hand(arrange.hand + step, game);
        }
    }

    /// Takes the coin under the hand, or lays the held one down.
    fn take_or_drop(&mut self) {
        let game = self.history.game();
        let TablePhase::Arrange(arrange) = &mut self.phase else {
            return;
        };
        match arrange.moved(game) {
            Some(coins) => self.lay_down(coins),
            None => {
                arrange.held = arrange.under(game);
                if arrange.held.is_none() {
                    self.notice = Some(NO_COIN.into());
                }
            }
        }
    }

    /// Puts the hand over the next coin.
    fn next_coin(&mut self) {
        let game = self.history.game();
        if let TablePhase::Arrange(arrange) = &mut self.phase
            && arrange.held.is_none()
            && !game.coins().is_empty()
        {
            let next = arrange.under(game).map_or(0, |i| i + 1) % game.coins().len();
            if let Some(coin) = game.coins().get(next) {
                arrange.hand = coin.at;
            }
        }
    }

    fn add(&mut self, piece: Piece) {
        let TablePhase::Arrange(arrange) = &self.phase else {
            return;
        };
        match arrange.added(self.game(), piece) {
            Ok(coins) => drop(self.make(Move::LayOut(coins))),
            Err(GameError::TooMany { most, .. }) => {
                self.notice = Some(format!("A set has no more than {most} of these."));
            }
            Err(error) => self.notice = Some(error.to_string()),
        }
    }

    fn remove(&mut self) {
        let TablePhase::Arrange(arrange) = &self.phase else {
            return;
        };
        match arrange.taken(self.game()) {
            Some(coins) => self.lay_down(coins),
            None => self.notice = Some(NO_COIN.into()),
        }
    }

    /// Lays the coins out like this, if they can lie so; then nothing is held any more.
    fn lay_down(&mut self, coins: Vec<Coin>) {
        self.make(Move::LayOut(coins));
        if self.notice.is_none()
            && let TablePhase::Arrange(arrange) = &mut self.phase
        {
            arrange.held = None;
        }
    }
}
