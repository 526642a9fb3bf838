//! Boards for one player: six coins to clear in the fewest strokes. A code determines each board,
//! which is the same on every machine. The code of a day is its date, so everyone plays the same
//! board on that day.

use std::fmt;

use glam::DVec2;
use jiff::civil::Date;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use serde::{Serialize, Serializer};

use super::pieces::{Coin, GAP, Piece, PieceSet};
use super::{GameSetup, Length, Rules};
use crate::physics::Board;

/// The number of coins on a board.
const COINS: usize = 6;
/// How far from the centre a coin may lie to the right or left, in mm.
const SIDE_MM: i32 = 300;
/// How far below and above the centre a coin may lie, in mm: beyond the player's own base lines,
/// and with room for the striker between the coin and the opposite cushion.
const HEIGHT_MM: (i32, i32) = (-190, 300);
/// The smallest number that is the code of a day; smaller codes are those of other boards.
const FIRST_DAY: u32 = 20_000_101;
/// The largest code that is not that of a day.
const MOST: u32 = 999_999;

/// The code of a board: a day, or a number up to 999999.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BoardCode(u32);

/// The text or number is not the code of a board.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error(
    "expected the code of a board: a day from 2000 on, such as 2026-11-26, or a number up to 999999"
)]
pub struct NotABoard;

impl BoardCode {
    /// The code of a day.
    ///
    /// # Errors
    /// Returns an error if the day is before 2000.
    pub fn of_day(day: Date) -> Result<Self, NotABoard> {
        let [year, month, day] = [i64::from(day.year()), day.month().into(), day.day().into()];
        Self::from_number((year * 100 + month) * 100 + day)
    }

    /// The code with this number; the number of a day consists of the digits of its date, as in
    /// 20261126.
    ///
    /// # Errors
    /// Returns an error if there is no such code.
    pub fn from_number(number: i64) -> Result<Self, NotABoard> {
        let code = Self(u32::try_from(number).map_err(|_| NotABoard)?);
        match code.0 {
            1..=MOST => Ok(code),
            FIRST_DAY.. if code.day().is_some() => Ok(code),
            _ => Err(NotABoard),
        }
    }

    /// Reads a typed code.
    ///
    /// # Errors
    /// Returns an error if the text is not a code.
    pub fn parse(text: &str) -> Result<Self, NotABoard> {
        let text = text.trim();
        match text.parse::<Date>() {
            Ok(day) if day.to_string() == text => Self::of_day(day),
            _ if text.bytes().all(|it| it.is_ascii_digit()) => {
                Self::from_number(text.parse().map_err(|_| NotABoard)?)
            }
            _ => Err(NotABoard),
        }
    }

    /// The day whose code this is; `None` if it is the code of another board.
    pub fn day(self) -> Option<Date> {
        let part = |by: u32, of: u32| i8::try_from(self.0 / by % of).ok();
        let year = i16::try_from(self.0 / 10_000).ok()?;
        let day = Date::new(year, part(100, 100)?, part(1, 100)?).ok();
        day.filter(|_| self.0 >= FIRST_DAY)
    }

    /// The name of the board: "board of 26 November 2026", or "board 4711".
    pub fn title(self) -> String {
        match self.day() {
            Some(day) => format!("board of {}", day.strftime("%-d %B %Y")),
            None => format!("board {}", self.0),
        }
    }

    /// A result to share: "carrom, board of 26 November 2026, 5 strokes, par 4".
    pub fn result(self, strokes: usize, par: Option<usize>) -> String {
        let strokes = crate::numbers::counted(strokes, "stroke");
        let par = par.map_or(String::new(), |par| format!(", par {par}"));
        format!("carrom, {}, {strokes}{par}", self.title())
    }

    /// The seed in the setup of every game on this board.
    pub const fn seed(self) -> u64 {
        self.0 as u64
    }

    /// The setup of a game on this board.
    pub fn setup(self) -> GameSetup {
        GameSetup {
            rules: Rules::Solo,
            length: Length::Board,
            seed: Some(self.seed()),
            ..GameSetup::default()
        }
    }

    /// The coins of the board in their initial positions.
    pub fn coins(self) -> Vec<Coin> {
        let apart = 2.0 * PieceSet::default().coin_radius() + GAP;
        let board = Board::default();
        let mut dice = Pcg64::seed_from_u64(self.seed());
        let mut coins: Vec<Coin> = Vec::new();
        while coins.len() < COINS {
            let x = dice.random_range(-SIDE_MM..=SIDE_MM);
            let y = dice.random_range(HEIGHT_MM.0..=HEIGHT_MM.1);
            let at = DVec2::new(x.into(), y.into()) / 1000.0;
            let is_free = |other: &Coin| other.at.distance(at) >= apart;
            if coins.iter().all(is_free) && !board.has_pocket_at(at) {
                coins.push(Coin {
                    piece: Piece::White,
                    at,
                });
            }
        }
        coins
    }
}

impl GameSetup {
    /// The code of its board, if the rules are those of a board for one player.
    pub fn board_code(&self) -> Option<BoardCode> {
        let seed = self.seed.filter(|_| self.rules == Rules::Solo)?;
        BoardCode::from_number(i64::try_from(seed).ok()?).ok()
    }
}

impl Serialize for BoardCode {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_str(self)
    }
}

impl fmt::Display for BoardCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.day() {
            Some(day) => write!(f, "{day}"),
            None => write!(f, "{}", self.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::validity::check_coins;
    use super::*;

    #[test]
    fn a_code_is_a_day_or_a_short_number() {
        for (typed, shown) in [
            ("2026-11-26", "2026-11-26"),
            ("20261126", "2026-11-26"),
            (" 4711 ", "4711"),
            ("000007", "7"),
            ("999999", "999999"),
            ("2000-01-01", "2000-01-01"),
            ("9999-12-31", "9999-12-31"),
            ("2028-02-29", "2028-02-29"),
        ] {
            let code = BoardCode::parse(typed).expect(typed);
            assert_eq!(code.to_string(), shown);
            assert_eq!(BoardCode::parse(shown), Ok(code));
        }
        for typed in [
            "",
            "0",
            "-5",
            "1000000",
            "20261301",
            "20270229",
            "2027-02-29",
            "1999-12-31",
            "19991231",
            "99999999999999999999",
            "2026-11-26T10:00",
            "4.5",
            "x",
            "४७",
        ] {
            assert_eq!(BoardCode::parse(typed), Err(NotABoard), "{typed}");
        }
    }

    #[test]
    fn a_board_has_a_name_and_a_result() {
        let code = |text| BoardCode::parse(text).unwrap();
        assert_eq!(
            code("2026-11-06").result(5, Some(4)),
            "carrom, board of 6 November 2026, 5 strokes, par 4"
        );
        assert_eq!(code("4711").result(1, None), "carrom, board 4711, 1 stroke");
    }

    #[test]
    fn the_coins_of_every_board_lie_legally_and_differ() {
        let mut seen = std::collections::BTreeSet::new();
        for number in 1..=2000 {
            let code = BoardCode::from_number(number).unwrap();
            let coins = code.coins();
            assert_eq!(coins.len(), COINS);
            assert_eq!(check_coins(&coins, PieceSet::default()), Ok(()));
            assert_eq!(coins, code.coins());
            let game = super::super::Game::new(code.setup());
            assert_eq!(game.coins(), coins);
            assert!(game.base_lines().nearest(DVec2::ZERO).is_some());
            let places = coins.iter().map(|coin| format!("{}", coin.at));
            assert!(seen.insert(places.collect::<String>()), "{number}");
        }
    }
}
