//! Stores every answer, every level won, every bookmark, every observation and every hit of the
//! lab's notebook in an SQLite database.
//!
//! Several copies of carrom may use the database at once, any of them may be killed at any moment,
//! and the file may be damaged or of another version. So:
//!
//! - each request is one transaction, which is on the disk when the request is done (write-ahead
//!   log, `synchronous = FULL`);
//! - if the database is busy, carrom waits and tries again;
//! - the database is checked once a day and whenever carrom starts. An undamaged database is
//!   copied; a damaged one is repaired: its readable rows go into a new file, and the damaged file
//!   is kept under another name;
//! - a database that a newer version of carrom has written, or a file that is not a carrom
//!   database, is refused and not changed at all;
//! - a read-only database, such as a copy on a read-only disk, can be read, and reading
//!   changes nothing.
//!
//! The database is opened only when it is first needed, so that carrom starts quickly.

mod backup;
mod bookmarks;
mod bytes;
mod error;
mod hits;
mod limits;
mod mend;
mod pages;
mod salvage;
mod schema;
mod tables;
mod unchanged;

use std::fs;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, Instant};

use jiff::civil::Date;
use rusqlite::{Connection, Transaction, TransactionBehavior};

use super::folder_lock::FolderLock;
use crate::files::{UnplacedFile, not_a_file};
use error::DatabaseError;

/// How long SQLite itself waits for other connections.
const WAIT: Duration = Duration::from_secs(2);
/// How long carrom retries while the database is busy.
const PATIENCE: Duration = Duration::from_secs(10);
/// Replaces both limits after a failure, so that the player does not wait so long for every answer.
const LITTLE: Duration = Duration::from_millis(500);
/// The lock file for using or replacing the database.
const LOCK: &str = ".progress.lock";

pub(super) struct Database {
    location: Location,
    /// Whether nothing may be changed, not even to repair the database.
    pub(super) only_looks: bool,
    /// The current day, if it is known.
    pub(super) today: Option<Date>,
    /// The day on which this process last checked the database; `None` before the first check, and
    /// after damage was found.
    checked: Option<Option<Date>>,
    /// Whether the last attempt failed because the database was busy.
    was_busy: bool,
    /// The pending notice for the player.
    pub(super) notice: Option<String>,
    /// Whether the player has been notified of invalid rows.
    reported_misfits: bool,
}

enum Location {
    /// A database in memory, which is lost when the process ends; it is opened when first needed.
    Memory(Option<Connection>),
    /// `progress.db` in this folder.
    Folder(PathBuf),
    /// The format number and the bytes of a database in a format that is newer than those that this
    /// version of carrom knows.
    Newer(i64, Vec<u8>),
}

/// What is done in one transaction.
type Act<'a, T> = &'a dyn Fn(&Transaction) -> rusqlite::Result<T>;

impl Database {
    /// A database in memory, which is lost when the process ends.
    pub(super) fn in_memory() -> Self {
        Self::at(Location::Memory(None))
    }

    /// A database in `folder`; both are created when something is first stored.
    pub(super) fn in_folder(folder: PathBuf) -> Self {
        Self::at(Location::Folder(folder))
    }

    fn at(location: Location) -> Self {
        Self {
            location,
            only_looks: false,
            today: None,
            checked: None,
            was_busy: false,
            notice: None,
            reported_misfits: false,
        }
    }

    /// Whether there is no database yet.
    fn is_nowhere(&self) -> bool {
        match &self.location {
            Location::Memory(connection) => connection.is_none(),
            Location::Folder(folder) => matches!(fs::exists(path(folder)), Ok(false)),
            Location::Newer(..) => false,
        }
    }

    /// Reads something; returns the default if there is no database.
    fn look_up<T: Default>(&mut self, look: Act<T>) -> Result<T, String> {
        if self.is_nowhere() {
            return Ok(T::default());
        }
        self.run(TransactionBehavior::Deferred, look)
    }

    /// Changes something; the database is created if there is none.
    fn change<T>(&mut self, change: Act<T>) -> Result<(), String> {
        self.run(TransactionBehavior::Immediate, change).map(drop)
    }

    /// Runs `act` as one transaction. If it fails, nothing is changed.
    fn run<T>(&mut self, behavior: TransactionBehavior, act: Act<T>) -> Result<T, String> {
        let mut busy_since = None;
        let patience = if self.was_busy { LITTLE } else { PATIENCE };
        let mut was_mended = false;
        loop {
            let mut tried = self.try_once(behavior, act);
            if matches!(&tried, Err(trouble) if trouble.is_forbidden())
                && matches!(behavior, TransactionBehavior::Deferred)
                && let Location::Folder(folder) = &self.location
            {
                tried = self.look_up_in(&folder.clone(), act);
            }
            self.was_busy = matches!(&tried, Err(trouble) if trouble.is_busy());
            match tried {
                Ok(result) => return Ok(result),
                Err(trouble) if trouble.is_busy() && is_within(&mut busy_since, patience) => {
                    thread::sleep(Duration::from_millis(10));
                }
                Err(trouble) if trouble.is_damage() && !self.only_looks && !was_mended => {
                    was_mended = true;
                    self.checked = None;
                }
                Err(trouble) => return Err(self.reported(&trouble)),
            }
        }
    }

    fn try_once<T>(
        &mut self,
        behavior: TransactionBehavior,
        act: Act<T>,
    ) -> Result<T, DatabaseError> {
        let folder = match &mut self.location {
            Location::Folder(folder) => folder.clone(),
            Location::Newer(found, _) => return Err(DatabaseError::Newer(*found)),
            Location::Memory(Some(connection)) => return transact(connection, behavior, act),
            Location::Memory(empty) => {
                let mut connection = Connection::open_in_memory()?;
                schema::prepare(&mut connection)?;
                return transact(empty.insert(connection), behavior, act);
            }
        };
        look_at_file(&path(&folder))?;
        if self.only_looks {
            // The lock keeps others from writing meanwhile. If it is not available, the database is
            // read anyway.
            let _turn = FolderLock::alone(&folder, LOCK);
            return self.look_up_in(&folder, act);
        }
        if self.checked != Some(self.today) {
            self.look_after(&folder)?;
            self.checked = Some(self.today);
        }
        // The lock keeps others from repairing the database meanwhile, which would lose this
        // change.
        let _turn = FolderLock::shared(&folder, LOCK)?;
        let mut connection = open(&folder, self.wait())?;
        transact(&mut connection, behavior, act)
    }

    /// How long SQLite waits for other connections.
    fn wait(&self) -> Duration {
        if self.was_busy { LITTLE } else { WAIT }
    }

    /// Checks a database, repairs it if it is damaged, and makes the copy of the day.
    fn look_after(&mut self, folder: &Path) -> Result<(), DatabaseError> {
        let guard = FolderLock::alone(folder, LOCK)?;
        let was_there = fs::exists(path(folder))?;
        let look = |wait| {
            let connection = open(folder, wait)?;
            schema::check(&connection).map(|()| connection)
        };
        let connection = match look(self.wait()) {
            Err(trouble) if trouble.is_damage() => {
                self.notice = Some(mend::mend(folder, &trouble)?);
                look(self.wait())?
            }
            looked => looked?,
        };
        if let Some(today) = self.today
            && was_there
            && guard.is_certain()
        {
            // A full disk must not prevent reading; the next write will report it.
            let _ = backup::keep(&connection, folder, today);
        }
        Ok(())
    }

    /// Reads something, and changes nothing.
    fn look_up_in<T>(&mut self, folder: &Path, look: Act<T>) -> Result<T, DatabaseError> {
        let mut connection = unchanged::open(&path(folder), self.checked.is_none())?;
        self.checked = Some(self.today);
        transact(&mut connection, TransactionBehavior::Deferred, look)
    }

    fn reported(&self, trouble: &DatabaseError) -> String {
        let Location::Folder(folder) = &self.location else {
            return trouble.to_string();
        };
        let what_next = if trouble.is_strange() {
            ", so it is left unchanged; nothing is saved until it is moved away"
        } else if trouble.is_damage() && self.only_looks {
            "; carrom repairs it when you next open the game"
        } else {
            ""
        };
        let trouble = match trouble {
            DatabaseError::Sqlite(why)
                if trouble.may_be_full() && !self.only_looks && !has_room(folder) =>
            {
                error::no_room(why)
            }
            _ => trouble.to_string(),
        };
        format!("{}: {trouble}{what_next}", path(folder).display())
    }
}

/// Whether the first call was less than `patience` ago; `since` keeps the time of that call. Only
/// this function reads the clock, and only while the database is busy. In a browser it is never
/// busy, and Rust's standard library has no clock there.
fn is_within(since: &mut Option<Instant>, patience: Duration) -> bool {
    since.get_or_insert_with(Instant::now).elapsed() < patience
}

/// Fails if the path leads to something that this version of carrom cannot use as a database. This
/// is checked before SQLite opens the file for writing, because SQLite would wait for a pipe, and
/// would create files beside a file that is not a database.
fn look_at_file(path: &Path) -> Result<(), DatabaseError> {
    match fs::metadata(path) {
        Ok(about) if !about.is_file() => {
            Err(DatabaseError::NoFile(not_a_file(path).without_file()))
        }
        Ok(about) if about.len() > 0 => match schema::version_in_header(path) {
            // If the tables are those of a known version, the format number is damaged.
            Some(found)
                if found > schema::VERSION
                    && !unchanged::examine(path).is_err_and(|trouble| trouble.is_damage()) =>
            {
                Err(DatabaseError::Newer(found))
            }
            None if !schema::is_ours(path) => Err(DatabaseError::begins_otherwise()),
            _ => Ok(()),
        },
        _ => Ok(()),
    }
}

/// The file name of the database.
const NAME: &str = "progress.db";

/// The path of the database in a folder. Links are resolved, because SQLite's other files are
/// beside the target.
fn path(folder: &Path) -> PathBuf {
    let path = folder.join(NAME);
    match fs::canonicalize(&path) {
        Ok(place) if path.is_symlink() => place,
        _ => path,
    }
}

/// The size of a database and its log, in bytes.
fn size(path: &Path) -> u64 {
    let files = ["", "-wal"].map(|ending| fs::metadata(mend::with_ending(path, ending)));
    files.into_iter().flatten().map(|about| about.len()).sum()
}

/// Whether a folder has room for the files that SQLite creates beside a database.
fn has_room(folder: &Path) -> bool {
    // The index of the log alone takes up 32 KiB.
    let tried = UnplacedFile::write(folder, " ".repeat(1 << 16), false);
    !tried.is_err_and(|error| error::is_full(&error))
}

/// Opens the database and upgrades it to the current version.
fn open(folder: &Path, wait: Duration) -> Result<Connection, DatabaseError> {
    let path = path(folder);
    let mut connection = Connection::open(&path)?;
    connection.busy_timeout(wait)?;
    limits::limit_work(&mut connection, size(&path))?;
    schema::prepare(&mut connection)?;
    Ok(connection)
}

fn transact<T>(
    connection: &mut Connection,
    behavior: TransactionBehavior,
    act: Act<T>,
) -> Result<T, DatabaseError> {
    let transaction = connection.transaction_with_behavior(behavior)?;
    let result = act(&transaction)?;
    transaction.commit()?;
    Ok(result)
}

#[cfg(test)]
mod tests;
