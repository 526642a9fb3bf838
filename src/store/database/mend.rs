//! Repairs a damaged database: copies all readable rows into a new file. The damaged one is kept
//! unchanged under another name.

use std::fs::{self, File};
use std::io::{self, Cursor, ErrorKind, Read, Seek, Write};
use std::path::{Path, PathBuf};

use rusqlite::Connection;
use rusqlite::config::DbConfig;

use super::error::DatabaseError;
use super::pages::Pages;
use super::salvage::{Saved, salvage};
use super::{backup, limits, path, schema, size};
use crate::files::fsync_dir;

/// The new file, until it is whole.
const DRAFT: &str = ".progress-mended.db";
/// A copy of the damaged one that may be worked on.
const COPY: &str = ".progress-copy.db";
/// The first bytes of every database of carrom's: the name of the format, pages of 4,096
/// bytes, a log, nothing reserved, and three fixed numbers. (Database File Format, section
/// 1.3.)
const HEADER: [u8; 24] = *b"SQLite format 3\0\x10\0\x02\x02\0\x40\x20\x20";
/// How the names of the files end that belong to a database, those beside it first.
pub(super) const ENDINGS: [&str; 4] = ["-journal", "-wal", "-shm", ""];

/// A database that is not finished; removed, with all that belongs to it, unless it is put in
/// its place.
pub(super) struct Draft(PathBuf);

impl Draft {
    /// A draft of this name beside a file. What a killed carrom left there is removed.
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
        // What cannot be removed takes some room, no more.
        let _ = remove(&self.0);
    }
}

/// Puts a mended database in the place of a damaged one, for that `trouble`; says what was
/// saved. Nobody else may use it meanwhile.
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
        "The file of your answers was damaged and is repaired. {saved} The damaged file is kept \
         as {kept} ({trouble})."
    )
}

/// Reports what was saved, and where the damaged one is kept.
fn mended(folder: &Path, damaged: &Path) -> Result<(String, PathBuf), DatabaseError> {
    let draft = Draft::beside(damaged, DRAFT)?;
    copy_damaged(damaged, draft.path())?;
    // The answers themselves are whole if all that was damaged is an index.
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

/// Copies a damaged database, with what its first bytes should be.
fn copy_damaged(from: &Path, to: &Path) -> io::Result<()> {
    for ending in ["", "-wal"] {
        match fs::copy(with_ending(from, ending), with_ending(to, ending)) {
            Err(error) if error.kind() != ErrorKind::NotFound => return Err(error),
            _ => {}
        }
    }
    File::options().write(true).open(to)?.write_all(&HEADER)
}

/// Makes new indexes; fails unless the database is sound then.
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

/// Makes the draft a new database with every row of the damaged one that can be read, and with
/// those of the latest copy where some could not be.
fn salvaged(folder: &Path, damaged: &Path, draft: &Path) -> Result<Saved, DatabaseError> {
    // The last connection that closes moves what is in the log into the pages.
    let version = version_of_damaged(&Connection::open(damaged)?)?;
    let mut new = Connection::open(draft)?;
    let mut saved = refilled(&mut new, version, File::open(damaged)?)?;
    if !saved.damaged().is_empty() {
        saved.copy = backup::fill_in(&new, folder, version, saved.damaged())?;
    }
    schema::prepare(&mut new)?;
    schema::check(&new)?;
    finish(&new)?;
    Ok(saved)
}

/// A database in memory with every row of a damaged one that can be read, and what the player
/// is to know of it: that was damaged for this `trouble`, and is kept under this name.
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
    let saved = refilled(&mut new, version, Cursor::new(damaged))?;
    schema::prepare(&mut new)?;
    schema::check(&new)?;
    Ok((new, notice(&saved.reported(), kept, trouble)))
}

/// Makes an empty database one of this version, with every row that can be read of a damaged
/// one.
fn refilled(
    new: &mut Connection,
    version: i64,
    damaged: impl Read + Seek,
) -> Result<Saved, DatabaseError> {
    schema::lay_out(new, version)?;
    let transaction = new.transaction()?;
    let saved = salvage(&mut Pages::of(damaged)?, &transaction)?;
    transaction.commit()?;
    Ok(saved)
}

/// Which version a damaged database has, or may have.
fn version_of_damaged(old: &Connection) -> Result<i64, DatabaseError> {
    limits::distrust(old)?;
    // Else SQLite reads nothing of a file that has been cut off.
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

/// Brings a draft to the disk as one file.
fn finish(connection: &Connection) -> Result<(), DatabaseError> {
    connection.pragma_update(None, "journal_mode", "DELETE")?;
    Ok(())
}

/// Keeps the damaged database under another name, and puts the draft in its place; says where
/// the damaged one is.
fn put_in_place(damaged: &Path, draft: &Path) -> io::Result<PathBuf> {
    let kept = free_place(damaged);
    let folder = damaged.parent().unwrap_or(Path::new("."));
    // There is a database at any moment: the damaged one has two names until the new one
    // takes its place.
    if fs::hard_link(damaged, &kept).is_err() {
        fs::copy(damaged, &kept).inspect_err(|_| drop(fs::remove_file(&kept)))?;
    }
    fsync_dir(folder)?;
    // What belongs to it goes first: the new database must not find it.
    for ending in ENDINGS.iter().filter(|ending| !ending.is_empty()) {
        match fs::rename(with_ending(damaged, ending), with_ending(&kept, ending)) {
            Err(error) if error.kind() != ErrorKind::NotFound => return Err(error),
            _ => {}
        }
    }
    fs::rename(draft, damaged)?;
    fsync_dir(folder)?;
    Ok(kept)
}

/// A place beside it for a damaged database where nothing is yet.
fn free_place(damaged: &Path) -> PathBuf {
    let place = |number: u32| damaged.with_file_name(format!("progress-damaged-{number}.db"));
    let is_free = |place: &PathBuf| !matches!(fs::exists(place), Ok(true));
    (1..).map(place).find(is_free).unwrap_or_else(|| place(0))
}

/// Removes a database and all that belongs to it, if it is there.
pub(super) fn remove(path: &Path) -> io::Result<()> {
    for ending in ENDINGS {
        match fs::remove_file(with_ending(path, ending)) {
            Err(error) if error.kind() != ErrorKind::NotFound => return Err(error),
            _ => {}
        }
    }
    Ok(())
}

pub(super) fn with_ending(path: &Path, ending: &str) -> PathBuf {
    let mut path = path.as_os_str().to_owned();
    path.push(ending);
    path.into()
}
