//! The versions of the database.
//!
//! `user_version` says which one a file has. A step leads from each version to the
//! next and is never changed once it was released; a change is a new step.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use rusqlite::config::DbConfig;
use rusqlite::{Connection, TransactionBehavior};

use super::error::DatabaseError;
use super::{bookmarks, tables};

/// The steps, each to the version of its place, from 1.
const STEPS: [&str; 3] = [
    include_str!("schema-1.sql"),
    include_str!("schema-2.sql"),
    include_str!("schema-3.sql"),
];

/// How every SQLite database begins.
pub(super) const MAGIC: &[u8] = b"SQLite format 3\0";

/// The present version.
pub(super) const VERSION: i64 = STEPS.len() as i64;

/// Brings a database to the present version, unless it is a newer one.
pub(super) fn prepare(connection: &mut Connection) -> Result<(), DatabaseError> {
    // Closing must not move anything about in a file that is not ours to change.
    let no_checkpoint = DbConfig::SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE;
    connection.set_db_config(no_checkpoint, true)?;
    let found = version(connection)?;
    if found > VERSION {
        return Err(DatabaseError::Newer(found));
    }
    connection.set_db_config(no_checkpoint, false)?;
    connection.pragma_update(None, "journal_mode", "WAL")?;
    connection.pragma_update(None, "synchronous", "FULL")?;
    if found < VERSION {
        upgrade(connection)?;
    }
    Ok(())
}

fn upgrade(connection: &mut Connection) -> Result<(), DatabaseError> {
    let transaction = connection.transaction_with_behavior(TransactionBehavior::Immediate)?;
    // Another carrom may have been first.
    let found = version(&transaction)?;
    let tables: i64 =
        transaction.query_row("SELECT count(*) FROM sqlite_schema", [], |row| row.get(0))?;
    let is_ours = match found {
        0 => tables == 0,
        _ => found > 0 && has_tables(&transaction, tables::QUERIES).is_ok(),
    };
    if !is_ours {
        return Err(DatabaseError::NotOurs);
    }
    take_steps(&transaction, found, VERSION)?;
    transaction.commit()?;
    Ok(())
}

/// Brings a database from one version to a later one.
fn take_steps(connection: &Connection, from: i64, to: i64) -> rusqlite::Result<()> {
    let steps = (1..)
        .zip(STEPS)
        .filter(|(leads_to, _)| (from + 1..=to).contains(leads_to));
    for (leads_to, step) in steps {
        connection.execute_batch(step)?;
        connection.pragma_update(None, "user_version", leads_to)?;
    }
    Ok(())
}

/// Lays out the tables of this version in an empty database.
pub(super) fn lay_out(connection: &Connection, version: i64) -> rusqlite::Result<()> {
    take_steps(connection, 0, version)
}

pub(super) fn version(connection: &Connection) -> Result<i64, DatabaseError> {
    Ok(connection.query_row("PRAGMA user_version", [], |row| row.get(0))?)
}

/// The version that the header of a file says, which is looked at as any file is: SQLite
/// would put files of its own beside it. `None` where there is no such header. (Database
/// File Format, section 1.3: the user version is the big-endian number at byte 60.)
pub(super) fn version_in_header(path: &Path) -> Option<i64> {
    let mut header = [0; 64];
    File::open(path).ok()?.read_exact(&mut header).ok()?;
    let (_, version) = header.split_last_chunk::<4>()?;
    header
        .starts_with(MAGIC)
        .then(|| i32::from_be_bytes(*version).into())
}

/// Fails unless the tables of these queries are there with all their columns.
fn has_tables(connection: &Connection, queries: [&str; 2]) -> rusqlite::Result<()> {
    let mut prepared = queries.iter().map(|query| connection.prepare(query));
    prepared.try_for_each(|it| it.map(drop))
}

/// Whether a file is a database of carrom's, damaged or not: it begins as one, but for a byte
/// at most, and holds near its beginning how the answers' table was made.
pub(super) fn is_ours(path: &Path) -> bool {
    let mut bytes = Vec::new();
    let read = File::open(path).and_then(|file| file.take(1 << 20).read_to_end(&mut bytes));
    let strange = bytes
        .iter()
        .zip(MAGIC)
        .filter(|(found, magic)| found != magic);
    let words = b"CREATE TABLE attempt (";
    read.is_ok() && strange.count() < 2 && bytes.windows(words.len()).any(|it| it == words)
}

/// Looks a database through, page by page.
pub(super) fn check_pages(connection: &Connection) -> Result<(), DatabaseError> {
    let found: String = connection.query_row("PRAGMA integrity_check(1)", [], |row| row.get(0))?;
    match found.as_str() {
        "ok" => Ok(()),
        // It says in which database of a connection, and there is one.
        _ => Err(DatabaseError::Damaged(
            found.replace("*** in database main ***", "").trim().into(),
        )),
    }
}

/// Looks a database of the present version through, page by page.
pub(super) fn check(connection: &Connection) -> Result<(), DatabaseError> {
    check_pages(connection)?;
    check_tables(connection)
}

/// Fails unless a database of the present version has all tables.
pub(super) fn check_tables(connection: &Connection) -> Result<(), DatabaseError> {
    [tables::QUERIES, bookmarks::QUERIES]
        .into_iter()
        .try_for_each(|queries| has_tables(connection, queries))
        .map_err(|_| DatabaseError::NotOurs)
}
