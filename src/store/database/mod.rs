//! Every answer, every level won and every bookmark, in an SQLite database.
//!
//! Several carroms may use it at once, any of them may be killed at any moment, and
//! the file may be damaged or of another version. So:
//!
//! - it is opened for one thing at a time, which is one transaction, and that has come
//!   to the disk when it is done (write-ahead log, `synchronous = FULL`);
//! - who waits for another is patient, and tries again;
//! - a damaged database is set aside under another name, where it can still be looked
//!   at, and a new one takes its place;
//! - one that a newer carrom has written is refused, and not a byte of it is changed;
//! - one that cannot be changed, such as a copy on a disk for reading, can be looked up.
//!
//! It is not touched before it is first needed: carrom starts no slower for it.

mod bookmarks;
mod bytes;
mod error;
mod schema;
mod tables;
mod unchanged;

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, Instant};

use rusqlite::{Connection, Transaction, TransactionBehavior};

use super::folder_lock::FolderLock;
use error::DatabaseError;

/// How long SQLite waits by itself for others.
const WAIT: Duration = Duration::from_secs(2);
/// For how long what is busy is tried again.
const PATIENCE: Duration = Duration::from_secs(10);
/// The same once that did not help: whoever does not let go for so long will not soon, and
/// a player is not to wait for it at every answer.
const LITTLE: Duration = Duration::from_millis(500);
/// The file that stands for the right to use the database, or to set it aside.
const LOCK: &str = ".progress.lock";

/// Where progress is kept.
pub(super) struct Database {
    location: Location,
    /// Whether it was looked through by this process.
    checked: bool,
    /// Whether it was busy for longer than is waited.
    was_busy: bool,
    notice: Option<String>,
}

enum Location {
    /// Gone with the process; opened when it is first needed.
    Memory(Option<Connection>),
    /// `progress.db` in this folder.
    Folder(PathBuf),
    /// Bytes of this version, which is newer than this carrom knows.
    Newer(i64, Vec<u8>),
}

impl Database {
    /// A database that is gone with the process.
    pub(super) fn in_memory() -> Self {
        Self::at(Location::Memory(None))
    }

    /// A database in `folder`; both are made when there is first something to keep.
    pub(super) fn in_folder(folder: PathBuf) -> Self {
        Self::at(Location::Folder(folder))
    }

    fn at(location: Location) -> Self {
        Self {
            location,
            checked: false,
            was_busy: false,
            notice: None,
        }
    }

    /// What the player should know of it, once.
    pub(super) fn take_notice(&mut self) -> Option<String> {
        self.notice.take()
    }

    /// Whether there is no database yet, and so nothing to be found in it.
    fn is_nowhere(&self) -> bool {
        match &self.location {
            Location::Memory(connection) => connection.is_none(),
            Location::Folder(folder) => matches!(fs::exists(path(folder)), Ok(false)),
            Location::Newer(..) => false,
        }
    }

    /// Looks something up; where there is no database there is nothing.
    fn look_up<T: Default>(
        &mut self,
        look: impl Fn(&Transaction) -> rusqlite::Result<T>,
    ) -> Result<T, String> {
        if self.is_nowhere() {
            return Ok(T::default());
        }
        self.run(TransactionBehavior::Deferred, look)
    }

    /// Changes something; the database is made if there is none.
    fn change<T>(
        &mut self,
        change: impl Fn(&Transaction) -> rusqlite::Result<T>,
    ) -> Result<(), String> {
        self.run(TransactionBehavior::Immediate, change).map(drop)
    }

    /// Does something as one transaction. If it fails, nothing of it is done.
    fn run<T>(
        &mut self,
        behavior: TransactionBehavior,
        act: impl Fn(&Transaction) -> rusqlite::Result<T>,
    ) -> Result<T, String> {
        let mut busy_since = None;
        let patience = if self.was_busy { LITTLE } else { PATIENCE };
        let mut set_aside = false;
        loop {
            let tried = match self.try_once(behavior, &act) {
                Err(trouble) if trouble.is_forbidden() && is_look_up(behavior) => {
                    self.look_only(&act, trouble)
                }
                tried => tried,
            };
            self.was_busy = matches!(&tried, Err(trouble) if trouble.is_busy());
            match tried {
                Ok(result) => return Ok(result),
                Err(trouble) if trouble.is_busy() && is_within(&mut busy_since, patience) => {
                    thread::sleep(Duration::from_millis(10));
                }
                Err(trouble) if trouble.is_damage() && !set_aside => {
                    set_aside = true;
                    self.set_aside().map_err(|trouble| self.told(&trouble))?;
                }
                Err(trouble) => return Err(self.told(&trouble)),
            }
        }
    }

    fn try_once<T>(
        &mut self,
        behavior: TransactionBehavior,
        act: &impl Fn(&Transaction) -> rusqlite::Result<T>,
    ) -> Result<T, DatabaseError> {
        let folder = match &mut self.location {
            Location::Folder(folder) => folder,
            Location::Newer(found, _) => return Err(DatabaseError::Newer(*found)),
            Location::Memory(Some(connection)) => return transact(connection, behavior, act),
            Location::Memory(empty) => {
                let mut connection = Connection::open_in_memory()?;
                schema::prepare(&mut connection)?;
                return transact(empty.insert(connection), behavior, act);
            }
        };
        if let Some(found) = schema::version_in_header(&path(folder)).filter(is_newer) {
            // Before anything is written beside it.
            return Err(DatabaseError::Newer(found));
        }
        // Nobody sets it aside meanwhile: what is done must be found again.
        let _turn = FolderLock::shared(folder, LOCK)?;
        let wait = if self.was_busy { LITTLE } else { WAIT };
        let mut connection = open(folder, wait)?;
        if !self.checked {
            schema::check(&connection)?;
            self.checked = true;
        }
        transact(&mut connection, behavior, act)
    }

    /// Looks something up where nothing can be written, for that `trouble`.
    fn look_only<T>(
        &self,
        look: &impl Fn(&Transaction) -> rusqlite::Result<T>,
        trouble: DatabaseError,
    ) -> Result<T, DatabaseError> {
        let Location::Folder(folder) = &self.location else {
            return Err(trouble);
        };
        let mut connection = unchanged::open(folder, NAME)?;
        transact(&mut connection, TransactionBehavior::Deferred, look)
    }

    /// Gives a damaged database another name.
    fn set_aside(&mut self) -> Result<(), DatabaseError> {
        let Location::Folder(folder) = &self.location else {
            return Ok(());
        };
        let _turn = FolderLock::alone(folder, LOCK)?;
        // Another carrom may have done so before.
        let opened = open(folder, WAIT).and_then(|connection| schema::check(&connection));
        let Err(trouble) = opened else {
            return Ok(());
        };
        if !trouble.is_damage() {
            return Err(trouble);
        }
        let name = free_name(folder);
        // What belongs to it goes first: a new database must not find it.
        for ending in ["-wal", "-shm", ""] {
            let from = folder.join(format!("{NAME}{ending}"));
            let to = folder.join(format!("{name}{ending}"));
            match fs::rename(from, to) {
                Err(error) if error.kind() != ErrorKind::NotFound => return Err(error.into()),
                _ => {}
            }
        }
        self.notice = Some(format!(
            "{} was damaged: {trouble}. It is set aside as {name}, and what you do from \
             now on is kept in a new one.",
            path(folder).display(),
        ));
        Ok(())
    }

    fn told(&self, trouble: &DatabaseError) -> String {
        match &self.location {
            Location::Memory(_) | Location::Newer(..) => trouble.to_string(),
            Location::Folder(folder) => format!("{}: {trouble}", path(folder).display()),
        }
    }
}

/// Whether what was first asked `since` then is not past this patience. The clock is not
/// looked at before it is needed: in a browser there is none.
fn is_within(since: &mut Option<Instant>, patience: Duration) -> bool {
    since.get_or_insert_with(Instant::now).elapsed() < patience
}

fn is_look_up(behavior: TransactionBehavior) -> bool {
    matches!(behavior, TransactionBehavior::Deferred)
}

fn is_newer(version: &i64) -> bool {
    *version > schema::VERSION
}

/// The name of the database.
const NAME: &str = "progress.db";

fn path(folder: &Path) -> PathBuf {
    folder.join(NAME)
}

/// A name for a damaged database that nothing has yet.
fn free_name(folder: &Path) -> String {
    let name = |number: u32| format!("progress-damaged-{number}.db");
    let is_free = |name: &String| !matches!(fs::exists(folder.join(name)), Ok(true));
    (1..).map(name).find(is_free).unwrap_or_else(|| name(0))
}

/// Opens the database and brings it to the present version.
fn open(folder: &Path, wait: Duration) -> Result<Connection, DatabaseError> {
    let mut connection = Connection::open(path(folder))?;
    connection.busy_timeout(wait)?;
    schema::prepare(&mut connection)?;
    Ok(connection)
}

fn transact<T>(
    connection: &mut Connection,
    behavior: TransactionBehavior,
    act: impl Fn(&Transaction) -> rusqlite::Result<T>,
) -> Result<T, DatabaseError> {
    let transaction = connection.transaction_with_behavior(behavior)?;
    let result = act(&transaction)?;
    transaction.commit()?;
    Ok(result)
}

#[cfg(test)]
mod tests;
