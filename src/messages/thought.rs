//! Thinking: a stroke to be found by search, which takes longer than a frame.

use crate::game::Game;
use crate::game::opponent::{self, Decision, Hint, Strength};
use crate::physics::Board;

/// Something to think about. The shell does it, beside the app if it can.
#[derive(Debug, Clone, PartialEq)]
pub struct Task {
    /// A number of its own, by which the answer is known.
    pub ticket: u64,
    /// The game as it stands.
    pub game: Game,
    /// What is left to chance.
    pub seed: u64,
    /// What is wanted.
    pub wanted: Wanted,
}

/// What is wanted of a [`Task`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wanted {
    /// The stroke of an opponent of this strength.
    Stroke(Strength),
    /// A hint for the player.
    Hint,
}

/// What came of a [`Task`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thought {
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
    Hint(Option<Hint>),
    /// Neither: whoever thought has failed.
    Failed,
}

impl Task {
    /// What came of it where whoever thought has failed.
    pub const fn failed(&self) -> Thought {
        Thought {
            ticket: self.ticket,
            found: Found::Failed,
        }
    }

    /// Thinks. The same task always leads to the same thought.
    pub fn think(&self) -> Thought {
        let board = Board::default();
        let found = match self.wanted {
            Wanted::Stroke(strength) => {
                Found::Stroke(opponent::think(&self.game, &board, strength, self.seed))
            }
            Wanted::Hint => Found::Hint(opponent::hint(&self.game, &board, self.seed)),
        };
        Thought {
            ticket: self.ticket,
            found,
        }
    }
}
