//! Keeping games and what a player has done: what is asked of whoever keeps them, and
//! what comes back.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Duration;

use jiff::civil::Date;

use crate::class::{ClassChange, ClassRound};
use crate::game::{Game, SavedGame};
use crate::gradebook::HandIn;
use crate::lessons::{Bookmark, Forget};
use crate::levels::Starred;
use crate::progress::{Attempt, Calendar};

/// Something to be done with what is kept.
#[derive(Debug, Clone, PartialEq)]
pub struct StoreCall {
    /// A number of the app's own, by which the answer is known.
    pub ticket: u64,
    /// What is wanted.
    pub wish: StoreRequest,
}

/// What is wanted of a [`StoreCall`].
#[derive(Debug, Clone, PartialEq)]
pub enum StoreRequest {
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
    /// Keep the round of a class as it now stands, in place of what was kept or loaded
    /// with the same ticket before.
    SaveClass(Arc<ClassRound>),
    /// Keep what has just changed in such a round: the changes alone, if all before them is
    /// kept, and else the round.
    NoteClass {
        /// The changes.
        changes: Vec<ClassChange>,
        /// The round as it stands with them.
        round: Arc<ClassRound>,
    },
    /// Say what rounds of classes there are.
    ListClasses,
    /// Load the round of a class of this name, to be saved with the same ticket from now
    /// on.
    LoadClass(String),
    /// Remove the round of a class of this name.
    RemoveClass(String),
    /// Write the tables of a class's round where its teacher finds them.
    ExportClass(Arc<ClassRound>),
    /// Keep what somebody has handed in, unless that is there already.
    KeepHandIn(Box<HandIn>),
    /// Keep an answer, with the time. It should be safe before the explanation is shown,
    /// so nothing is drawn before it is done, unless that takes long.
    Record(Box<Attempt>),
    /// Keep the stars of a level that this player won.
    Star(String, Starred),
    /// Say what this player has done, or with no name what everyone has.
    Recall(Option<String>),
    /// Say which levels this player has won.
    Stars(String),
    /// Add what a player has done in a chapter to the bookmark there.
    Mark {
        /// The player's name.
        player: String,
        /// The id of the chapter.
        chapter: String,
        /// What was done.
        later: Box<Bookmark>,
    },
    /// Forget what this player has done in chapters.
    Forget(String, Forget),
    /// Say how far this player has read the chapters.
    Marks(String),
    /// Keep this text as the file of the settings.
    KeepSettings(String),
    /// Try once more to keep what could not be kept so far.
    Retry,
}

/// What came of a [`StoreCall`]; where it failed, the reason in words.
#[derive(Debug, Clone, PartialEq)]
pub struct StoreAnswer {
    /// The number of the request.
    pub ticket: u64,
    /// What was done.
    pub done: StoreReply,
    /// How many answers, stars and bookmarks could not be kept so far. They are kept, in
    /// their order, as soon as that is possible.
    pub owed: usize,
    /// Something else that the player should know of.
    pub notice: Option<String>,
}

/// What was done about a [`StoreRequest`].
#[derive(Debug, Clone, PartialEq)]
pub enum StoreReply {
    /// The game or the round is safe.
    Saved(Result<(), String>),
    /// The games there are, the newest first.
    Listed(Result<Vec<KeptGame>, String>),
    /// The game.
    Loaded(Result<Box<SavedGame>, String>),
    /// It is no longer there.
    Removed(Result<(), String>),
    /// Where it was written.
    Exported(Result<String, String>),
    /// What was handed in is safe, in this folder.
    HandedIn(Result<String, String>),
    /// The rounds of classes there are, the newest first.
    Classes(Result<Vec<Kept<ClassRound>>, String>),
    /// The round of a class.
    Class(Result<Box<ClassRound>, String>),
    /// The answer, the stars, the bookmark or the settings are safe, and all before them.
    Noted(Result<(), String>),
    /// What was done so far.
    Recalled(Result<Box<History>, String>),
    /// The levels that were won.
    Stars(Result<Vec<Starred>, String>),
    /// The bookmarks, by the ids of the chapters.
    Marks(Result<BTreeMap<String, Bookmark>, String>),
}

/// What was done so far.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct History {
    /// All answers, in the order in which they were given.
    pub attempts: Vec<Attempt>,
    /// The time now, and the player's days.
    pub calendar: Calendar,
}

/// One of the games or rounds that are kept.
#[derive(Debug, Clone, PartialEq)]
pub struct Kept<T> {
    /// Its name.
    pub name: String,
    /// How long ago it was saved; `None` where nobody knows the time.
    pub age: Option<Duration>,
    /// The day on which it was saved, likewise.
    pub day: Option<Date>,
    /// What it holds, or why it cannot be read.
    pub content: Result<Box<T>, String>,
}

/// A saved game with where it stands.
pub type KeptGame = Kept<(SavedGame, Game)>;

impl StoreCall {
    /// The answer that it cannot be done.
    pub fn refused(&self, reason: &str) -> StoreAnswer {
        let reason = reason.to_owned();
        StoreAnswer {
            ticket: self.ticket,
            done: match self.wish {
                StoreRequest::Save(_)
                | StoreRequest::SaveClass(_)
                | StoreRequest::NoteClass { .. } => StoreReply::Saved(Err(reason)),
                StoreRequest::List => StoreReply::Listed(Err(reason)),
                StoreRequest::Load(_) => StoreReply::Loaded(Err(reason)),
                StoreRequest::Remove(_) | StoreRequest::RemoveClass(_) => {
                    StoreReply::Removed(Err(reason))
                }
                StoreRequest::Export(_) | StoreRequest::ExportClass(_) => {
                    StoreReply::Exported(Err(reason))
                }
                StoreRequest::KeepHandIn(_) => StoreReply::HandedIn(Err(reason)),
                StoreRequest::ListClasses => StoreReply::Classes(Err(reason)),
                StoreRequest::LoadClass(_) => StoreReply::Class(Err(reason)),
                StoreRequest::Record(_)
                | StoreRequest::Star(..)
                | StoreRequest::Mark { .. }
                | StoreRequest::Forget(..)
                | StoreRequest::KeepSettings(_)
                | StoreRequest::Retry => StoreReply::Noted(Err(reason)),
                StoreRequest::Recall(_) => StoreReply::Recalled(Err(reason)),
                StoreRequest::Stars(_) => StoreReply::Stars(Err(reason)),
                StoreRequest::Marks(_) => StoreReply::Marks(Err(reason)),
            },
            owed: 0,
            notice: None,
        }
    }
}
