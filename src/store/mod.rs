//! Stored data. Saved games, class rounds, exports and hand-ins have one file each; answers, levels
//! won, bookmarks and the lab's notebook are in a database.
//!
//! Several copies of carrom may keep their games in one folder, any of them may be killed at any
//! moment, and any file may be damaged or belong to another program. So:
//!
//! - a file is written under a temporary name, synced to the disk and then renamed, so that
//!   there is always either the old file or the new one;
//! - a file is replaced only while it still has the text that this store last wrote or read;
//!   otherwise the game or round moves to a new file;
//! - a file is not trusted until all of it has been replayed.

mod database;
mod disk;
mod folder_lock;
mod forget;
mod kept_elsewhere;
mod memory;
mod open_files;
mod text_store;

use std::collections::VecDeque;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use jiff::Timestamp;
use jiff::tz::{Offset, TimeZone};

use crate::class::{ClassChange, ClassRound, answers_csv, appended, items_csv};
use crate::files::{self, Existing};
use crate::game::{Game, SavedGame};
use crate::gradebook::{Gradebook, HandIn};
use crate::messages::{
    FileContent, FileKind, GatheredBook, HandInFolder, History, KnownPlayer, PlayerAction,
    StoreAnswer, StoreCall, StoreReply, StoreRequest,
};
use crate::numbers::counted;
use crate::paper::{self, class_report};
use crate::progress::{Calendar, NotedHit};
use crate::quiz::concepts::Library;
use crate::screens::KeptSettings;
use database::Database;
use disk::Disk;
pub(crate) use forget::Forgetting;
pub use kept_elsewhere::FileBytes;
use memory::Memory;
use open_files::{OpenFiles, ReadBytes};
use text_store::TextStore;

/// The suffix of saved games and class rounds.
const TEXT: &str = ".toml";
/// The error if no data folder is known.
const NOWHERE: &str = "no data folder is known; set one with --data-dir";
const GAMES: &str = "games";
const CLASSES: &str = "classes";
const HANDED_IN: &str = "handed-in";
const HAND_IN: &str = ".json";
/// The suffix of tables for other programs.
const TABLE: &str = ".csv";
/// The suffix of pages for a browser.
const PAGE: &str = ".html";

/// All stored data.
pub struct Store {
    /// The saved games, each with its current state.
    games: OpenFiles<(SavedGame, Game)>,
    classes: OpenFiles<ClassRound>,
    exports: Box<dyn TextStore>,
    tables: Box<dyn TextStore>,
    pages: Box<dyn TextStore>,
    handed_in: Box<dyn TextStore>,
    progress: Database,
    /// Files that carrom keeps but does not use: damaged databases.
    aside: Vec<FileBytes>,
    /// The notice that the next answer will carry, such as one about a damaged database.
    notice: Option<String>,
    /// The file of the settings; `None` if they are not stored.
    settings: Option<PathBuf>,
    /// The actions that could not be written to the database yet, the oldest first.
    unsaved: VecDeque<PlayerAction>,
    clock: Clock,
    closed: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Clock {
    Computer,
    /// A fixed time, in seconds since the start of 1970, and the offset from UTC that determines
    /// the day.
    Stopped(i64, Offset),
    None,
}

impl Store {
    /// A store in memory, which is lost when the process ends.
    pub fn in_memory() -> Self {
        Self::of(Database::in_memory(), |folder, ending, _| {
            Box::new(Memory::holding(folder, ending, &[]))
        })
    }

    /// A store in `folder`, which is created when it is first needed. Saved games are in `games`,
    /// class rounds in `classes`, exports in `exports`, hand-ins in `handed-in`, settings in
    /// `settings.toml`, and everything else in `progress.db`.
    pub fn in_folder(folder: &Path) -> Self {
        let progress = Database::in_folder(folder.to_owned());
        let texts = Self::of(progress, |name, ending, largest| {
            Box::new(Disk {
                folder: folder.join(name),
                ending,
                largest,
                // Seat tokens and pupils' answers are for the teacher alone, and so are the tables
                // and reports made from them.
                private: [CLASSES, HANDED_IN].contains(&name) || [TABLE, PAGE].contains(&ending),
            })
        });
        Self {
            settings: Some(folder.join(KeptSettings::FILE)),
            ..texts
        }
    }

    /// A store without a folder: it refuses every request except that for today's date, and keeps
    /// the player's actions pending.
    pub fn nowhere() -> Self {
        Self {
            closed: true,
            ..Self::in_memory()
        }
    }

    /// The same store without a clock, so that runs do not depend on the time.
    pub fn timeless(self) -> Self {
        Self {
            clock: Clock::None,
            ..self
        }
    }

    /// The same store with a teacher's own questions, so that rounds with these questions can be
    /// resumed.
    pub fn with_own(mut self, own: &Arc<Library>) -> Self {
        self.classes.read = reading_classes(Arc::clone(own));
        self
    }

    /// The same store, except that reading changes no file, not even to repair it. This is for
    /// commands that only print.
    pub fn only_looking(mut self) -> Self {
        self.progress.only_looks = true;
        self
    }

    /// The same store with its clock stopped at `time_s`, in seconds since the start of 1970.
    pub fn at(mut self, time_s: i64) -> Self {
        self.stop_clock(time_s, 0);
        self
    }

    /// Stops the store's clock at `time_s`, in seconds since the start of 1970, with days that
    /// begin `offset_s` seconds before those of UTC. An impossible offset is ignored.
    pub fn stop_clock(&mut self, time_s: i64, offset_s: i32) {
        let offset = Offset::from_seconds(offset_s).unwrap_or(Offset::UTC);
        self.clock = Clock::Stopped(time_s, offset);
    }

    /// Builds a store. `texts` makes a store of texts from the folder's name, the suffix of the
    /// names and the largest number of bytes that are read from a text.
    fn of(
        progress: Database,
        texts: impl Fn(&'static str, &'static str, usize) -> Box<dyn TextStore>,
    ) -> Self {
        let games = texts(GAMES, TEXT, SavedGame::LARGEST_FILE);
        let classes = texts(CLASSES, TEXT, ClassRound::LARGEST_FILE);
        Self {
            games: OpenFiles::new(games, "game", Box::new(SavedGame::read)),
            classes: OpenFiles::new(classes, "class", reading_classes(Arc::default())),
            // These texts are only written.
            exports: texts("exports", TEXT, 0),
            tables: texts("exports", TABLE, 0),
            pages: texts("exports", PAGE, 0),
            handed_in: texts(HANDED_IN, HAND_IN, HandIn::LARGEST_FILE),
            progress,
            aside: Vec::new(),
            notice: None,
            settings: None,
            unsaved: VecDeque::new(),
            clock: Clock::Computer,
            closed: false,
        }
    }

    /// Carries out a request.
    pub fn answer(&mut self, call: &StoreCall) -> StoreAnswer {
        use StoreRequest::{Note, Retry, Today};
        if self.closed && !matches!(call.request, Note(_) | Retry | Today) {
            return StoreAnswer {
                unsaved: self.unsaved.len(),
                ..Self::refused(call, NOWHERE)
            };
        }
        self.progress.today = self.calendar().today();
        StoreAnswer {
            ticket: call.ticket,
            done: reply(call, Ok(self)),
            unsaved: self.unsaved.len(),
            notice: (self.notice.take())
                .or_else(|| self.progress.notice.take())
                .or_else(|| self.games.notice.take())
                .or_else(|| self.classes.notice.take()),
        }
    }

    /// An answer that refuses a request.
    pub fn refused(call: &StoreCall, reason: &str) -> StoreAnswer {
        StoreAnswer {
            ticket: call.ticket,
            done: reply(call, Err(reason.to_owned())),
            unsaved: 0,
            notice: None,
        }
    }

    fn keep_settings(&self, text: &str) -> Result<(), String> {
        let Some(path) = &self.settings else {
            return Ok(());
        };
        let document = (path.clone(), text.to_owned());
        files::put(&[document], Existing::Go).map_err(|error| error.to_string())
    }

    fn save(&mut self, ticket: u64, content: &FileContent) -> Result<(), String> {
        match content {
            FileContent::Game(game) => self.games.save(ticket, text_of(game)?),
            FileContent::Class(round) => self.classes.save(ticket, round.text()?),
        }
    }

    fn remove(&mut self, kind: FileKind, name: &str) -> Result<(), String> {
        match kind {
            FileKind::Game => self.games.remove(name),
            FileKind::Class => self.classes.remove(name),
        }
    }

    fn export(&mut self, content: &FileContent) -> Result<String, String> {
        match content {
            FileContent::Game(game) => self.exports.export("carrom-game", &text_of(game)?),
            FileContent::Class(round) => self.export_class(round),
        }
    }

    fn load_class(&mut self, ticket: u64, name: &str) -> Result<Box<ClassRound>, String> {
        let round = self.classes.load(ticket, name)?;
        if round.dropped_votes() > 0 {
            let dropped = counted(round.dropped_votes(), "vote");
            self.notice = Some(format!(
                "carrom opened this round without {dropped} that did not fit the question."
            ));
        }
        Ok(Box::new(round))
    }

    fn note_class(
        &mut self,
        ticket: u64,
        changes: &[ClassChange],
        round: &ClassRound,
    ) -> Result<(), String> {
        match self.classes.append(ticket, &appended(changes)?)? {
            true => Ok(()),
            false => self.classes.save(ticket, round.text()?),
        }
    }

    /// Writes both tables and the report of a class round.
    fn export_class(&mut self, round: &ClassRound) -> Result<String, String> {
        let day = self.calendar().today();
        let today = day.map(|day| day.to_string()).unwrap_or_default();
        let about = class_report::About {
            day,
            with_names: false,
        };
        let [answers, items] = [answers_csv(round, &today)?, items_csv(round, &today)?];
        let report = class_report::html(round, &about);
        let answers = self.tables.export("class-answers", &answers)?;
        let items = self.tables.export("class-items", &items)?;
        let report = self.pages.export("class-report", &report)?;
        Ok(format!("{answers}, {items} and {report}"))
    }

    /// Makes a gradebook from the hand-ins in a folder.
    fn gather(&self, from: HandInFolder) -> Result<Box<GatheredBook>, String> {
        let (book, place) = match common_folder(from)? {
            Some(folder) => {
                let place = folder.display().to_string();
                let book = Gradebook::of_folder(&folder, None);
                (book.map_err(|error| format!("{place}: {error}"))?, place)
            }
            None => {
                let mut book = Gradebook::default();
                let mut names = self.handed_in.names()?;
                names.reverse();
                for name in names {
                    let bytes = self.handed_in.read(&name).map_err(|error| error.message);
                    book.add(&name, bytes.and_then(|bytes| HandIn::read(&bytes)));
                }
                (book, "the folder of received hand-ins".to_owned())
            }
        };
        if book.pupils.is_empty() {
            return Err(format!("No hand-in was found in {place}."));
        }
        Ok(Box::new(GatheredBook {
            html: paper::gradebook::html(&book.results()),
            notes: book.notes,
        }))
    }

    /// Stores a hand-in beside earlier ones, unless an identical one is already there. Returns the
    /// folder.
    fn keep_hand_in(&mut self, hand_in: &HandIn) -> Result<String, String> {
        let store = &mut self.handed_in;
        let text = format!("{}\n", hand_in.value()?);
        let kind = hand_in.file_stem();
        let of_kind = |name: &String| name.starts_with(&kind);
        let is_same = |name: &String| store.read(name).is_ok_and(|it| it == text.as_bytes());
        let mut known = store.names()?.into_iter().filter(of_kind);
        let name = match known.find(is_same) {
            Some(name) => name,
            None => store.add(&kind, &text)?,
        };
        let place = store.place(&name);
        let folder = Path::new(&place).parent().map(Path::to_owned);
        Ok(folder.unwrap_or_default().display().to_string())
    }

    /// Stores an action of the player, after all earlier ones that are not stored yet. An answer,
    /// an observation and a hit get the current time.
    fn note(&mut self, action: &PlayerAction) -> Result<(), String> {
        let mut action = action.clone();
        let now_s = self.calendar().now_s;
        match &mut action {
            PlayerAction::Record(attempt) => attempt.time_s = now_s,
            PlayerAction::Observe(observation) => observation.time_s = now_s,
            PlayerAction::NoteHit(_, hit) => hit.time_s = now_s,
            _ => {}
        }
        self.unsaved.push_back(action);
        self.flush()
    }

    /// Writes the pending actions in order, until one fails.
    fn flush(&mut self) -> Result<(), String> {
        while let Some(oldest) = self.unsaved.front() {
            if self.closed {
                return Err(NOWHERE.into());
            }
            let progress = &mut self.progress;
            match oldest {
                PlayerAction::Record(attempt) => progress.record(attempt),
                PlayerAction::Observe(observation) => progress.observe(observation),
                PlayerAction::NoteHit(player, hit) => progress.note_hit(player, hit),
                PlayerAction::ClearNotebook(player) => progress.clear_notebook(player),
                PlayerAction::Star(player, starred) => progress.star(player, starred),
                PlayerAction::Mark {
                    player,
                    chapter,
                    later,
                } => progress.mark(player, chapter, later),
                PlayerAction::Forget(player, what) => progress.forget(player, what),
            }?;
            self.unsaved.pop_front();
        }
        Ok(())
    }

    /// Tries one last time to write the pending actions.
    ///
    /// # Errors
    /// How much is lost, and why.
    pub(crate) fn flush_at_end(&mut self) -> Result<(), String> {
        self.flush().map_err(|reason| {
            let unsaved = counted(self.unsaved.len(), "change");
            format!("{unsaved} could not be saved: {reason}")
        })
    }

    fn recall(&mut self, player: Option<&str>) -> Result<Box<History>, String> {
        let mut attempts = self.progress.attempts(player)?;
        let mut observations = self.progress.observations(player)?;
        // The answers and observations that are not stored yet count too.
        let is_of = |name: &str| player.is_none_or(|player| player == name);
        for action in &self.unsaved {
            match action {
                PlayerAction::Record(it) if is_of(&it.player) => attempts.push(*it.clone()),
                PlayerAction::Observe(it) if is_of(&it.player) => observations.push(*it.clone()),
                _ => {}
            }
        }
        Ok(Box::new(History {
            attempts,
            observations,
            calendar: self.calendar(),
        }))
    }

    /// The hits in a player's notebook, with those that are not stored yet.
    fn notebook(&mut self, player: &str) -> Result<Vec<NotedHit>, String> {
        let mut hits = self.progress.notebook(player)?;
        for action in &self.unsaved {
            match action {
                PlayerAction::NoteHit(name, hit) if name == player => hits.push(*hit.clone()),
                PlayerAction::ClearNotebook(name) if name == player => hits.clear(),
                _ => {}
            }
        }
        Ok(hits)
    }

    fn players(&mut self) -> Result<Vec<KnownPlayer>, String> {
        let calendar = self.calendar();
        let players = self.progress.players()?;
        let known = players.into_iter().map(|(name, last_s)| KnownPlayer {
            name,
            last: last_s.and_then(|last_s| calendar.day(last_s)),
        });
        Ok(known.collect())
    }

    /// The calendar for the ages of files; `None` if the store's clock does not show the real time.
    fn ages(&self) -> Option<Calendar> {
        (self.clock == Clock::Computer).then(|| self.calendar())
    }

    /// The current time and the time zone of the store's clock.
    fn calendar(&self) -> Calendar {
        match self.clock {
            Clock::None => Calendar::default(),
            Clock::Stopped(time_s, offset) => Calendar::new(Some(time_s), TimeZone::fixed(offset)),
            Clock::Computer => {
                let now_s = Timestamp::now().as_second();
                Calendar::new(Some(now_s), TimeZone::system())
            }
        }
    }
}

/// A folder outside the store; `None` for the store's own folder of hand-ins.
///
/// # Errors
/// If the home folder is unknown.
fn common_folder(folder: HandInFolder) -> Result<Option<PathBuf>, String> {
    let name = match folder {
        HandInFolder::Devices => return Ok(None),
        HandInFolder::Here => return Ok(Some(PathBuf::from("."))),
        HandInFolder::Downloads => "Downloads",
        HandInFolder::Documents => "Documents",
        HandInFolder::Desktop => "Desktop",
    };
    match home() {
        Some(home) => Ok(Some(home.join(name))),
        None => Err(format!("The location of the folder {name} is unknown.")),
    }
}

/// Reads class rounds, which may have questions of this library.
fn reading_classes(own: Arc<Library>) -> ReadBytes<ClassRound> {
    Box::new(move |name, bytes| ClassRound::read(name, bytes, &own))
}

/// The text of a game's file.
fn text_of(game: &SavedGame) -> Result<String, String> {
    game.text().map_err(|error| error.to_string())
}

/// The home folder; a browser has none.
fn home() -> Option<PathBuf> {
    #[cfg(target_family = "wasm")]
    return None;
    #[cfg(not(target_family = "wasm"))]
    etcetera::home_dir().ok()
}

/// The reply of a store to a request, or the reason why there is no store.
fn reply(call: &StoreCall, store: Result<&mut Store, String>) -> StoreReply {
    use StoreReply as Reply;
    use StoreRequest as Request;
    let ticket = call.ticket;
    match &call.request {
        Request::Save(content) => Reply::Saved(store.and_then(|it| it.save(ticket, content))),
        Request::NoteClass { changes, round } => {
            Reply::Saved(store.and_then(|it| it.note_class(ticket, changes, round)))
        }
        Request::List(FileKind::Game) => {
            Reply::Games(store.and_then(|it| it.games.list(it.ages().as_ref())))
        }
        Request::List(FileKind::Class) => {
            Reply::Classes(store.and_then(|it| it.classes.list(it.ages().as_ref())))
        }
        Request::Load(FileKind::Game, name) => {
            let loaded = store.and_then(|it| it.games.load(ticket, name));
            Reply::Game(loaded.map(|(game, _)| Box::new(game)))
        }
        Request::Load(FileKind::Class, name) => {
            Reply::Class(store.and_then(|it| it.load_class(ticket, name)))
        }
        Request::Remove(kind, name) => Reply::Removed(store.and_then(|it| it.remove(*kind, name))),
        Request::Export(content) => Reply::Exported(store.and_then(|it| it.export(content))),
        Request::Gather(folder) => Reply::Gathered(store.and_then(|it| it.gather(*folder))),
        Request::KeepHandIn(file) => Reply::HandedIn(store.and_then(|it| it.keep_hand_in(file))),
        Request::Recall(player) => {
            Reply::Recalled(store.and_then(|it| it.recall(player.as_deref())))
        }
        Request::Stars(player) => Reply::Stars(store.and_then(|it| it.progress.stars(player))),
        Request::Marks(player) => Reply::Marks(store.and_then(|it| it.progress.marks(player))),
        Request::Notebook(player) => Reply::Notebook(store.and_then(|it| it.notebook(player))),
        Request::Today => Reply::Today(store.ok().and_then(|it| it.calendar().today())),
        Request::Players => Reply::Players(store.and_then(Store::players)),
        Request::KeepSettings(text) => Reply::Noted(store.and_then(|it| it.keep_settings(text))),
        Request::Retry => Reply::Noted(store.and_then(Store::flush)),
        Request::Note(action) => Reply::Noted(store.and_then(|it| it.note(action))),
    }
}
