//! The players of a game and their aids.

use serde::{Deserialize, Serialize};

use crate::files::{is_invisible, short_name, tidy_name};
use crate::game::Seat;
use crate::game::opponent::{PlayerHand, Strength};

/// The kind of player at a seat.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Player {
    /// A person at the keyboard.
    #[default]
    Person,
    /// The computer.
    Computer,
}

/// Aids that are drawn while a player is aiming; each can be turned on or off.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Aids {
    /// The striker's path to the first disc it hits.
    pub line: bool,
    /// The striker's position at that contact.
    pub ghost: bool,
    /// Both paths after that collision.
    pub rays: bool,
}

impl Default for Aids {
    fn default() -> Self {
        Self {
            line: true,
            ghost: true,
            rays: true,
        }
    }
}

/// The players and their aids. A saved game contains them so that it continues as before.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Company {
    /// The player at each seat, in the order of [`Seat::ALL`](crate::game::Seat::ALL).
    pub players: [Player; 4],
    /// The computer's strength at each seat, in the same order.
    pub strengths: [Strength; 4],
    /// The names of two people who share the keyboard.
    pub names: SeatNames,
    /// How steady the human players' hands are; the resulting errors are already part of the
    /// recorded strokes.
    pub hand: PlayerHand,
    /// Whether the players predict the first impact before each stroke.
    pub call: bool,
    /// The aids that are drawn while a player is aiming.
    pub aids: Aids,
}

/// The names of two people who share the keyboard; either may be empty.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct SeatNames {
    south: String,
    north: String,
}

impl SeatNames {
    /// The maximum number of letters in a name: two names and a score fit above the board in a
    /// window of 80×24.
    pub const LONGEST: usize = 12;

    /// The name of the person at a seat; empty if there is none.
    pub fn of(&self, seat: Seat) -> &str {
        match seat {
            Seat::South => &self.south,
            Seat::North => &self.north,
            Seat::East | Seat::West => "",
        }
    }

    /// Sets the name of the person at South or North.
    pub fn set(&mut self, seat: Seat, name: &str) {
        match seat {
            Seat::South => name.clone_into(&mut self.south),
            Seat::North => name.clone_into(&mut self.north),
            Seat::East | Seat::West => {}
        }
    }

    /// The names as they are shown and saved: only visible letters, no spaces at the ends.
    pub fn tidied(&self) -> Self {
        Self {
            south: short_name(&self.south, Self::LONGEST),
            north: short_name(&self.north, Self::LONGEST),
        }
    }
}

/// One value for each seat, in fields named after the seats, as they are saved in a file.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct BySeat<T> {
    south: T,
    east: T,
    north: T,
    west: T,
}

impl<T> From<[T; 4]> for BySeat<T> {
    fn from([south, east, north, west]: [T; 4]) -> Self {
        Self {
            south,
            east,
            north,
            west,
        }
    }
}

impl<T> From<BySeat<T>> for [T; 4] {
    fn from(seats: BySeat<T>) -> Self {
        [seats.south, seats.east, seats.north, seats.west]
    }
}

/// Whether this is valid as a player's name: 1 to 40 visible characters.
pub fn is_player_name(name: &str) -> bool {
    !tidy_name(name).is_empty() && name.chars().count() <= 40 && !name.chars().any(is_invisible)
}
