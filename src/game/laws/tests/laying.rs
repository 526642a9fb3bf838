//! A table set up to test one law, and a stroke on it.

use glam::DVec2;

use super::validity::flaw;
use crate::game::laws::ending::MOST_POINTS;
use crate::game::laws::{BoardWon, Rules, Ruling, RulingEffect, Taken};
use crate::game::pieces::{Coin, Colour, Piece};
use crate::game::seat::{Hands, Seat, Team};
use crate::game::stroke::Stroke;
use crate::game::table::{Game, GameSetup};

/// Where the queen is when a test begins.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Queen {
    OnBoard,
    ToCover,
    White,
    Black,
}

/// A table at which South plays white and it is South's turn.
pub(super) struct Table(pub(super) Game);

/// Sets up a singles board after the break: these numbers of coins are left, the others are in the
/// pockets, South plays white, and it is South's turn.
pub(super) fn table(white: u8, black: u8, queen: Queen) -> Table {
    lay(Rules::Tournament, white, black, queen)
}

/// Sets up a board like [`table`], under the given rules. In point carrom, South has pocketed all
/// the missing coins.
pub(super) fn lay(rules: Rules, white: u8, black: u8, queen: Queen) -> Table {
    let mut game = Game::new(GameSetup {
        rules,
        hands: Hands::Two,
        ..GameSetup::default()
    });
    let play = &mut game.play;
    play.break_tries = None;
    let mut left = [
        (Piece::White, white),
        (Piece::Black, black),
        (Piece::Queen, u8::from(queen == Queen::OnBoard)),
    ];
    play.coins.retain(|coin| {
        left.iter_mut()
            .find(|(piece, more)| *piece == coin.piece && *more > 0)
            .map(|(_, more)| *more -= 1)
            .is_some()
    });
    spread(&mut play.coins);
    play.pocketed_before[Team::First] = white < 9;
    play.pocketed_before[Team::Second] = black < 9;
    if rules == Rules::Points {
        play.taken[Team::First] = Taken::default().with(9 - white, 9 - black);
    }
    play.queen_covered_by = match queen {
        Queen::White => Some(Team::First),
        Queen::Black => Some(Team::Second),
        Queen::OnBoard | Queen::ToCover => None,
    };
    assert_eq!(flaw(&game), None);
    Table(game)
}

/// Moves coins out of the outer circle into rows of ten.
pub(super) fn spread(coins: &mut [Coin]) {
    for (i, coin) in (0_i32..).zip(coins) {
        let (column, row) = (f64::from(i % 10), f64::from(i / 10));
        coin.at = DVec2::new(0.05 * column - 0.225, 0.15 + 0.05 * row);
    }
}

impl Table {
    /// Gives South and North these points from earlier boards.
    pub(super) fn score(mut self, south: u8, north: u8) -> Self {
        // Four earlier boards are recorded, so that the break is South's again.
        for (winner, points) in [(Team::First, south), (Team::Second, north)] {
            let most = points.min(MOST_POINTS);
            for points in [most, points - most] {
                self.0.finished.push(BoardWon { winner, points });
            }
        }
        self
    }

    /// Makes White owe `dues` coins.
    pub(super) fn white_owes(mut self, dues: u8) -> Self {
        self.0.play.owed[Team::First] = dues;
        self
    }

    /// Records that White has pocketed coins before, although all white coins are back on the
    /// board.
    pub(super) fn white_has_pocketed_before(mut self) -> Self {
        self.0.play.pocketed_before[Team::First] = true;
        self
    }

    /// Plays a stroke that touches something and pockets `fallen`.
    pub(super) fn pocket(&mut self, fallen: &[Piece]) -> Vec<Ruling> {
        self.strike(true, fallen)
    }

    pub(super) fn strike(&mut self, touched: bool, fallen: &[Piece]) -> Vec<Ruling> {
        let stroke = stroke(self.0.coins(), touched, fallen);
        let rulings = self.0.apply(&stroke).unwrap();
        assert_eq!(flaw(&self.0), None);
        rulings
    }

    pub(super) fn on_board(&self, colour: Colour) -> u8 {
        self.0.play().on_board(colour)
    }

    pub(super) fn turn_continues(&self) -> bool {
        self.0.seat() == Seat::South
    }
}

/// A stroke that pockets `fallen` and leaves the other coins where they were.
pub(super) fn stroke(coins: &[Coin], touched: bool, fallen: &[Piece]) -> Stroke {
    let mut left = coins.to_vec();
    for piece in fallen.iter().filter(|piece| **piece != Piece::Striker) {
        let i = left.iter().position(|coin| coin.piece == *piece).unwrap();
        left.remove(i);
    }
    Stroke {
        touched,
        pocketed: fallen.to_vec(),
        left,
    }
}

/// The numbers of the laws that were announced.
pub(super) fn cited(rulings: &[Ruling]) -> Vec<String> {
    rulings
        .iter()
        .map(|ruling| ruling.law.map_or("house".to_owned(), |law| law.to_string()))
        .collect()
}

/// The pieces that were put back.
pub(super) fn put_back(rulings: &[Ruling]) -> Vec<Piece> {
    rulings
        .iter()
        .flat_map(|ruling| &ruling.effects)
        .filter_map(|effect| match effect {
            RulingEffect::PutBack(coin) => Some(coin.piece),
            _ => None,
        })
        .collect()
}

/// Asserts which law decided, which pieces were put back and who strikes next.
#[track_caller]
pub(super) fn expect(
    table: &Table,
    rulings: &[Ruling],
    law: &str,
    back: &[Piece],
    turn_continues: bool,
) {
    assert_eq!(cited(rulings)[0], law, "{}", rulings[0].text);
    assert_eq!(put_back(rulings), back);
    assert_eq!(table.turn_continues(), turn_continues);
    assert_eq!(table.0.play().won, None);
}

/// Asserts which law decided the board, who won it and by how much.
#[track_caller]
pub(super) fn expect_end(rulings: &[Ruling], law: &str, winner: Team, points: u8) {
    assert_eq!(cited(rulings)[0], law, "{}", rulings[0].text);
    let won = BoardWon { winner, points };
    assert_eq!(
        rulings[0].effects.last(),
        Some(&RulingEffect::BoardWon(won))
    );
}
