//! The requests that a game refuses, and impossible positions of coins.

use thiserror::Error;

use super::pieces::{COINS_EACH, Coin, Piece, PieceSet, count};
use super::placing::SLACK;
use crate::physics::Board;

/// Why a game refuses a request.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum GameError {
    /// The board has not ended yet.
    #[error("this board has not ended yet")]
    StillPlaying,
    /// The match is over.
    #[error("the match is over; start a new one")]
    MatchOver,
    /// Coins may be placed freely only in a practice game.
    #[error("coins may be placed freely only in a practice game")]
    NotInPractice,
    /// There are more coins than a set holds.
    #[error("there are {found} pieces of this kind ({piece}) on the board, and a set has {most}")]
    TooMany {
        /// The kind of piece.
        piece: Piece,
        /// How many are on the board.
        found: u8,
        /// How many the set has.
        most: u8,
    },
    /// Two coins overlap.
    #[error("two coins overlap")]
    Overlap,
    /// A coin is off the board.
    #[error("a coin is off the board")]
    OffTheBoard,
}

/// Checks that coins can be at these positions.
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
