//! A damaged database mended: all that can still be read of it, in a new file. The damaged
//! one is kept under another name, as it was.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use rusqlite::types::ToSqlOutput;
use rusqlite::{Connection, ErrorCode, OpenFlags, params_from_iter};

use super::error::DatabaseError;
use super::{NAME, backup, limits, schema, size};
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

/// What could be saved.
#[derive(Debug, Default)]
struct Saved {
    /// Rows of each table, by its name, and whether all of it could be read.
    tables: Vec<(String, u64, bool)>,
    /// Answers that are missing between others.
    gaps: u64,
    /// The copy from which what could not be read was taken.
    backup: Option<String>,
}

/// Puts a mended database in the place of a damaged one, for that `trouble`; says what was
/// saved. Nobody else may use it meanwhile.
pub(super) fn mend(folder: &Path, trouble: &DatabaseError) -> Result<String, DatabaseError> {
    if !schema::is_ours(&folder.join(NAME)) {
        return Err(DatabaseError::begins_otherwise());
    }
    let (draft, copy) = (folder.join(DRAFT), folder.join(COPY));
    remove(&draft)?;
    copy_damaged(folder, &draft)?;
    // The answers themselves are whole if all that was damaged is an index.
    let saved = match reindexed(&draft) {
        Ok(()) => None,
        Err(error) if error.is_full() => return Err(error),
        Err(_) => {
            remove(&draft)?;
            copy_damaged(folder, &copy)?;
            let saved = salvaged(folder, &copy, &draft);
            remove(&copy)?;
            Some(saved?)
        }
    };
    let kept = put_in_place(folder, &draft)?;
    let saved = saved.map_or("Everything in it could be saved.".into(), |it| it.told());
    Ok(format!(
        "The file of your answers was damaged and is mended. {saved} The damaged file is kept \
         as {} ({trouble}).",
        folder.join(kept).display(),
    ))
}

/// Copies the damaged database, with what its first bytes should be.
fn copy_damaged(folder: &Path, to: &Path) -> io::Result<()> {
    remove(to)?;
    let from = folder.join(NAME);
    for ending in ["", "-wal"] {
        match fs::copy(with_ending(&from, ending), with_ending(to, ending)) {
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

/// Makes the draft a new database with every row of the damaged one that can be read.
fn salvaged(folder: &Path, damaged: &Path, draft: &Path) -> Result<Saved, DatabaseError> {
    let old = Connection::open_with_flags(damaged, OpenFlags::SQLITE_OPEN_READ_ONLY)?;
    // Else SQLite reads nothing of a file that has been cut off.
    old.pragma_update(None, "writable_schema", true)?;
    let version = match (schema::examine(&old), schema::version_of_tables(&old)) {
        (Ok(version), _) | (_, Ok(Some(version))) => version,
        _ => match schema::version(&old) {
            Ok(version @ 1..=schema::VERSION) => version,
            _ => schema::VERSION,
        },
    };
    let mut new = Connection::open(draft)?;
    schema::lay_out(&new, version)?;
    let mut saved = Saved::default();
    let transaction = new.transaction()?;
    for table in tables(&transaction)? {
        let (rows, is_whole) = copy(&old, &transaction, &table)?;
        saved.tables.push((table, rows, is_whole));
    }
    transaction.commit()?;
    if saved.tables.iter().any(|(.., is_whole)| !is_whole) {
        saved.backup = backup::fill_in(&new, folder, version, &saved.damaged())?;
    }
    saved.gaps = new.query_row(
        "SELECT coalesce(max(id), 0) - count(*) FROM attempt WHERE id > 0",
        [],
        |row| row.get::<_, i64>(0).map(i64::unsigned_abs),
    )?;
    schema::prepare(&mut new)?;
    schema::check(&new)?;
    finish(&new)?;
    Ok(saved)
}

/// Brings a draft to the disk as one file.
fn finish(connection: &Connection) -> Result<(), DatabaseError> {
    connection.pragma_update(None, "journal_mode", "DELETE")?;
    Ok(())
}

/// The names of the tables, in the order in which they were made.
pub(super) fn tables(connection: &Connection) -> rusqlite::Result<Vec<String>> {
    let mut names = connection
        .prepare("SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY rootpage")?;
    names.query_map([], |row| row.get(0))?.collect()
}

/// The names of a table's columns, or of those alone that rows are known by.
pub(super) fn columns(
    connection: &Connection,
    table: &str,
    only_key: bool,
) -> rusqlite::Result<Vec<String>> {
    let mut names = connection.prepare(
        "SELECT name FROM pragma_table_info(?1) WHERE pk > 0 OR NOT ?2 ORDER BY pk, cid",
    )?;
    names
        .query_map((table, only_key), |row| row.get(0))?
        .collect()
}

/// Copies the rows of a table as they are; says how many, and whether that is all of them.
/// Where the table cannot be read any further, the rest is read from its other end.
fn copy(old: &Connection, new: &Connection, table: &str) -> Result<(u64, bool), DatabaseError> {
    let key = columns(new, table, true)?;
    let columns = columns(new, table, false)?;
    let names = columns.join(", ");
    let places = vec!["?"; columns.len()].join(", ");
    let mut put = new.prepare(&format!(
        "INSERT OR IGNORE INTO {table} ({names}) VALUES ({places})"
    ))?;
    let (mut copied, mut is_whole) = (0, true);
    for direction in ["ASC", "DESC"] {
        let order = key.iter().map(|name| format!("{name} {direction}"));
        let order = order.collect::<Vec<_>>().join(", ");
        let sql = format!("SELECT {names} FROM {table} NOT INDEXED ORDER BY {order}");
        // What fails outside is the reading, inside the writing.
        let copying = old.prepare(&sql).and_then(|mut rows| {
            let mut rows = rows.query([])?;
            while let Some(row) = rows.next()? {
                // As they are: what they mean is a matter of whoever reads them.
                let values: rusqlite::Result<Vec<_>> =
                    (0..columns.len()).map(|i| row.get_ref(i)).collect();
                let values = values?.into_iter().map(ToSqlOutput::Borrowed);
                match put.execute(params_from_iter(values)) {
                    Ok(rows) => copied += rows as u64,
                    Err(error) if makes_no_sense(&error) => is_whole = false,
                    Err(error) => return Ok(Err(error)),
                }
            }
            Ok(Ok(()))
        });
        match copying {
            Ok(Ok(())) => break,
            Ok(Err(error)) => return Err(error.into()),
            Err(_) => is_whole = false,
        }
    }
    Ok((copied, is_whole))
}

/// Whether a row is none that its table may hold.
fn makes_no_sense(error: &rusqlite::Error) -> bool {
    error.sqlite_error_code() == Some(ErrorCode::ConstraintViolation)
}

/// Keeps the damaged database under another name, which it gives, and puts the draft in its
/// place.
fn put_in_place(folder: &Path, draft: &Path) -> io::Result<String> {
    let name = free_name(folder);
    let (from, to) = (folder.join(NAME), folder.join(&name));
    // There is a database at any moment: the damaged one has two names until the new one
    // takes its place.
    if fs::hard_link(&from, &to).is_err() {
        fs::copy(&from, &to)?;
    }
    fsync_dir(folder)?;
    // What belongs to it goes first: the new database must not find it.
    for ending in ENDINGS.iter().filter(|ending| !ending.is_empty()) {
        match fs::rename(with_ending(&from, ending), with_ending(&to, ending)) {
            Err(error) if error.kind() != ErrorKind::NotFound => return Err(error),
            _ => {}
        }
    }
    fs::rename(draft, &from)?;
    fsync_dir(folder)?;
    Ok(name)
}

/// A name for a damaged database that nothing has yet.
fn free_name(folder: &Path) -> String {
    let name = |number: u32| format!("progress-damaged-{number}.db");
    let is_free = |name: &String| !matches!(fs::exists(folder.join(name)), Ok(true));
    (1..).map(name).find(is_free).unwrap_or_else(|| name(0))
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

impl Saved {
    /// The tables of which not all could be read.
    fn damaged(&self) -> Vec<&str> {
        let damaged = self.tables.iter().filter(|(.., is_whole)| !is_whole);
        damaged.map(|(name, ..)| name.as_str()).collect()
    }

    /// What was saved and what was not, in sentences.
    fn told(&self) -> String {
        let counts = self.tables.iter().filter(|(_, rows, _)| *rows > 0);
        let counts: Vec<_> = counts.map(|(name, rows, _)| counted(name, *rows)).collect();
        let damaged = self.damaged();
        let mut told = match (counts.as_slice(), damaged.as_slice()) {
            ([], []) => return "There was nothing in it.".into(),
            ([], _) => "Nothing in it could be read.".into(),
            (counts, []) => {
                return format!("Everything in it could be saved: {}.", counts.join(", "));
            }
            (counts, _) => format!("Saved: {}.", counts.join(", ")),
        };
        let lost: Vec<_> = damaged.iter().map(|name| things(name).1).collect();
        match &self.backup {
            Some(backup) => {
                told += &format!(
                    " Of the {} some could not be read; those kept before were taken from \
                     {backup}.",
                    lost.join(" and the ")
                );
            }
            None => {
                told += &format!(" Not saved: some of the {}", lost.join(" and of the "));
                if damaged.contains(&"attempt") && self.gaps > 0 {
                    told += &format!(", {} or more", counted("attempt", self.gaps));
                }
                told += ".";
            }
        }
        told
    }
}

/// Rows of a table, as a player knows them.
fn counted(table: &str, rows: u64) -> String {
    let (one, more) = things(table);
    format!("{rows} {}", if rows == 1 { one } else { more })
}

/// What a table holds, as a player knows it: one of them, and more.
fn things(table: &str) -> (&str, &str) {
    match table {
        "attempt" => ("answer", "answers"),
        "star" => ("level won", "levels won"),
        "bookmark" => ("chapter begun", "chapters begun"),
        "page_seen" => ("page read", "pages read"),
        other => (other, other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_saved_and_what_not_is_told_in_a_players_words() {
        let saved = |answers, is_whole, gaps| {
            let tables = vec![
                ("attempt".into(), answers, is_whole),
                ("star".into(), 1, true),
            ];
            Saved {
                tables,
                gaps,
                backup: None,
            }
            .told()
        };
        assert_eq!(
            saved(730, true, 0),
            "Everything in it could be saved: 730 answers, 1 level won."
        );
        assert_eq!(
            saved(1, false, 1),
            "Saved: 1 answer, 1 level won. Not saved: some of the answers, 1 answer or more."
        );
    }
}
