//! Laying coins out, in practice.

use glam::DVec2;

use super::{ActiveGame, TablePhase};
use crate::game::{Coin, GameError, Move};
use crate::messages::{Mouse, MouseKind};
use crate::screens::Context;
use crate::screens::table::keys::TableAction;

/// A small step of the hand, in metres.
const STEP: f64 = 0.002;

/// What is said where there is nothing to take.
const NO_COIN: &str = "There is no coin under the hand.";

impl ActiveGame {
    pub(super) fn act_on_layout(&mut self, action: TableAction) {
        let game = self.history.game();
        let TablePhase::Arrange(arrange) = &mut self.phase else {
            return;
        };
        match action {
            TableAction::Hand(x, y) => {
                let step = STEP * DVec2::new(f64::from(x), f64::from(y));
                arrange.put_hand(arrange.hand + step, game);
            }
            TableAction::TakeOrLay => self.take_or_drop(),
            TableAction::NextCoin => arrange.reach_next(game),
            TableAction::Add(piece) => match arrange.added(game, piece) {
                Ok(coins) => drop(self.make(Move::LayOut(coins))),
                Err(GameError::TooMany { most, .. }) => {
                    self.notice = Some(format!("A set has no more than {most} of these."));
                }
                Err(error) => self.notice = Some(error.to_string()),
            },
            TableAction::RemoveCoin => match arrange.taken(game) {
                Some(coins) => self.lay_down(coins),
                None => self.notice = Some(NO_COIN.into()),
            },
            TableAction::Undo => {
                arrange.held = None;
                if self.history.undo() {
                    self.begin_turn();
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
