//! Laying coins out, in practice.

use glam::DVec2;

use super::{Phase, Sitting, Taken};
use crate::game::{Coin, GameError, Move, Piece};
use crate::messages::{Key, Mouse, MouseKind};
use crate::physics::Board;
use crate::screens::Context;
use crate::screens::table::view;
use crate::widgets::board;

/// Steps of the hand, in metres.
const STEPS: (f64, f64) = (0.002, 0.02);

impl Sitting {
    pub(super) fn arranging_key(&mut self, key: Key) -> Taken {
        match key {
            Key::Right => self.move_hand(STEPS.1 * DVec2::X),
            Key::Left => self.move_hand(-STEPS.1 * DVec2::X),
            Key::Up => self.move_hand(STEPS.1 * DVec2::Y),
            Key::Down => self.move_hand(-STEPS.1 * DVec2::Y),
            Key::Char('d' | 'D') => self.move_hand(STEPS.0 * DVec2::X),
            Key::Char('a' | 'A') => self.move_hand(-STEPS.0 * DVec2::X),
            Key::Char('w' | 'W') => self.move_hand(STEPS.0 * DVec2::Y),
            Key::Char('s' | 'S') => self.move_hand(-STEPS.0 * DVec2::Y),
            Key::Char(' ') | Key::Enter => self.take_or_drop(),
            Key::Tab => self.next_coin(),
            Key::Char('o' | 'O') => self.add(Piece::White),
            Key::Char('b' | 'B') => self.add(Piece::Black),
            Key::Char('q' | 'Q') => self.add(Piece::Queen),
            Key::Char('x' | 'X') | Key::Delete | Key::Backspace => self.remove(),
            Key::Char('z' | 'Z') => {
                if self.session.undo() {
                    self.begin_turn();
                }
                if let Phase::Arrange(arrange) = &mut self.phase {
                    arrange.held = None;
                }
            }
            Key::Escape | Key::Char('p' | 'P') => self.phase = Phase::Aim,
            _ => return Taken::Ignored,
        }
        Taken::Used
    }

    pub(super) fn arranging_mouse(&mut self, mouse: &Mouse, cx: &Context) -> Taken {
        let area = board::square(view::layout(cx.body, false).picture);
        let at = board::view(area, &Board::default()).world_at(mouse.column, mouse.row);
        let inside = area.contains((mouse.column, mouse.row).into());
        let game = self.session.game();
        let Phase::Arrange(arrange) = &mut self.phase else {
            return Taken::Ignored;
        };
        match mouse.kind {
            MouseKind::Down if inside => {
                arrange.put_hand(at, game);
                arrange.held = arrange.under(game);
            }
            MouseKind::Drag => arrange.put_hand(at, game),
            MouseKind::Up if arrange.held.is_some() => self.take_or_drop(),
            _ => return Taken::Ignored,
        }
        Taken::Used
    }

    fn move_hand(&mut self, step: DVec2) {
        let game = self.session.game();
        if let Phase::Arrange(arrange) = &mut self.phase {
            arrange.put_hand(arrange.hand + step, game);
        }
    }

    /// Takes the coin under the hand, or lays the held one down.
    fn take_or_drop(&mut self) {
        let game = self.session.game();
        let Phase::Arrange(arrange) = &mut self.phase else {
            return;
        };
        match arrange.moved(game) {
            Some(coins) => {
                if self.lay(coins)
                    && let Phase::Arrange(arrange) = &mut self.phase
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
        let game = self.session.game();
        if let Phase::Arrange(arrange) = &mut self.phase
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
        let Phase::Arrange(arrange) = &self.phase else {
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
        let Phase::Arrange(arrange) = &self.phase else {
            return;
        };
        let Some(coins) = arrange.taken(self.game()) else {
            self.notice = Some("There is no coin under the hand.".into());
            return;
        };
        if self.lay(coins)
            && let Phase::Arrange(arrange) = &mut self.phase
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
