//! A game as it is kept in a file: its record, who plays, and a fingerprint of what
//! it leads to.
//!
//! The file is TOML, a move a line. A beginning of it is never a whole one: `end`
//! comes last and cannot be left out.

mod company;
mod fingerprint;
mod read;
mod text;

pub use company::{Aids, Company, Player, is_player_name};
pub use fingerprint::Fingerprint;

use super::record::Record;

/// The format of the files that are written now.
const FORMAT: u32 = 1;

/// A game as it is kept in a file.
#[derive(Debug, Clone, PartialEq)]
pub struct SavedGame {
    /// Name of the player at the keyboard.
    pub player: String,
    /// Who plays.
    pub company: Company,
    /// All that was done.
    pub record: Record,
    /// The moves that were made with a hint, by their numbers from 0.
    pub hints: Vec<usize>,
    /// What the game it leads to looks like.
    pub end: Fingerprint,
}

impl SavedGame {
    /// Largest file that is read, and so the largest that may be written, in bytes:
    /// some eight thousand strokes.
    pub(crate) const LARGEST_FILE: usize = 1 << 20;
}

/// A game of so many strokes that no file may hold it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the game has become too long for one file")]
pub struct TooLarge;
