//! A saved game: its record, who plays, and a fingerprint of the resulting state.
//!
//! The file is TOML, one move per line. A truncated file is never valid: `end` comes last and is
//! required.

mod company;
mod fingerprint;
mod read;
mod text;

pub use company::{Aids, Company, Player, SeatNames, is_player_name};
pub use fingerprint::Fingerprint;

use super::record::Record;

/// The format of new files. In format 1, `setup` had no `restitution`. Before format 3, it had no
/// `length`, and there was no `hand`, no names of two people and no boards for one player.
const FORMAT: u32 = 3;

/// A saved game.
#[derive(Debug, Clone, PartialEq)]
pub struct SavedGame {
    /// Name of the player at the keyboard.
    pub player: String,
    /// The players and their aids.
    pub company: Company,
    /// The record of the moves.
    pub record: Record,
    /// The indices, from 0, of the moves that were made with a hint.
    pub hints: Vec<usize>,
    /// The fingerprint of the resulting state.
    pub end: Fingerprint,
}

impl SavedGame {
    /// The largest file that is read or written, in bytes: about eight thousand strokes.
    pub(crate) const LARGEST_FILE: usize = 1 << 20;
}

/// The game has too many moves for a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the game has become too long for one file")]
pub struct TooLarge;
