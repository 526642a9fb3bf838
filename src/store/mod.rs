//! What is kept: saved games, one file a game, exported ones, and in a
//! database every answer, every level won and how far each chapter was read.
//!
//! Several carroms may keep their games in one folder, any of them may be killed at
//! any moment, and any file may be damaged or not ours. So:
//!
//! - a file is written beside its place, brought to the disk and then put in its
//!   place, so that there is always either the old or the new one;
//! - a file is replaced only while it still holds what this store last put or found
//!   there; otherwise the game moves to a new file of its own;
//! - nothing is believed of a file until all of it has been played.

mod database;
mod disk;
mod memory;
mod shelf;
mod turn;

use std::collections::BTreeMap;
use std::path::Path;
use std::time::{SystemTime, UNIX_EPOCH};

use crate::files::Fault;
use crate::game::{Game, SavedGame};
use crate::messages::{Answer, Done, History, Kept, Request, Wish};
use crate::progress::Attempt;
use database::Database;
use disk::Disk;
use memory::Memory;
use shelf::Shelf;

/// Where everything is kept.
pub struct Store {
    games: Box<dyn Shelf>,
    exports: Box<dyn Shelf>,
    progress: Database,
    /// What was last put or found under which name, by ticket.
    open: BTreeMap<u64, Open>,
    knows_time: bool,
    closed: bool,
}

/// A game being played.
struct Open {
    name: String,
    text: String,
}

impl Store {
    /// A store that is gone with the process.
    pub fn in_memory() -> Self {
        Self::of(
            Memory::new("games"),
            Memory::new("exports"),
            Database::in_memory(),
        )
    }

    /// A store in `folder`, which is made when it is first needed: saved games in
    /// `games`, exported ones in `exports`, all else in `progress.db`.
    pub fn in_folder(folder: &Path) -> Self {
        Self::of(
            Disk::new(folder.join("games")),
            Disk::new(folder.join("exports")),
            Database::in_folder(folder.to_owned()),
        )
    }

    /// No store: there is no folder for it, and it refuses everything.
    pub fn nowhere() -> Self {
        Self {
            closed: true,
            ..Self::in_memory()
        }
    }

    /// The same store, but it knows no time: for runs that are to be the same
    /// whenever they are made.
    pub fn timeless(self) -> Self {
        Self {
            knows_time: false,
            ..self
        }
    }

    fn of(games: impl Shelf + 'static, exports: impl Shelf + 'static, progress: Database) -> Self {
        Self {
            games: Box::new(games),
            exports: Box::new(exports),
            progress,
            open: BTreeMap::new(),
            knows_time: true,
            closed: false,
        }
    }

    /// Does what is asked.
    pub fn answer(&mut self, request: &Request) -> Answer {
        if self.closed {
            return request.refused("no folder for data is known; --data-dir gives one");
        }
        let ticket = request.ticket;
        let done = match &request.wish {
            Wish::Save(game) => Done::Saved(self.save(ticket, game)),
            Wish::List => Done::Listed(self.list()),
            Wish::Load(name) => Done::Loaded(self.load(ticket, name)),
            Wish::Remove(name) => Done::Removed(self.remove(name)),
            Wish::Export(game) => Done::Exported(self.export(game)),
            Wish::Record(attempt) => Done::Noted(self.record(attempt)),
            Wish::Star(player, starred) => Done::Noted(self.progress.star(player, starred)),
            Wish::Recall(player) => Done::Recalled(self.recall(player.as_deref())),
            Wish::Stars(player) => Done::Stars(self.progress.stars(player)),
            Wish::Mark {
                player,
                chapter,
                later,
            } => Done::Noted(self.progress.mark(player, chapter, later)),
            Wish::Forget(player, what) => Done::Noted(self.progress.forget(player, what)),
            Wish::Marks(player) => Done::Marks(self.progress.marks(player)),
        };
        Answer {
            ticket,
            done,
            notice: self.progress.take_notice(),
        }
    }

    fn save(&mut self, ticket: u64, game: &SavedGame) -> Result<(), String> {
        let text = game.text().map_err(|error| error.to_string())?;
        if let Some(open) = self.open.get_mut(&ticket)
            && self.games.replace(&open.name, &open.text, &text)?
        {
            open.text = text;
            return Ok(());
        }
        let name = self.games.add("game", &text)?;
        self.open.insert(ticket, Open { name, text });
        Ok(())
    }

    fn list(&self) -> Result<Vec<Kept>, String> {
        let mut found = Vec::new();
        for name in self.games.names()? {
            let game = self.read(&name).map(|(_, game)| Box::new(game));
            found.push(Kept {
                age: self.games.age(&name).filter(|_| self.knows_time),
                // Where it is, is said beside.
                game: game.map_err(|fault| fault.without_file()),
                name,
            });
        }
        Ok(found)
    }

    fn load(&mut self, ticket: u64, name: &str) -> Result<Box<SavedGame>, String> {
        let (text, (game, _)) = self.read(name).map_err(|fault| fault.to_string())?;
        let name = name.to_owned();
        self.open.insert(ticket, Open { name, text });
        Ok(Box::new(game))
    }

    /// The text of a game and the game, with where it stands.
    fn read(&self, name: &str) -> Result<(String, (SavedGame, Game)), Fault> {
        let bytes = self.games.read(name)?;
        let game = SavedGame::read(&self.games.place(name), &bytes)?;
        Ok((String::from_utf8_lossy(&bytes).into_owned(), game))
    }

    fn remove(&mut self, name: &str) -> Result<(), String> {
        self.games.remove(name)
    }

    fn export(&mut self, game: &SavedGame) -> Result<String, String> {
        let text = game.text().map_err(|error| error.to_string())?;
        let name = self.exports.add("carrom-game", &text)?;
        Ok(self.exports.place(&name))
    }

    /// Keeps an answer, with the time.
    fn record(&mut self, attempt: &Attempt) -> Result<(), String> {
        let attempt = Attempt {
            time_s: self.now_s(),
            ..attempt.clone()
        };
        self.progress.record(&attempt)
    }

    fn recall(&mut self, player: Option<&str>) -> Result<Box<History>, String> {
        Ok(Box::new(History {
            attempts: self.progress.attempts(player)?,
            now_s: self.now_s(),
        }))
    }

    /// The time in seconds since 1970 began; `None` where it is not to be known.
    fn now_s(&self) -> Option<i64> {
        let now = SystemTime::now().duration_since(UNIX_EPOCH).ok()?;
        i64::try_from(now.as_secs())
            .ok()
            .filter(|_| self.knows_time)
    }
}
