//! The facts about a stroke that the laws use.

use thiserror::Error;

use super::pieces::{Coin, Piece, count, pocketed};
use crate::physics::{Board, DiscState, Shot};

/// A stroke as the referee sees it: whether the striker touched a piece, what fell and where the
/// other coins came to rest. The engine determines these facts.
#[derive(Debug, Clone, PartialEq)]
pub struct Stroke {
    /// Whether the striker touched any piece.
    pub(crate) touched: bool,
    /// The pieces that fell into pockets, in order, including the striker if it fell.
    pub pocketed: Vec<Piece>,
    /// The coins left on the board, where they came to rest.
    pub left: Vec<Coin>,
}

/// Why a stroke is impossible on this board.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum StrokeError {
    /// Pieces appeared or vanished.
    #[error(
        "before the stroke there were {before} pieces of this kind ({piece}), after it {after}"
    )]
    Miscounted {
        /// The kind of piece.
        piece: Piece,
        /// How many were on the board before the stroke.
        before: u8,
        /// How many are on the board after the stroke or were pocketed.
        after: u8,
    },
    /// The striker was pocketed more than once, or is on the board as a coin.
    #[error("there is only one striker, and it is lifted after the stroke")]
    Striker,
    /// A coin was pocketed although the striker touched no coin.
    #[error("a coin cannot fall if the striker touched none")]
    Untouched,
    /// A coin is off the board.
    #[error("a coin cannot come to rest off the board")]
    OffTheBoard,
    /// The shot was not played with the discs of this board.
    #[error("the shot has {found} discs, but this board has {expected}")]
    OtherDiscs {
        /// The number of coins on the board, plus one for the striker.
        expected: usize,
        /// The number of discs in the shot.
        found: usize,
    },
    /// The board or the match has ended.
    #[error("this board has ended; start the next one")]
    Ended,
}

impl Stroke {
    /// The stroke of `shot`, whose disc 0 is the striker and whose disc i + 1 is the coin
    /// `coins[i]`, as in [`Game::discs`](super::Game::discs).
    ///
    /// # Errors
    /// Returns `StrokeError::OtherDiscs` if the shot has more or fewer discs.
    pub fn from_shot(coins: &[Coin], shot: &Shot) -> Result<Self, StrokeError> {
        let (expected, found) = (coins.len() + 1, shot.discs().len());
        if found != expected {
            return Err(StrokeError::OtherDiscs { expected, found });
        }
        let mut events = shot.events().iter();
        let left = coins
            .iter()
            .zip(shot.final_states().skip(1))
            .filter(|(_, end)| end.state != DiscState::Pocketed)
            .map(|(coin, end)| Coin {
                at: end.position,
                ..*coin
            });
        Ok(Self {
            touched: events.any(|event| event.kind.partner(0).is_some()),
            pocketed: pocketed(coins, shot),
            left: left.collect(),
        })
    }

    /// How many of `piece` fell.
    pub(crate) fn fallen(&self, piece: Piece) -> u8 {
        let found = self.pocketed.iter().filter(|p| **p == piece).count();
        u8::try_from(found).unwrap_or(u8::MAX)
    }

    /// Whether this stroke could have been played on `before`.
    ///
    /// # Errors
    /// Returns the first contradiction that is found.
    pub fn check(&self, before: &[Coin]) -> Result<(), StrokeError> {
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
        let half = Board::default().side / 2.0;
        let inside = |coin: &Coin| coin.at.abs().max_element() <= half && coin.at.is_finite();
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
    use super::super::{Game, GameSetup, Rules};
    use super::*;
    use crate::physics::{self, Board, Limits, Motion};
    use glam::DVec2;

    #[test]
    fn a_shot_gives_the_pieces_that_fell_and_the_positions_of_the_others() {
        let coin = |piece, x: f64, y: f64| Coin {
            piece,
            at: DVec2::new(x, y),
        };
        let mut game = Game::new(GameSetup {
            rules: Rules::Practice,
            ..GameSetup::default()
        });
        // The black coin is on the line from the striker to the top right pocket.
        let coins = vec![
            coin(Piece::Queen, -0.2, 0.0),
            coin(Piece::Black, 0.25, 0.25),
        ];
        game.lay_out(coins.clone()).unwrap();
        let play = |velocity| {
            let (discs, motions) = game.discs(Motion {
                position: DVec2::ZERO,
                velocity,
            });
            let shot = physics::play(&Board::default(), &discs, &motions, Limits::default());
            Stroke::from_shot(&coins, &shot.unwrap())
        };
        let hit = play(DVec2::splat(1.1)).unwrap();
        assert!(hit.touched);
        assert_eq!(hit.pocketed[0], Piece::Black);
        assert_eq!(hit.left, coins[..1]);
        assert_eq!(hit.check(&coins), Ok(()));

        let miss = play(DVec2::new(0.3, 0.0)).unwrap();
        assert!(!miss.touched);
        assert_eq!(miss.left, coins);
        assert_eq!(
            Stroke::from_shot(&coins, &Shot::default()),
            Err(StrokeError::OtherDiscs {
                expected: 3,
                found: 0
            })
        );
    }

    #[test]
    fn an_impossible_stroke_is_refused_with_the_reason() {
        let coins = pack(PieceSet::Tournament, Seat::South);
        let missed = Stroke {
            touched: false,
            pocketed: vec![],
            left: coins.clone(),
        };
        assert_eq!(missed.check(&coins), Ok(()));

        let mut lost = missed.clone();
        lost.left.pop();
        assert_eq!(
            lost.check(&coins),
            Err(StrokeError::Miscounted {
                piece: Piece::Black,
                before: 9,
                after: 8
            })
        );
        lost.pocketed.push(Piece::Black);
        assert_eq!(lost.check(&coins), Err(StrokeError::Untouched));

        let mut away = missed.clone();
        away.left[3].at.x = f64::NAN;
        assert_eq!(away.check(&coins), Err(StrokeError::OffTheBoard));

        let mut twice = missed;
        twice.pocketed = vec![Piece::Striker; 2];
        assert_eq!(twice.check(&coins), Err(StrokeError::Striker));
    }
}
