//! The record of a game, move by move, from which the engine and the laws can replay the game bit
//! for bit.

use glam::DVec2;
use serde::de::{Error as _, Unexpected};
use serde::{Deserialize, Deserializer, Serialize};
use strum::IntoStaticStr;
use thiserror::Error;

use super::laws::Ruling;
use super::pieces::{Coin, metres};
use super::placing::Misplaced;
use super::stroke::{Stroke, StrokeError};
use super::table::{Game, GameSetup};
use super::validity::GameError;
use crate::physics::{self, EngineError, Limits, Motion, Shot};

/// The agreed settings and every move since. Everything else follows from them.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// The settings that were agreed before the first break.
    pub setup: GameSetup,
    /// The moves, in order; each is checked when it is [made](Move::make).
    pub moves: Vec<Move>,
}

/// A move by a player.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, IntoStaticStr)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum Move {
    /// Plays a stroke.
    Strike(Strike),
    /// Passes the turn, because coins block every position of the striker.
    NoPlace,
    /// Sets up the pack for the next board.
    NextBoard,
    /// Places the coins as given, in a practice game.
    LayOut(Vec<Coin>),
}

/// How the striker was struck.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Strike {
    /// The striker's position, in metres from the centre of the board.
    #[serde(rename = "place_m", with = "metres")]
    pub place: DVec2,
    /// The striker's velocity in m/s.
    #[serde(rename = "velocity_m_s", with = "metres")]
    pub velocity: DVec2,
    /// The player's prediction of the first impact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub call: Option<Call>,
}

/// The predicted directions after the first impact, in degrees from the striker's direction, with
/// the signs of [`physics::CollisionOutcome`]: the striker's positive anticlockwise, the coin's
/// positive clockwise. `None` means that the disc is at rest after the impact.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Call {
    /// Scattering angle of the striker.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "angle")]
    pub striker_deg: Option<f64>,
    /// Recoil angle of the coin.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "angle")]
    pub coin_deg: Option<f64>,
}

/// Reads an angle in degrees. A file may contain any number, but a player can type only nine
/// digits.
fn angle<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    let degrees = f64::deserialize(from)?;
    let found = Unexpected::Float(degrees);
    match degrees.abs() < 1e9 {
        true => Ok(Some(degrees)),
        false => Err(D::Error::invalid_value(found, &"an angle in degrees")),
    }
}

/// Why a move cannot be made.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum MoveError {
    /// The striker may not be placed there.
    #[error(transparent)]
    Place(#[from] Misplaced),
    /// The engine cannot play the stroke.
    #[error("this stroke cannot be played: {0}")]
    Engine(#[from] EngineError),
    /// The stroke is impossible on this board.
    #[error(transparent)]
    Stroke(#[from] StrokeError),
    /// The game does not allow the move.
    #[error(transparent)]
    Game(#[from] GameError),
    /// The turn cannot be passed, because there is a legal position for the striker.
    #[error("there is a legal position for the striker on the base lines")]
    RoomLeft,
}

/// Why a record cannot be played: one of its moves is impossible.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error("move {number}: {error}")]
pub struct RecordError {
    /// The number of the move, from 1.
    pub number: usize,
    /// Why the move is impossible.
    #[source]
    pub error: MoveError,
}

impl Record {
    /// A game in which nobody has moved yet.
    pub const fn new(setup: GameSetup) -> Self {
        Self {
            setup,
            moves: Vec::new(),
        }
    }

    /// The number of moves that are strokes.
    pub fn strokes(&self) -> usize {
        self.moves.iter().filter_map(Move::strike).count()
    }

    /// Plays the whole record and returns the resulting game.
    ///
    /// # Errors
    /// Returns the first fault in the record.
    pub fn replay(&self) -> Result<Game, RecordError> {
        self.play_through(|_, _, _, _| {})
    }

    /// Plays the whole record and reports each move: the game before it, the move, its shot if it
    /// was a stroke, and the referee's rulings.
    ///
    /// # Errors
    /// Returns the first fault in the record.
    pub fn play_through(
        &self,
        mut each: impl FnMut(Game, &Move, Option<Shot>, Vec<Ruling>),
    ) -> Result<Game, RecordError> {
        let mut game = Game::new(self.setup);
        for (i, next) in self.moves.iter().enumerate() {
            let before = game.clone();
            let (shot, rulings) = next.make(&mut game).map_err(|error| RecordError {
                number: i + 1,
                error,
            })?;
            each(before, next, shot, rulings);
        }
        Ok(game)
    }
}

impl Move {
    /// The stroke, if the move is one.
    pub(crate) fn strike(&self) -> Option<&Strike> {
        match self {
            Self::Strike(strike) => Some(strike),
            Self::NoPlace | Self::NextBoard | Self::LayOut(_) => None,
        }
    }

    /// Makes the move and returns the shot, if it was a stroke, and the referee's rulings.
    ///
    /// # Errors
    /// Returns the reason if the move cannot be made; the game is then unchanged.
    pub fn make(&self, game: &mut Game) -> Result<(Option<Shot>, Vec<Ruling>), MoveError> {
        match self {
            Self::Strike(strike) => {
                let shot = strike.shot(game)?;
                let stroke = Stroke::from_shot(game.coins(), &shot)?;
                let rulings = game.apply(&stroke)?;
                return Ok((Some(shot), rulings));
            }
            Self::NoPlace => {
                if game.base_lines().nearest(DVec2::ZERO).is_some() {
                    return Err(MoveError::RoomLeft);
                }
                return Ok((None, game.no_place()?));
            }
            Self::NextBoard => game.next_board()?,
            Self::LayOut(coins) => game.lay_out(coins.clone())?,
        }
        Ok((None, Vec::new()))
    }
}

impl From<Motion> for Strike {
    /// The stroke that gives the striker this motion, without a call.
    fn from(striker: Motion) -> Self {
        Self {
            place: striker.position,
            velocity: striker.velocity,
            call: None,
        }
    }
}

impl Strike {
    /// The shot of this stroke on the current board.
    ///
    /// # Errors
    /// Returns an error if the striker may not be placed there or the engine cannot play the
    /// stroke.
    pub fn shot(&self, game: &Game) -> Result<Shot, MoveError> {
        game.check_place(self.place)?;
        let (discs, motions) = game.discs(Motion::new(self.place, self.velocity));
        Ok(physics::play(
            &game.board(),
            &discs,
            &motions,
            Limits::default(),
        )?)
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64;

    use super::super::{Fingerprint, Hands, Rules};
    use super::*;

    /// A record of random strokes from legal positions, continued on the next boards.
    fn played(setup: GameSetup, strokes: usize, seed: u64) -> (Record, Game) {
        let mut hand = Pcg64::seed_from_u64(seed);
        let mut record = Record::new(setup);
        let mut game = Game::new(setup);
        for _ in 0..strokes {
            let lines = game.base_lines();
            let wanted = lines.at(hand.random_range(-0.2..0.2));
            let next = match lines.nearest(wanted) {
                _ if game.play().won.is_some() => Move::NextBoard,
                None => Move::NoPlace,
                Some(place) => {
                    let way = DVec2::from_angle(hand.random_range(0.0..3.1));
                    Move::Strike(Strike {
                        place,
                        velocity: game.seat().turn(way) * hand.random_range(0.5..5.0),
                        call: hand.random_bool(0.5).then_some(Call {
                            striker_deg: None,
                            coin_deg: Some(12.3),
                        }),
                    })
                }
            };
            if next.make(&mut game).is_err() {
                break;
            }
            record.moves.push(next);
        }
        (record, game)
    }

    #[test]
    fn a_record_leads_to_the_same_game_bit_for_bit() {
        for (seed, hands, rules) in [
            (1, Hands::Two, Rules::Tournament),
            (2, Hands::Four, Rules::Tournament),
            (3, Hands::Two, Rules::Friendly),
        ] {
            let setup = GameSetup {
                rules,
                hands,
                seed: Some(seed),
                ..GameSetup::default()
            };
            let (record, game) = played(setup, 60, seed);
            assert!(record.moves.len() > 20);
            assert_eq!(record.replay().unwrap(), game);
            // Equality ignores the sign of zero; the fingerprint includes every bit.
            let again = record.replay().unwrap();
            assert_eq!(Fingerprint::of(&again), Fingerprint::of(&game));
        }
    }

    #[test]
    fn an_impossible_record_is_refused_with_the_move_at_fault() {
        let mut record = Record::new(GameSetup::default());
        let breaking = Strike {
            place: DVec2::new(0.0, -0.2526),
            velocity: DVec2::new(0.0, 4.0),
            call: None,
        };
        record.moves.push(Move::Strike(breaking));
        assert!(record.replay().is_ok());
        record.moves.push(Move::NextBoard);
        assert_eq!(
            record.replay(),
            Err(RecordError {
                number: 2,
                error: GameError::StillPlaying.into()
            })
        );
        for (place, velocity) in [
            (DVec2::ZERO, DVec2::Y),
            (DVec2::NAN, DVec2::Y),
            (breaking.place, DVec2::NAN),
        ] {
            let strike = Strike {
                place,
                velocity,
                call: None,
            };
            let mut game = Game::new(GameSetup::default());
            assert!(Move::Strike(strike).make(&mut game).is_err());
            assert_eq!(game, Game::new(GameSetup::default()));
        }
    }
}
