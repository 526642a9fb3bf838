//! Laying coins out, in practice.

use glam::DVec2;

use super::{ActiveGame, TablePhase};
use crate::game::{Coin, GameError, Move, Piece};
use crate::messages::{Mouse, MouseKind};
use crate::physics::Board;
use crate::screens::Context;
use crate::screens::table::keys::TableAction;
use crate::screens::table::view;
use crate::widgets::board;

/// A small step of the hand, in metres.
const STEP: f64 = 0.002;

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
        let area = board::square(view::layout(cx.body, false).picture);
        let at = board::view(area, &Board::default()).world_at(mouse.column, mouse.row);
        let inside = area.contains((mouse.column, mouse.row).into());
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
            Some(coins) => {
                if self.lay(coins)
                    && let TablePhase::Arrange(arrange) = &mut self.phase
                {
                    arrange.held = None;
                }
            }
            None => {
                arrange.held = arrange.under(game);
                if arrange.held.is_none() {
                    self.notice = Some("There is no coin under the hand.".into());
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
            Ok(coins) => {
                self.lay(coins);
            }
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
        let Some(coins) = arrange.taken(self.game()) else {
            self.notice = Some("There is no coin under the hand.".into());
            return;
        };
        if self.lay(coins)
            && let TablePhase::Arrange(arrange) = &mut self.phase
        {
            arrange.held = None;
        }
    }

    /// Lays the coins out like this, if they can lie so.
    fn lay(&mut self, coins: Vec<Coin>) -> bool {
        self.make(Move::LayOut(coins));
        self.notice.is_none()
    }
}
