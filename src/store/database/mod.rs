//! Every answer, every level won and every bookmark, in an SQLite database.
//!
//! Several carroms may use it at once, any of them may be killed at any moment, and
//! the file may be damaged or of another version. So:
//!
//! - it is opened for one thing at a time, which is one transaction, and that has come
//!   to the disk when it is done (write-ahead log, `synchronous = FULL`);
//! - if it is busy, carrom waits and tries again;
//! - it is looked through once a day and whenever carrom starts, and of a sound one a copy
//!   is kept; a damaged one is mended: what can be read of it goes into a new file, and
//!   the damaged one is kept under another name;
//! - one that a newer carrom has written is refused, and not a byte of it is changed; so
//!   is whatever is no database of carrom's;
//! - one that cannot be changed, such as a copy on a disk for reading, can be looked up,
//!   and who only looks up changes none.
//!
//! It is not touched before it is first needed: carrom starts no slower for it.

mod backup;
mod bookmarks;
mod bytes;
mod error;
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

/// How long SQLite waits by itself for others.
const WAIT: Duration = Duration::from_secs(2);
/// For how long what is busy is tried again.
const PATIENCE: Duration = Duration::from_secs(10);
/// The same after a failure, so that a player does not wait for it at every answer.
const LITTLE: Duration = Duration::from_millis(500);
/// The lock file for using the database, or replacing it.
const LOCK: &str = ".progress.lock";

/// Where progress is kept.
pub(super) struct Database {
    location: Location,
    /// Whether nothing may be changed, not even to mend it.
    only_looks: bool,
    /// Today, if that is known.
    today: Option<Date>,
    /// Whether it was looked through by this process, and on which day.
    checked: Option<Option<Date>>,
    /// Whether it was busy for longer than is waited.
    was_busy: bool,
    notice: Option<String>,
    /// Whether the player has been notified of answers that are left out.
    reported_misfits: bool,
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
            only_looks: false,
            today: None,
            checked: None,
            was_busy: false,
            notice: None,
            reported_misfits: false,
        }
    }

    /// Has it looked up alone from now on: nothing there is changed.
    pub(super) fn only_look(&mut self) {
        self.only_looks = true;
    }

    /// Tells which day it is.
    pub(super) fn on_day(&mut self, today: Option<Date>) {
        self.today = today;
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
        let mut was_mended = false;
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
        act: &impl Fn(&Transaction) -> rusqlite::Result<T>,
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
            // Nobody writes meanwhile; where that cannot be known it is looked up all the same.
            let _turn = FolderLock::alone(&folder, LOCK);
            return self.look_up_in(&folder, act);
        }
        if self.checked != Some(self.today) {
            self.look_after(&folder)?;
            self.checked = Some(self.today);
        }
        // Nobody mends it meanwhile: what is done must be found again.
        let _turn = FolderLock::shared(&folder, LOCK)?;
        let mut connection = open(&folder, self.wait())?;
        transact(&mut connection, behavior, act)
    }

    /// How long SQLite waits for others.
    fn wait(&self) -> Duration {
        if self.was_busy { LITTLE } else { WAIT }
    }

    /// Looks a database through, mends it where it is damaged, and keeps a copy of it.
    fn look_after(&mut self, folder: &Path) -> Result<(), DatabaseError> {
        let turn = FolderLock::alone(folder, LOCK)?;
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
            && turn.is_certain()
        {
            // A full disk must not keep anybody from looking at what is there; what is
            // written next tells of it.
            let _ = backup::keep(&connection, folder, today);
        }
        Ok(())
    }

    /// Looks something up where nothing can be written, for that `trouble`.
    fn look_only<T>(
        &mut self,
        look: &impl Fn(&Transaction) -> rusqlite::Result<T>,
        trouble: DatabaseError,
    ) -> Result<T, DatabaseError> {
        match &self.location {
            Location::Folder(folder) => self.look_up_in(&folder.clone(), look),
            Location::Memory(_) | Location::Newer(..) => Err(trouble),
        }
    }

    /// Looks something up and changes nothing.
    fn look_up_in<T>(
        &mut self,
        folder: &Path,
        look: &impl Fn(&Transaction) -> rusqlite::Result<T>,
    ) -> Result<T, DatabaseError> {
        let mut connection = unchanged::open(&path(folder), self.checked.is_none())?;
        self.checked = Some(self.today);
        transact(&mut connection, TransactionBehavior::Deferred, look)
    }

    fn reported(&self, trouble: &DatabaseError) -> String {
        match &self.location {
            Location::Memory(_) | Location::Newer(..) => trouble.to_string(),
            Location::Folder(folder) => {
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

/// Fails unless what is there, if anything is, can be a database that this carrom knows. It
/// is looked at as any file is: SQLite would wait at a pipe, and put files of its own beside
/// what is none of ours.
fn look_at_file(path: &Path) -> Result<(), DatabaseError> {
    match fs::metadata(path) {
        Ok(about) if !about.is_file() => {
            Err(DatabaseError::NoFile(not_a_file(path).without_file()))
        }
        Ok(about) if about.len() > 0 => match schema::version_in_header(path) {
            // With the tables of this version it is the number that is damaged.
            Some(found)
                if is_newer(&found)
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

fn is_newer(version: &i64) -> bool {
    *version > schema::VERSION
}

/// The name of the database.
const NAME: &str = "progress.db";

/// Where the database of a folder is: what belongs to it is beside the file, which a link may
/// lead to.
fn path(folder: &Path) -> PathBuf {
    let path = folder.join(NAME);
    match fs::canonicalize(&path) {
        Ok(place) if path.is_symlink() => place,
        _ => path,
    }
}

/// The bytes of a database and its log.
fn size(path: &Path) -> u64 {
    let files = ["", "-wal"].map(|ending| fs::metadata(mend::with_ending(path, ending)));
    files.into_iter().flatten().map(|about| about.len()).sum()
}

/// Whether a folder has room for what SQLite keeps beside a database.
fn has_room(folder: &Path) -> bool {
    // Its index of the log alone takes 32 KiB.
    let tried = UnplacedFile::write(folder, &" ".repeat(1 << 16));
    !tried.is_err_and(|error| error::is_full(&error))
}

/// Opens the database and brings it to the present version.
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
    act: impl Fn(&Transaction) -> rusqlite::Result<T>,
) -> Result<T, DatabaseError> {
    let transaction = connection.transaction_with_behavior(behavior)?;
    let result = act(&transaction)?;
    transaction.commit()?;
    Ok(result)
}

#[cfg(test)]
mod tests;
