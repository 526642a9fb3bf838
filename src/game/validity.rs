//! What no game can be: asked of one that was read from a file, and of coins
//! that were laid out by hand.

use thiserror::Error;

use super::laws::{MOST_POINTS, Rules};
use super::pieces::{COINS_EACH, Coin, Piece, PieceSet, count};
use super::score::Score;
use super::seat::Team;
use super::table::Game;
use crate::physics::Board;

/// Overlap that rounding may leave between coins at rest, in metres: as much as
/// the engine allows.
const SLACK: f64 = 1e-10;

/// Why a game cannot be what it is said to be, or do what it is asked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum GameError {
    /// The board has not ended yet.
    #[error("this board has not ended yet")]
    StillPlaying,
    /// The match is over.
    #[error("the match is over; start a new one")]
    MatchOver,
    /// Coins may be laid out freely only in practice.
    #[error("coins may be laid out freely only in practice")]
    NotInPractice,
    /// There are more coins than a set holds.
    #[error("there are {found} pieces of this kind ({piece}) on the board, and a set has {most}")]
    TooMany {
        /// The kind of piece.
        piece: Piece,
        /// How many lie there.
        found: u8,
        /// How many there can be.
        most: u8,
    },
    /// Two coins overlap.
    #[error("two coins overlap")]
    Overlap,
    /// A coin lies off the board.
    #[error("a coin lies off the board")]
    OffTheBoard,
    /// Nobody sits where the turn is.
    #[error("nobody sits where the turn is")]
    EmptySeat,
    /// The queen is covered and on the board at once.
    #[error("the queen cannot be covered while she lies on the board")]
    QueenTwice,
    /// A coin is owed though there is one to pay with.
    #[error("a coin is owed although there is one in the pockets to pay with")]
    UnpaidDue,
    /// All coins of a colour are pocketed, yet the board goes on.
    #[error("a colour has no coins left, yet the board has not ended")]
    NotEnded,
    /// A board brings at most 12 points (28).
    #[error("a board cannot bring {0} points; 12 is the most")]
    Points(u8),
    /// A board follows the end of the match.
    #[error("a board was played after the match had ended")]
    AfterTheMatch,
}

impl Game {
    /// Whether this can be a game at all: what to ask of one that was read from
    /// a file.
    ///
    /// # Errors
    /// The first thing that is wrong.
    pub fn check(&self) -> Result<(), GameError> {
        let play = &self.play;
        let over = play.won.is_some();
        check_coins(self.coins(), self.setup.set)?;
        if !(self.setup.hands.plays(play.seat) && self.setup.hands.plays(self.setup.first_breaker))
        {
            return Err(GameError::EmptySeat);
        }
        if play.queen_on_board() && play.queen_covered_by.is_some() {
            return Err(GameError::QueenTwice);
        }
        for team in Team::BOTH {
            let colour = self.colour(team);
            if play.owed(team) > 0 && play.in_pockets(colour) > 0 {
                return Err(GameError::UnpaidDue);
            }
            let cleared = play.on_board(colour) == 0;
            if cleared && !over && self.setup.rules != Rules::Practice {
                return Err(GameError::NotEnded);
            }
        }
        let boards = || self.finished.iter().chain(play.won.as_ref());
        if let Some(won) = boards().find(|won| won.points > MOST_POINTS) {
            return Err(GameError::Points(won.points));
        }
        for played in 1..=self.finished.len() {
            let score = Score::after(self.setup.rules, self.finished.iter().take(played));
            if score.match_winner(self.setup.rules).is_some() {
                return Err(GameError::AfterTheMatch);
            }
        }
        Ok(())
    }
}

/// Whether coins can lie like this.
pub(super) fn check_coins(coins: &[Coin], set: PieceSet) -> Result<(), GameError> {
    for (piece, most) in [
        (Piece::White, COINS_EACH),
        (Piece::Black, COINS_EACH),
        (Piece::Queen, 1),
        (Piece::Striker, 0),
    ] {
        let found = count(coins, piece);
        if found > most {
            return Err(GameError::TooMany { piece, found, most });
        }
    }
    let reach = Board::default().side / 2.0 - set.coin_radius() + SLACK;
    let inside = |coin: &Coin| coin.at.is_finite() && coin.at.abs().max_element() <= reach;
    if !coins.iter().all(inside) {
        return Err(GameError::OffTheBoard);
    }
    let apart = 2.0 * set.coin_radius() - SLACK;
    for (i, coin) in coins.iter().enumerate() {
        let overlaps = |other: &Coin| other.at.distance(coin.at) < apart;
        if coins.iter().skip(i + 1).any(overlaps) {
            return Err(GameError::Overlap);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::super::laws::BoardWon;
    use super::super::seat::{Hands, Seat};
    use super::super::table::Setup;
    use super::*;

    fn spoilt(spoil: impl FnOnce(&mut Game)) -> Result<(), GameError> {
        let mut game = Game::new(Setup::default());
        assert_eq!(game.check(), Ok(()));
        spoil(&mut game);
        game.check()
    }

    #[test]
    fn each_thing_that_no_game_can_be_is_named() {
        let white = |at| Coin {
            piece: Piece::White,
            at,
        };
        let won = |points| BoardWon {
            winner: Team::First,
            points,
        };
        assert_eq!(
            spoilt(|game| game.play.coins.push(white(DVec2::splat(0.2)))),
            Err(GameError::TooMany {
                piece: Piece::White,
                found: 10,
                most: 9
            })
        );
        assert_eq!(
            spoilt(|game| game.play.coins[3].at = game.play.coins[4].at),
            Err(GameError::Overlap)
        );
        for off in [0.36, f64::NAN, f64::INFINITY] {
            assert_eq!(
                spoilt(|game| game.play.coins[3].at.y = off),
                Err(GameError::OffTheBoard)
            );
        }
        assert_eq!(
            spoilt(|game| game.play.seat = Seat::East),
            Err(GameError::EmptySeat)
        );
        assert_eq!(
            spoilt(|game| game.play.queen_covered_by = Some(Team::Second)),
            Err(GameError::QueenTwice)
        );
        assert_eq!(
            spoilt(|game| {
                game.play.coins.pop();
                game.play.owed[Team::Second] = 1;
            }),
            Err(GameError::UnpaidDue)
        );
        assert_eq!(
            spoilt(|game| game.play.coins.retain(|coin| coin.piece != Piece::Black)),
            Err(GameError::NotEnded)
        );
        assert_eq!(
            spoilt(|game| game.play.won = Some(won(13))),
            Err(GameError::Points(13))
        );
        assert_eq!(
            spoilt(|game| game.finished = vec![won(12); 6]),
            Err(GameError::AfterTheMatch)
        );
    }

    #[test]
    fn doubles_may_be_broken_from_any_side_and_singles_from_two() {
        for seat in Seat::ALL {
            for hands in [Hands::Two, Hands::Four] {
                let game = Game::new(Setup {
                    hands,
                    first_breaker: seat,
                    ..Setup::default()
                });
                assert_eq!(game.check(), Ok(()));
                assert_eq!(hands.plays(seat), game.seat() == seat);
            }
        }
    }
}
