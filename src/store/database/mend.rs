//! Repairs a damaged database: copies all readable rows into a new file. The damaged file is kept
//! unchanged under another name.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use rusqlite::Connection;
use rusqlite::config::DbConfig;

use super::error::DatabaseError;
use super::pages::Pages;
use super::salvage::{Saved, salvage};
use super::{backup, limits, path, schema, size};
use crate::files::fsync_dir;

/// The temporary name of the unfinished new file.
const DRAFT: &str = ".progress-mended.db";
/// The temporary name of a writable copy of the damaged file.
const COPY: &str = ".progress-copy.db";
/// The first bytes of every carrom database: the name of the format, pages of 4,096 bytes, a
/// write-ahead log, no reserved space, and three fixed numbers. (Database File Format, section
/// 1.3.)
const HEADER: [u8; 24] = *b"SQLite format 3\0\x10\0\x02\x02\0\x40\x20\x20";
/// The suffixes of the files that belong to a database; the database itself is last.
pub(super) const ENDINGS: [&str; 4] = ["-journal", "-wal", "-shm", ""];

/// An unfinished database. When dropped, it is removed with its other files, unless it has been
/// renamed.
pub(super) struct Draft(PathBuf);

impl Draft {
    /// A draft with this name beside a file. Any draft that a killed process left there is removed.
    pub(super) fn beside(path: &Path, name: &str) -> io::Result<Self> {
        let draft = Self(path.with_file_name(name));
        remove(&draft.0)?;
        Ok(draft)
    }

    pub(super) fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Draft {
    fn drop(&mut self) {
        // A file that cannot be removed only takes up space.
        let _ = remove(&self.0);
    }
}

/// Replaces a damaged database with a repaired one; `trouble` is the damage that was found. Returns
/// a notice of what was saved. The caller must hold the lock.
pub(super) fn mend(folder: &Path, trouble: &DatabaseError) -> Result<String, DatabaseError> {
    let damaged = path(folder);
    if !schema::is_ours(&damaged) {
        return Err(DatabaseError::begins_otherwise());
    }
    let unmended = |why: DatabaseError| DatabaseError::Unmended(Box::new(why));
    let (saved, kept) = mended(folder, &damaged).map_err(unmended)?;
    Ok(notice(&saved, &kept.display().to_string(), trouble))
}

/// The notice about a repaired database.
fn notice(saved: &str, kept: &str, trouble: &DatabaseError) -> String {
    format!(
        "The file with your answers was damaged and has been repaired. {saved} The damaged file \
         is kept as {kept} ({trouble})."
    )
}

/// Repairs the database; returns what was saved, and where the damaged file is kept.
fn mended(folder: &Path, damaged: &Path) -> Result<(String, PathBuf), DatabaseError> {
    let draft = Draft::beside(damaged, DRAFT)?;
    copy_damaged(damaged, draft.path())?;
    // If only an index is damaged, the answers themselves are intact.
    let saved = match reindexed(draft.path()) {
        Ok(()) => "Everything in it could be saved.".into(),
        Err(error) if error.is_full() => return Err(error),
        Err(_) => {
            remove(draft.path())?;
            let copy = Draft::beside(damaged, COPY)?;
            copy_damaged(damaged, copy.path())?;
            salvaged(folder, copy.path(), draft.path())?.reported()
        }
    };
    let kept = put_in_place(damaged, draft.path())?;
    Ok((saved, kept))
}

/// Copies a damaged database, and corrects the first bytes of the copy.
fn copy_damaged(from: &Path, to: &Path) -> io::Result<()> {
    for ending in ["", "-wal"] {
        if_there(fs::copy(with_ending(from, ending), with_ending(to, ending)))?;
    }
    File::options().write(true).open(to)?.write_all(&HEADER)
}

/// Rebuilds the indexes; fails if the database is still damaged afterwards.
fn reindexed(draft: &Path) -> Result<(), DatabaseError> {
    let mut connection = Connection::open(draft)?;
    limits::limit_work(&mut connection, size(draft))?;
    limits::distrust(&connection)?;
    schema::examine(&*connection.unchecked_transaction()?)?;
    connection.execute_batch("REINDEX")?;
    schema::prepare(&mut connection)?;
    schema::check(&connection)?;
    finish(&connection)
}

/// Fills the draft with all readable rows of the damaged database, and adds missing rows from the
/// latest copy.
fn salvaged(folder: &Path, damaged: &Path, draft: &Path) -> Result<Saved, DatabaseError> {
    // Closing the last connection moves the contents of the log into the database.
    let version = version_of_damaged(&Connection::open(damaged)?)?;
    let mut new = Connection::open(draft)?;
    let mut saved = refilled(&mut new, version, &fs::read(damaged)?)?;
    if !saved.damaged.is_empty() {
        saved.copy = backup::fill_in(&new, folder, version, &saved.damaged)?;
    }
    schema::prepare(&mut new)?;
    schema::check(&new)?;
    finish(&new)?;
    Ok(saved)
}

/// A database in memory with all readable rows of a damaged one, and a notice for the player. The
/// notice gives the reason (`trouble`) and the name under which the damaged database is kept.
pub(super) fn mended_bytes(
    damaged: &[u8],
    kept: &str,
    trouble: &DatabaseError,
) -> Result<(Connection, String), DatabaseError> {
    if !schema::begins_like_ours(damaged) {
        return Err(DatabaseError::begins_otherwise());
    }
    let mut old = Connection::open_in_memory()?;
    old.deserialize_read_exact("main", damaged, damaged.len(), true)?;
    let version = version_of_damaged(&old)?;
    let mut new = Connection::open_in_memory()?;
    let saved = refilled(&mut new, version, damaged)?;
    schema::prepare(&mut new)?;
    schema::check(&new)?;
    Ok((new, notice(&saved.reported(), kept, trouble)))
}

/// Creates the tables of this version in an empty database, and copies all readable rows of a
/// damaged one.
fn refilled(new: &mut Connection, version: i64, damaged: &[u8]) -> Result<Saved, DatabaseError> {
    schema::lay_out(new, version)?;
    let transaction = new.transaction()?;
    let saved = salvage(&mut Pages::of(damaged), &transaction)?;
    transaction.commit()?;
    Ok(saved)
}

/// The version of a damaged database, or the likeliest one if its schema is damaged too.
fn version_of_damaged(old: &Connection) -> Result<i64, DatabaseError> {
    limits::distrust(old)?;
    // Without these settings SQLite does not read a truncated file.
    old.set_db_config(DbConfig::SQLITE_DBCONFIG_DEFENSIVE, false)?;
    old.pragma_update(None, "writable_schema", true)?;
    Ok(
        match (schema::examine(old), schema::version_of_tables(old)) {
            (Ok(version), _) | (_, Ok(Some(version))) => version,
            _ => match schema::version(old) {
                Ok(version @ 1..=schema::VERSION) => version,
                _ => schema::VERSION,
            },
        },
    )
}

/// Writes a draft to the disk as one file.
fn finish(connection: &Connection) -> Result<(), DatabaseError> {
    connection.pragma_update(None, "journal_mode", "DELETE")?;
    Ok(())
}

/// Renames the damaged database, and gives its name to the draft; returns the damaged one's new
/// path.
fn put_in_place(damaged: &Path, draft: &Path) -> io::Result<PathBuf> {
    let kept = free_place(damaged);
    let folder = damaged.parent().unwrap_or(Path::new("."));
    // There is always a database under this name: the damaged one has two names until it is
    // replaced.
    if fs::hard_link(damaged, &kept).is_err() {
        fs::copy(damaged, &kept).inspect_err(|_| drop(fs::remove_file(&kept)))?;
    }
    fsync_dir(folder)?;
    // The log and similar files are renamed first, because the new database must not find them.
    for ending in ENDINGS.iter().filter(|ending| !ending.is_empty()) {
        if_there(fs::rename(
            with_ending(damaged, ending),
            with_ending(&kept, ending),
        ))?;
    }
    fs::rename(draft, damaged)?;
    fsync_dir(folder)?;
    Ok(kept)
}

/// An unused path beside a damaged database, under which it will be kept.
fn free_place(damaged: &Path) -> PathBuf {
    let place = |number: u32| damaged.with_file_name(format!("progress-damaged-{number}.db"));
    let is_free = |place: &PathBuf| !matches!(fs::exists(place), Ok(true));
    (1..).map(place).find(is_free).unwrap_or_else(|| place(0))
}

/// Removes a database and its other files, if they exist.
pub(super) fn remove(path: &Path) -> io::Result<()> {
    for ending in ENDINGS {
        if_there(fs::remove_file(with_ending(path, ending)))?;
    }
    Ok(())
}

/// The result of an action on a file; a missing file is not an error.
fn if_there<T>(done: io::Result<T>) -> io::Result<()> {
    match done {
        Err(error) if error.kind() != ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

pub(super) fn with_ending(path: &Path, ending: &str) -> PathBuf {
    let mut path = path.as_os_str().to_owned();
    path.push(ending);
    path.into()
}
