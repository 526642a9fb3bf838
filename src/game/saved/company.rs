//! Who plays, and with what help.

use serde::{Deserialize, Serialize};

use crate::files::{is_invisible, tidy_name};
use crate::game::opponent::Strength;

/// Who plays from a seat.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Player {
    /// Somebody at the keyboard.
    Person,
    /// The computer.
    Computer,
}

/// Helps drawn while aiming, each to be switched on or off.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Aids {
    /// The way of the striker to the first disc it meets.
    pub line: bool,
    /// The striker as it will stand when it meets it.
    pub ghost: bool,
    /// Where both will leave that hit.
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

/// Who plays, and with what help: what a game needs beside its setup to go on as it
/// began.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Company {
    /// Who plays from each seat, in the order of [`Seat::ALL`](crate::game::Seat::ALL).
    pub players: [Player; 4],
    /// How strong the computer is at each seat, in the same order.
    pub strengths: [Strength; 4],
    /// Whether the players call the first impact before each stroke.
    pub call: bool,
    /// Helps while aiming.
    pub aids: Aids,
}

/// One thing for each seat by name, as a file has them.
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

/// Whether this can be shown as the name of a player: 1 to 40 letters, all of them
/// visible.
pub fn is_player_name(name: &str) -> bool {
    !tidy_name(name).is_empty() && name.chars().count() <= 40 && !name.chars().any(is_invisible)
}
