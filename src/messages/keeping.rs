//! Keeping games: what is asked of whoever keeps them, and what comes back.

use std::time::Duration;

use crate::game::{Game, SavedGame};

/// Something to be done with the games that are kept.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// A number of the app's own, by which the answer is known.
    pub ticket: u64,
    /// What is wanted.
    pub wish: Wish,
}

/// What is wanted of a [`Request`].
#[derive(Debug, Clone, PartialEq)]
pub enum Wish {
    /// Keep a game as it now stands, in place of what was kept or loaded with the
    /// same ticket before.
    Save(Box<SavedGame>),
    /// Say what games there are.
    List,
    /// Load the game of this name, to be saved with the same ticket from now on.
    Load(String),
    /// Remove the game of this name.
    Remove(String),
    /// Write a game where its player finds it.
    Export(Box<SavedGame>),
}

/// What came of a [`Request`]; where it failed, the reason in words.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// The number of the request.
    pub ticket: u64,
    /// What was done.
    pub done: Done,
}

/// What was done about a [`Wish`].
#[derive(Debug, Clone, PartialEq)]
pub enum Done {
    /// The game is safe.
    Saved(Result<(), String>),
    /// The games there are, the newest first.
    Listed(Result<Vec<Kept>, String>),
    /// The game.
    Loaded(Result<Box<SavedGame>, String>),
    /// It is no longer there.
    Removed(Result<(), String>),
    /// Where it was written.
    Exported(Result<String, String>),
}

/// One of the games that are kept.
#[derive(Debug, Clone, PartialEq)]
pub struct Kept {
    /// Its name.
    pub name: String,
    /// How long ago it was saved; `None` where nobody knows the time.
    pub age: Option<Duration>,
    /// The game with where it stands, or why it cannot be read.
    pub game: Result<Box<(SavedGame, Game)>, String>,
}

impl Request {
    /// The answer that it cannot be done.
    pub fn refused(&self, reason: &str) -> Answer {
        let reason = reason.to_owned();
        Answer {
            ticket: self.ticket,
            done: match self.wish {
                Wish::Save(_) => Done::Saved(Err(reason)),
                Wish::List => Done::Listed(Err(reason)),
                Wish::Load(_) => Done::Loaded(Err(reason)),
                Wish::Remove(_) => Done::Removed(Err(reason)),
                Wish::Export(_) => Done::Exported(Err(reason)),
            },
        }
    }
}
