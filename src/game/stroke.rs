//! What the laws need to know of a stroke.

use glam::DVec2;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::pieces::{Coin, Piece, count};

/// A stroke as the referee sees it: what was touched, what fell and what lies
/// where afterwards. How it came about is the engine's business.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Stroke {
    /// Whether the striker touched any piece.
    pub touched: bool,
    /// The pieces that fell into pockets, in order; the striker among them if
    /// it fell too.
    pub pocketed: Vec<Piece>,
    /// The coins left on the board, where they came to rest.
    pub left: Vec<Coin>,
}

/// Why a stroke cannot be one of this board.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum StrokeError {
    /// Pieces appeared or vanished.
    #[error(
        "before the stroke there were {before} pieces of this kind ({piece}), after it {after}"
    )]
    Miscounted {
        /// The kind of piece.
        piece: Piece,
        /// How many lay on the board.
        before: u8,
        /// How many lie there now or were pocketed.
        after: u8,
    },
    /// The striker was pocketed more than once, or left lying as a coin.
    #[error("there is only one striker, and it is lifted after the stroke")]
    Striker,
    /// A coin fell though the striker is said to have touched none.
    #[error("a coin cannot fall when the striker touched none")]
    Untouched,
    /// A coin is said to lie off the board.
    #[error("a coin cannot come to rest off the board")]
    OffTheBoard,
    /// A disc number has no disc.
    #[error("there is no disc {0} on this board")]
    NoSuchDisc(usize),
    /// The board or the match has ended.
    #[error("this board has ended; start the next one")]
    Ended,
}

impl Stroke {
    /// The stroke from the end of a shot in which disc 0 was the striker and
    /// disc i + 1 was `coins[i]`.
    ///
    /// `pocketed` lists the discs that fell, in order; `ends` gives the final
    /// centre of every disc in metres.
    ///
    /// # Errors
    /// [`StrokeError::NoSuchDisc`] if a number or a position is missing.
    pub fn from_discs(
        coins: &[Coin],
        touched: bool,
        pocketed: &[usize],
        ends: &[DVec2],
    ) -> Result<Self, StrokeError> {
        let piece = |disc: &usize| match disc.checked_sub(1) {
            None => Ok(Piece::Striker),
            Some(i) => coins
                .get(i)
                .map(|coin| coin.piece)
                .ok_or(StrokeError::NoSuchDisc(*disc)),
        };
        let fallen = pocketed.iter().map(piece).collect::<Result<_, _>>()?;
        let mut left = Vec::with_capacity(coins.len());
        for (disc, coin) in (1..).zip(coins) {
            if !pocketed.contains(&disc) {
                let at = *ends.get(disc).ok_or(StrokeError::NoSuchDisc(disc))?;
                left.push(Coin { at, ..*coin });
            }
        }
        Ok(Self {
            touched,
            pocketed: fallen,
            left,
        })
    }

    /// How many of `piece` fell.
    pub fn fallen(&self, piece: Piece) -> u8 {
        let found = self.pocketed.iter().filter(|p| **p == piece).count();
        u8::try_from(found).unwrap_or(u8::MAX)
    }

    /// Whether this stroke could have been played on `before`, on a board
    /// whose frame is `side` metres.
    ///
    /// # Errors
    /// What does not fit.
    pub fn check(&self, before: &[Coin], side: f64) -> Result<(), StrokeError> {
        if self.fallen(Piece::Striker) > 1 || count(&self.left, Piece::Striker) > 0 {
            return Err(StrokeError::Striker);
        }
        for piece in [Piece::White, Piece::Black, Piece::Queen] {
            let was = count(before, piece);
            let after = count(&self.left, piece).saturating_add(self.fallen(piece));
            if was != after {
                return Err(StrokeError::Miscounted {
                    piece,
                    before: was,
                    after,
                });
            }
        }
        if !self.touched && self.pocketed.iter().any(|p| *p != Piece::Striker) {
            return Err(StrokeError::Untouched);
        }
        let inside = |coin: &Coin| coin.at.abs().max_element() <= side / 2.0 && coin.at.is_finite();
        if !self.left.iter().all(inside) {
            return Err(StrokeError::OffTheBoard);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::pack::pack;
    use super::super::pieces::PieceSet;
    use super::super::seat::Seat;
    use super::*;

    const SIDE: f64 = 0.740;

    #[test]
    fn discs_become_pieces_in_the_order_they_fell() {
        let coins = pack(PieceSet::Tournament, Seat::South);
        let ends = vec![DVec2::new(0.1, 0.1); 20];
        let stroke = Stroke::from_discs(&coins, true, &[1, 0, 3], &ends).unwrap();
        assert_eq!(
            stroke.pocketed,
            [Piece::Queen, Piece::Striker, coins[2].piece]
        );
        assert_eq!(stroke.left.len(), 17);
        assert_eq!(stroke.check(&coins, SIDE), Ok(()));
        assert_eq!(
            Stroke::from_discs(&coins, true, &[20], &ends),
            Err(StrokeError::NoSuchDisc(20))
        );
        assert_eq!(
            Stroke::from_discs(&coins, true, &[], &ends[..5]),
            Err(StrokeError::NoSuchDisc(5))
        );
    }

    #[test]
    fn a_stroke_that_cannot_be_is_refused_with_the_reason() {
        let coins = pack(PieceSet::Tournament, Seat::South);
        let missed = Stroke {
            touched: false,
            pocketed: vec![],
            left: coins.clone(),
        };
        assert_eq!(missed.check(&coins, SIDE), Ok(()));

        let mut lost = missed.clone();
        lost.left.pop();
        assert_eq!(
            lost.check(&coins, SIDE),
            Err(StrokeError::Miscounted {
                piece: Piece::Black,
                before: 9,
                after: 8
            })
        );
        lost.pocketed.push(Piece::Black);
        assert_eq!(lost.check(&coins, SIDE), Err(StrokeError::Untouched));

        let mut away = missed.clone();
        away.left[3].at.x = f64::NAN;
        assert_eq!(away.check(&coins, SIDE), Err(StrokeError::OffTheBoard));

        let mut twice = missed;
        twice.pocketed = vec![Piece::Striker; 2];
        assert_eq!(twice.check(&coins, SIDE), Err(StrokeError::Striker));
    }
}
