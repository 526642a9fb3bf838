//! Searching for a stroke, which takes longer than a frame.

use crate::game::Game;
use crate::game::opponent::{Decision, Strength, StrokeHint};

/// A search to be made by the shell, beside the app if it can.
#[derive(Debug, Clone, PartialEq)]
pub struct SearchTask {
    /// A number of its own, by which the answer is known.
    pub ticket: u64,
    /// The game as it stands.
    pub game: Game,
    /// What is left to chance.
    pub seed: u64,
    /// What is wanted.
    pub wanted: Wanted,
}

/// What is wanted of a [`SearchTask`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wanted {
    /// The stroke of an opponent of this strength.
    Stroke(Strength),
    /// A hint for the player.
    Hint,
}

/// What came of a [`SearchTask`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SearchResult {
    /// The number of the task.
    pub ticket: u64,
    /// What was found.
    pub found: Found,
}

/// What was found; `None` if there is no stroke to be played.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Found {
    /// The opponent's stroke.
    Stroke(Option<Decision>),
    /// The hint.
    Hint(Option<StrokeHint>),
    /// Neither: the search failed.
    Failed,
}

impl SearchTask {
    /// The result of a search that failed.
    pub const fn failed(&self) -> SearchResult {
        SearchResult {
            ticket: self.ticket,
            found: Found::Failed,
        }
    }
}
