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
    TOPICS_BY_ID,
];

/// The step of version 3, which changes rows and no tables.
const TOPICS_BY_ID: &str = include_str!("schema-3.sql");

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
        return Err(DatabaseError::Damaged(
            "it is no database of carrom's".into(),
        ));
    }
    for step in STEPS
        .iter()
        .skip(usize::try_from(found).unwrap_or_default())
    {
        transaction.execute_batch(step)?;
    }
    if found < VERSION {
        transaction.pragma_update(None, "user_version", VERSION)?;
    }
    transaction.commit()?;
    Ok(())
}

/// Lets the answers of an older database, which cannot be changed, be looked up as those of
/// the present version: through a copy that is gone with the connection.
pub(super) fn overlay(connection: &Connection, found: i64) -> rusqlite::Result<()> {
    if found < VERSION {
        connection.execute_batch(
            "PRAGMA temp_store = MEMORY; CREATE TEMP TABLE attempt AS SELECT * FROM main.attempt;",
        )?;
        connection.execute_batch(TOPICS_BY_ID)?;
    }
    Ok(())
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
        .starts_with(b"SQLite format 3\0")
        .then(|| i32::from_be_bytes(*version).into())
}

/// Fails unless the tables of these queries are there with all their columns.
fn has_tables(connection: &Connection, queries: [&str; 2]) -> rusqlite::Result<()> {
    let mut prepared = queries.iter().map(|query| connection.prepare(query));
    prepared.try_for_each(|it| it.map(drop))
}

/// Looks a database of the present version through, page by page.
pub(super) fn check(connection: &Connection) -> Result<(), DatabaseError> {
    let found: String = connection.query_row("PRAGMA quick_check(1)", [], |row| row.get(0))?;
    if found != "ok" {
        return Err(DatabaseError::Damaged(found));
    }
    [tables::QUERIES, bookmarks::QUERIES]
        .into_iter()
        .try_for_each(|queries| has_tables(connection, queries))
        .map_err(|_| DatabaseError::Damaged("its tables are not those of carrom".into()))
}
