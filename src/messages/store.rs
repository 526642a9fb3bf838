//! Requests to the store of games and of players' progress, and the replies from the store.

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

/// A request to the store, with a ticket.
#[derive(Debug, Clone, PartialEq)]
pub struct StoreCall {
    /// A number chosen by the app, which identifies the reply.
    pub ticket: u64,
    /// The request.
    pub request: StoreRequest,
}

/// What a [`StoreCall`] asks the store to do.
#[derive(Debug, Clone, PartialEq)]
pub enum StoreRequest {
    /// Save the current state of a game or round, replacing the state that was previously saved or
    /// loaded with the same ticket.
    Save(FileContent),
    /// Save the latest changes to a class round: only the changes if everything before them has
    /// been saved, otherwise the whole round.
    NoteClass {
        /// The changes.
        changes: Vec<ClassChange>,
        /// The round after the changes.
        round: Arc<ClassRound>,
    },
    /// List the saved files of this kind.
    List(FileKind),
    /// Load the file of this kind and name, which will be saved with the same ticket from now on.
    Load(FileKind, String),
    /// Remove the file of this kind and name.
    Remove(FileKind, String),
    /// Export a game for the player, or the tables of a class round for the teacher.
    Export(FileContent),
    /// Save a hand-in, unless an identical hand-in has already been saved.
    KeepHandIn(Box<HandIn>),
    /// Make a gradebook from the hand-ins in a folder.
    Gather(HandInFolder),
    /// Save something that a player has done, after everything that is pending.
    Note(PlayerAction),
    /// List the latest hits in this player's notebook.
    Notebook(String),
    /// Load this player's answers, or everyone's answers if no name is given.
    Recall(Option<String>),
    /// List the levels that this player has won.
    Stars(String),
    /// List everyone about whom something is saved on this device.
    Players,
    /// List this player's bookmarks.
    Marks(String),
    /// Look up today's date in the player's calendar.
    Today,
    /// Save this text as the content of the settings file.
    KeepSettings(String),
    /// Try again to save everything that is pending.
    Retry,
}

/// The kinds of files that carrom saves and loads again.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileKind {
    /// Games.
    Game,
    /// Class rounds.
    Class,
}

/// The content of a file that is saved or exported.
#[derive(Debug, Clone, PartialEq)]
pub enum FileContent {
    /// A game.
    Game(Box<SavedGame>),
    /// A class round.
    Class(Arc<ClassRound>),
}

/// Something that a player has done. Actions are saved in the order in which they were done.
#[derive(Debug, Clone, PartialEq)]
pub enum PlayerAction {
    /// The player gave an answer, which is saved with the current time. It should be saved before
    /// the explanation is shown, so nothing is drawn until then, unless saving takes a long time.
    Record(Box<Attempt>),
    /// The player observed a hit; the observation is saved with the current time.
    Observe(Box<Observation>),
    /// This player added a hit to the notebook in the lab; the hit is saved with the current time.
    NoteHit(String, Box<NotedHit>),
    /// This player cleared the notebook.
    ClearNotebook(String),
    /// This player won a level with these stars.
    Star(String, Starred),
    /// A player did something in a chapter, which is added to the player's bookmark in the chapter.
    Mark {
        /// The player's name.
        player: String,
        /// The id of the chapter.
        chapter: String,
        /// The progress to add.
        later: Box<Bookmark>,
    },
    /// This player deleted progress in chapters.
    Forget(String, Forget),
}

/// The result of a [`StoreCall`]; if the call failed, the result contains the reason in words.
#[derive(Debug, Clone, PartialEq)]
pub struct StoreAnswer {
    /// The ticket of the request.
    pub ticket: u64,
    /// The reply to the request.
    pub done: StoreReply,
    /// The number of players' actions that have not been saved yet because saving failed. They will
    /// be saved in order as soon as possible.
    pub unsaved: usize,
    /// Any other information that the player should see.
    pub notice: Option<String>,
}

/// The reply to a [`StoreRequest`].
#[derive(Debug, Clone, PartialEq)]
pub enum StoreReply {
    /// The game or the class round has been saved.
    Saved(Result<(), String>),
    /// The saved games, newest first.
    Games(Result<Vec<KeptGame>, String>),
    /// The game that was loaded.
    Game(Result<Box<SavedGame>, String>),
    /// The game or the class round has been removed.
    Removed(Result<(), String>),
    /// The path of the exported file or folder.
    Exported(Result<String, String>),
    /// The hand-in has been saved in this folder.
    HandedIn(Result<String, String>),
    /// The gradebook.
    Gathered(Result<Box<GatheredBook>, String>),
    /// The saved class rounds, newest first.
    Classes(Result<Vec<Kept<ClassRound>>, String>),
    /// The class round that was loaded.
    Class(Result<Box<ClassRound>, String>),
    /// The settings have been saved; or, after a player's action or a retry, everything that was
    /// pending.
    Noted(Result<(), String>),
    /// The answers and observations so far.
    Recalled(Result<Box<History>, String>),
    /// The latest hits in the notebook, in the order in which they were made.
    Notebook(Result<Vec<NotedHit>, String>),
    /// The levels that the player has won.
    Stars(Result<Vec<Starred>, String>),
    /// The bookmarks, indexed by the ids of the chapters.
    Marks(Result<BTreeMap<String, Bookmark>, String>),
    /// Today's date; `None` if the time is unknown.
    Today(Option<Date>),
    /// The players, starting with those who answered most recently.
    Players(Result<Vec<KnownPlayer>, String>),
}

/// A folder with hand-ins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HandInFolder {
    /// The hand-ins that this carrom has received from pupils' devices.
    Devices,
    /// The folder in which carrom was started.
    Here,
    /// The downloads folder in the home folder.
    Downloads,
    /// The documents folder in the home folder.
    Documents,
    /// The desktop folder in the home folder.
    Desktop,
}

impl HandInFolder {
    /// The folders that exist on this system: a browser has only the hand-ins that it keeps itself.
    pub const ALL: &[Self] = match cfg!(target_family = "wasm") {
        true => &[Self::Devices],
        false => &[
            Self::Devices,
            Self::Here,
            Self::Downloads,
            Self::Documents,
            Self::Desktop,
        ],
    };
}

/// A gradebook for the teacher.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GatheredBook {
    /// The gradebook as an HTML page.
    pub html: String,
    /// Notes on the files, one sentence each.
    pub notes: Vec<String>,
}

/// A person about whom something is saved on this device: an answer, a star, a bookmark, a hit or
/// an observation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KnownPlayer {
    /// The name.
    pub name: String,
    /// The day of the last answer, if it is known.
    pub last: Option<Date>,
}

/// The answers and observations of one player, or of everyone, so far.
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
    /// The time since the item was saved; `None` if the time is unknown.
    pub(crate) age: Option<Duration>,
    /// The day on which the item was saved; `None` if the day is unknown.
    pub day: Option<Date>,
    /// The content of the item, or the reason why the content cannot be read.
    pub content: Result<Box<T>, String>,
}

/// A saved game and its current state.
pub type KeptGame = Kept<(SavedGame, Game)>;
