//! Requests to the store of games and of players' progress, and the answers of the store.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Duration;

use jiff::civil::Date;

use crate::class::{ClassChange, ClassRound};
use crate::game::{Game, SavedGame};
use crate::gradebook::HandIn;
use crate::lessons::{Bookmark, Forget};
use crate::levels::Starred;
use crate::progress::{Attempt, Calendar, NotedHit, Observation};

/// A request to the store, with its ticket.
#[derive(Debug, Clone, PartialEq)]
pub struct StoreCall {
    /// A number chosen by the app, which identifies the answer.
    pub ticket: u64,
    /// The request.
    pub request: StoreRequest,
}

/// What a [`StoreCall`] asks the store to do.
#[derive(Debug, Clone, PartialEq)]
pub enum StoreRequest {
    /// Save the current state of a game, replacing what was saved or loaded with the same ticket
    /// before.
    Save(Box<SavedGame>),
    /// List the saved games.
    List,
    /// Load the game of this name, to be saved with the same ticket from now on.
    Load(String),
    /// Remove the game of this name.
    Remove(String),
    /// Export a game for its player.
    Export(Box<SavedGame>),
    /// Save the current state of a class round, replacing what was saved or loaded with the same
    /// ticket before.
    SaveClass(Arc<ClassRound>),
    /// Save the latest changes of such a round: the changes alone if everything before them is
    /// saved, otherwise the whole round.
    NoteClass {
        /// The changes.
        changes: Vec<ClassChange>,
        /// The round after these changes.
        round: Arc<ClassRound>,
    },
    /// List the saved class rounds.
    ListClasses,
    /// Load the class round of this name, to be saved with the same ticket from now on.
    LoadClass(String),
    /// Remove the class round of this name.
    RemoveClass(String),
    /// Export the tables of a class round for its teacher.
    ExportClass(Arc<ClassRound>),
    /// Save a hand-in, unless the same one exists already.
    KeepHandIn(Box<HandIn>),
    /// Save an answer, with the time. The answer should be saved before the explanation is shown,
    /// so nothing is drawn until then, unless saving takes a long time.
    Record(Box<Attempt>),
    /// Save what a player saw in a hit, with the time.
    Observe(Box<Observation>),
    /// Add a hit to this player's notebook of the lab, with the time.
    NoteHit(String, Box<NotedHit>),
    /// List the latest hits in this player's notebook.
    Notebook(String),
    /// Delete all hits in this player's notebook.
    ClearNotebook(String),
    /// Save the stars of a level that this player has won.
    Star(String, Starred),
    /// Load this player's answers, or everyone's if there is no name.
    Recall(Option<String>),
    /// List the levels that this player has won.
    Stars(String),
    /// List everyone who has done something here.
    Players,
    /// Add what a player has done in a chapter to its bookmark.
    Mark {
        /// The player's name.
        player: String,
        /// The id of the chapter.
        chapter: String,
        /// The progress to add.
        later: Box<Bookmark>,
    },
    /// Delete this player's progress in chapters.
    Forget(String, Forget),
    /// List this player's bookmarks.
    Marks(String),
    /// Look up today's date in the player's calendar.
    Today,
    /// Save this text as the settings file.
    KeepSettings(String),
    /// Try again to save what is pending.
    Retry,
}

/// The result of a [`StoreCall`]; after a failure, the reason in words.
#[derive(Debug, Clone, PartialEq)]
pub struct StoreAnswer {
    /// The ticket of the request.
    pub ticket: u64,
    /// The reply to the request.
    pub done: StoreReply,
    /// The number of answers, stars, bookmarks and hits that could not be saved so far. They will
    /// be saved in order as soon as possible.
    pub unsaved: usize,
    /// Something else that the player should know.
    pub notice: Option<String>,
}

/// The reply to a [`StoreRequest`].
#[derive(Debug, Clone, PartialEq)]
pub enum StoreReply {
    /// The game or the round has been saved.
    Saved(Result<(), String>),
    /// The saved games, newest first.
    Listed(Result<Vec<KeptGame>, String>),
    /// The game.
    Loaded(Result<Box<SavedGame>, String>),
    /// The game or the round has been removed.
    Removed(Result<(), String>),
    /// The path of the exported file or folder.
    Exported(Result<String, String>),
    /// The hand-in has been saved in this folder.
    HandedIn(Result<String, String>),
    /// The saved class rounds, newest first.
    Classes(Result<Vec<Kept<ClassRound>>, String>),
    /// The round of a class.
    Class(Result<Box<ClassRound>, String>),
    /// The answer, the stars, the bookmark, the hit or the settings have been saved, after everything that
    /// was pending before them.
    Noted(Result<(), String>),
    /// The answers so far.
    Recalled(Result<Box<History>, String>),
    /// The hits in the notebook, in the order in which they were made.
    Notebook(Result<Vec<NotedHit>, String>),
    /// The levels that were won.
    Stars(Result<Vec<Starred>, String>),
    /// The bookmarks, by the ids of the chapters.
    Marks(Result<BTreeMap<String, Bookmark>, String>),
    /// Today's date; `None` if the time is unknown.
    Today(Option<Date>),
    /// The players, those who answered last first.
    Players(Result<Vec<KnownPlayer>, String>),
}

/// Somebody who has answered, read or won something here.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KnownPlayer {
    /// The name.
    pub name: String,
    /// The day of the last answer, if that is known.
    pub last: Option<Date>,
}

/// A player's answers and observations so far.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct History {
    /// All answers, in the order in which they were given.
    pub attempts: Vec<Attempt>,
    /// All observations of hits, in the order in which they were made.
    pub observations: Vec<Observation>,
    /// The current time, and the player's calendar days.
    pub calendar: Calendar,
}

/// A saved game or class round.
#[derive(Debug, Clone, PartialEq)]
pub struct Kept<T> {
    /// The name of the item.
    pub name: String,
    /// How long ago the item was saved; `None` if the time is unknown.
    pub(crate) age: Option<Duration>,
    /// The day on which the item was saved; `None` if the day is unknown.
    pub day: Option<Date>,
    /// The contents, or the reason why they cannot be read.
    pub content: Result<Box<T>, String>,
}

/// A saved game and its current state.
pub type KeptGame = Kept<(SavedGame, Game)>;
