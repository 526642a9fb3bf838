//! The pieces, the sets of pieces, and the lines drawn on the board.
//!
//! Lengths are in metres, and masses in kilograms. Where the Laws of Carrom give a range for a
//! piece, the upper end is used. Base circles, centre circle and outer circle have their customary
//! sizes. Side, pockets and friction are those of the default [`Board`](crate::physics::Board).

use std::fmt;

use glam::DVec2;
use serde::{Deserialize, Serialize};
use strum::{Display, IntoStaticStr};

use crate::physics::{Disc, Shot};

/// The number of coins of each colour on a full board.
pub(crate) const COINS_EACH: u8 = 9;

/// Distance from the frame to the outer base line: 10.15 cm.
pub(crate) const BASE_LINE_FROM_FRAME: f64 = 0.1015;
/// Distance between the two base lines of a side: 3.18 cm.
pub(crate) const BASE_LINE_GAP: f64 = 0.0318;
/// Length of a pair of base lines with the circles that close it: 47 cm.
pub(crate) const BASE_LINE_LENGTH: f64 = 0.470;
/// Radius of a base circle, 1.59 cm: its diameter is the distance between the lines.
pub(crate) const BASE_CIRCLE_RADIUS: f64 = 0.0159;
/// Radius of the centre circle, 1.59 cm: the queen fits into it.
pub(crate) const CENTRE_CIRCLE_RADIUS: f64 = 0.0159;
/// Radius of the outer circle, 8.5 cm: it encloses the pack (14), and coins are put back inside it.
pub(crate) const OUTER_CIRCLE_RADIUS: f64 = 0.085;
/// The gap between coins in the opening pack, 0.1 mm: an impact of discs that touch exactly has no
/// unique result.
pub(crate) const GAP: f64 = 0.0001;

/// One of the four kinds of piece; as text, a short name such as "white".
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "lowercase")]
pub enum Piece {
    /// The disc that is struck.
    Striker,
    /// A coin of the side that breaks (16).
    White,
    /// A coin of the other side (16).
    Black,
    /// The red coin, common to both sides (16).
    Queen,
}

impl fmt::Display for Piece {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Striker => "striker",
            Self::White => "white coin",
            Self::Black => "black coin",
            Self::Queen => "queen",
        })
    }
}

/// The colour that a team plays on a board; it also names the players, as in "White wins".
#[derive(Debug, Clone, Copy, PartialEq, Eq, Display)]
pub enum Colour {
    /// The side that breaks has the white coins (16).
    White,
    /// The other side has the black coins.
    Black,
}

impl Colour {
    /// The other colour.
    pub const fn other(self) -> Self {
        match self {
            Self::White => Self::Black,
            Self::Black => Self::White,
        }
    }

    /// The coin of this colour.
    pub const fn piece(self) -> Piece {
        match self {
            Self::White => Piece::White,
            Self::Black => Piece::Black,
        }
    }

    /// The colour as an adjective: "white".
    pub(crate) fn adjective(self) -> &'static str {
        self.piece().into()
    }
}

/// A coin or the queen on the board.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Coin {
    /// The kind of piece; never the striker.
    pub piece: Piece,
    /// The centre of the piece, in metres from the centre of the board.
    #[serde(rename = "at_m", with = "metres")]
    pub at: DVec2,
}

/// How many of `coins` are of the kind `piece`.
pub(crate) fn count(coins: &[Coin], piece: Piece) -> u8 {
    let found = coins.iter().filter(|coin| coin.piece == piece).count();
    u8::try_from(found).unwrap_or(u8::MAX)
}

/// The piece of a disc in a shot: disc 0 is the striker, disc i + 1 the coin `coins[i]`.
pub(crate) fn piece_of(coins: &[Coin], disc: usize) -> Option<Piece> {
    match disc.checked_sub(1) {
        None => Some(Piece::Striker),
        Some(i) => coins.get(i).map(|coin| coin.piece),
    }
}

/// The pieces that fell in a shot played with these coins, in order, including the striker if it
/// fell.
pub(crate) fn pocketed(coins: &[Coin], shot: &Shot) -> Vec<Piece> {
    let fallen = shot.fallen();
    fallen.filter_map(|disc| piece_of(coins, disc)).collect()
}

/// Stores a point or a velocity as a pair of numbers in SI units, which are read back bit for bit.
pub(super) mod metres {
    use glam::DVec2;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub(in crate::game) fn serialize<S: Serializer>(at: &DVec2, to: S) -> Result<S::Ok, S::Error> {
        at.to_array().serialize(to)
    }

    pub(in crate::game) fn deserialize<'de, D: Deserializer<'de>>(
        from: D,
    ) -> Result<DVec2, D::Error> {
        <[f64; 2]>::deserialize(from).map(DVec2::from_array)
    }
}

/// The set of discs used in a game.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PieceSet {
    /// Tournament pieces: striker 15 g and 41.3 mm across, coins 5.5 g and 31.8 mm across.
    #[default]
    Tournament,
    /// Tournament sizes with a mass of 15 g for every piece, so that the paths of striker and coin
    /// are at right angles after an elastic collision.
    EqualMass,
}

impl PieceSet {
    /// The disc of a piece in this set.
    pub(crate) const fn disc(self, piece: Piece) -> Disc {
        match (piece, self) {
            (Piece::Striker, _) => Disc::from_g_mm(15.0, 20.65),
            (_, Self::Tournament) => Disc::from_g_mm(5.5, 15.9),
            (_, Self::EqualMass) => Disc::from_g_mm(15.0, 15.9),
        }
    }

    /// Radius of the striker in metres.
    pub(crate) const fn striker_radius(self) -> f64 {
        self.disc(Piece::Striker).radius
    }

    /// Radius of a coin or the queen in metres.
    pub(crate) const fn coin_radius(self) -> f64 {
        self.disc(Piece::White).radius
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_striker_on_the_middle_of_the_base_lines_touches_both_and_covers_a_base_circle() {
        for set in [PieceSet::Tournament, PieceSet::EqualMass] {
            assert!(set.striker_radius() > BASE_LINE_GAP / 2.0);
            assert!(set.striker_radius() > BASE_CIRCLE_RADIUS);
        }
    }

    #[test]
    fn sizes_and_masses_are_within_the_laws() {
        let striker = PieceSet::Tournament.disc(Piece::Striker);
        assert!(striker.mass <= 0.015 && 2.0 * striker.radius <= 0.0413);
        let coin = PieceSet::Tournament.disc(Piece::Queen);
        assert!((0.00525..=0.0055).contains(&coin.mass));
        assert!((0.0302..=0.0318).contains(&(2.0 * coin.radius)));
    }
}
