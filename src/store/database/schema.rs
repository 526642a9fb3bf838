//! The versions of the database.
//!
//! `user_version` is the version of a file. A step leads from each version to the next. A step is
//! never changed once it is released; every change needs a new step. Each step from the fourth on
//! must change the schema, so that a number that is too high for the schema is known to be damaged
//! and not that of a newer version of carrom.

use std::fs::File;
use std::io::Read;
use std::path::Path;
use std::sync::OnceLock;

use rusqlite::config::DbConfig;
use rusqlite::{Connection, TransactionBehavior};

use super::error::DatabaseError;
use super::limits;
use crate::files::escape_control;

/// The steps; step n, counted from 1, leads to version n.
const STEPS: [&str; 4] = [
    include_str!("schema-1.sql"),
    include_str!("schema-2.sql"),
    include_str!("schema-3.sql"),
    include_str!("schema-4.sql"),
];

/// The first bytes of every SQLite database.
pub(super) const MAGIC: &[u8] = b"SQLite format 3\0";

pub(super) const VERSION: i64 = STEPS.len() as i64;

/// A table, an index or anything else in a schema.
#[derive(PartialEq, Eq)]
struct SchemaItem {
    kind: String,
    name: String,
    /// Its definition in the schema, without spaces and comments.
    text: Vec<u8>,
}

/// The largest number of wrong letters in a schema that is still recognized as carrom's.
const WRONG_LETTERS: usize = 4;

/// Upgrades a database to the current version, unless it is newer.
pub(super) fn prepare(connection: &mut Connection) -> Result<(), DatabaseError> {
    // Closing must not change a file that is not carrom's.
    let no_checkpoint = DbConfig::SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE;
    connection.set_db_config(no_checkpoint, true)?;
    limits::distrust(connection)?;
    let found = examine(&*connection.unchecked_transaction()?)?;
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
    // Another process may have upgraded the database in the meantime.
    let found = examine(&transaction)?;
    take_steps(&transaction, found, VERSION)?;
    transaction.commit()?;
    Ok(())
}

/// The version of a database, if this version of carrom can read it. The number must fit the
/// schema, and the schema must be one that carrom creates, because a view instead of a table could
/// make any query endless. The caller must begin a transaction, so that the number and the schema
/// are read at the same time.
pub(super) fn examine(connection: &Connection) -> Result<i64, DatabaseError> {
    let found = version(connection)?;
    let items = items(connection)?;
    let known = known()?;
    let is_of = |version: i64| {
        let known = usize::try_from(version).ok().and_then(|it| known.get(it));
        known.is_some_and(|known| *known == items)
    };
    if is_of(found) {
        return Ok(found);
    }
    if let Some(version) = (1..=VERSION).rev().find(|version| is_of(*version)) {
        return Err(DatabaseError::Damaged(format!(
            "its format number is {found}, but its tables are those of format {version}"
        )));
    }
    if found > VERSION {
        return Err(DatabaseError::Newer(found));
    }
    if known.iter().skip(1).any(|known| is_nearly(&items, known)) {
        let why = "the description of its tables is damaged";
        return Err(DatabaseError::Damaged(why.into()));
    }
    let strange = items
        .iter()
        .find(|item| !known.iter().flatten().any(|it| it == *item));
    Err(DatabaseError::NotOurs(
        strange.map_or("carrom's tables are missing".into(), |it| {
            format!("carrom did not create its {} “{}”", it.kind, it.name)
        }),
    ))
}

/// The latest version with the schema of this database; `None` if there is none.
pub(super) fn version_of_tables(connection: &Connection) -> Result<Option<i64>, DatabaseError> {
    let items = items(connection)?;
    let known = (0..).zip(known()?).skip(1);
    let same = known.filter(|(_, known)| **known == items);
    Ok(same.map(|(version, _)| version).last())
}

/// The items in the schema of a database, without SQLite's statistics for queries.
fn items(connection: &Connection) -> rusqlite::Result<Vec<SchemaItem>> {
    let mut items = connection.prepare(
        "SELECT type, name, tbl_name, sql FROM sqlite_schema \
         WHERE name NOT GLOB 'sqlite_stat[0-9]' ORDER BY name, type",
    )?;
    let items = items.query_map([], |row| {
        let bytes = |column| row.get_ref(column).map(|it| it.as_bytes_or_null());
        let readable = |column| match bytes(column) {
            Ok(Ok(Some(bytes))) => escape_control(&String::from_utf8_lossy(bytes), 40),
            _ => "part".into(),
        };
        let mut text = Vec::new();
        for column in 0..4 {
            let bytes = bytes(column)?.ok().flatten().unwrap_or_default();
            for line in bytes.split(|byte| *byte == b'\n') {
                let end = line.windows(2).position(|it| it == b"--");
                let line = line.get(..end.unwrap_or(line.len())).unwrap_or_default();
                text.extend(line.iter().filter(|byte| !byte.is_ascii_whitespace()));
            }
            text.push(b' ');
        }
        Ok(SchemaItem {
            kind: readable(0),
            name: readable(1),
            text,
        })
    })?;
    items.collect()
}

/// The items in the schema of each version, from 0, which is empty.
fn known() -> rusqlite::Result<&'static [Vec<SchemaItem>]> {
    static KNOWN: OnceLock<Vec<Vec<SchemaItem>>> = OnceLock::new();
    if let Some(known) = KNOWN.get() {
        return Ok(known);
    }
    let known = (0..=VERSION).map(|version| {
        let empty = Connection::open_in_memory()?;
        lay_out(&empty, version)?;
        items(&empty)
    });
    let known = known.collect::<rusqlite::Result<_>>()?;
    Ok(KNOWN.get_or_init(|| known))
}

/// Whether a schema differs from another in so few letters that it must be a damaged copy.
fn is_nearly(items: &[SchemaItem], known: &[SchemaItem]) -> bool {
    let text =
        |items: &[SchemaItem]| -> Vec<u8> { items.iter().flat_map(|it| it.text.clone()).collect() };
    let (items, known) = (text(items), text(known));
    items.len() == known.len()
        && items.iter().zip(&known).filter(|(a, b)| a != b).count() <= WRONG_LETTERS
}

/// Upgrades a database from one version to a later one.
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

/// Creates the tables of this version in an empty database.
pub(super) fn lay_out(connection: &Connection, version: i64) -> rusqlite::Result<()> {
    take_steps(connection, 0, version)
}

pub(super) fn version(connection: &Connection) -> Result<i64, DatabaseError> {
    Ok(connection.query_row("PRAGMA user_version", [], |row| row.get(0))?)
}

/// The version in the header of a file; `None` if there is no such header. The file is read as an
/// ordinary file, because SQLite would create files beside it. (Database File Format, section 1.3:
/// the user version is the big-endian number at byte 60.)
pub(super) fn version_in_header(path: &Path) -> Option<i64> {
    let mut header = [0; 64];
    File::open(path).ok()?.read_exact(&mut header).ok()?;
    let (_, version) = header.split_last_chunk::<4>()?;
    header
        .starts_with(MAGIC)
        .then(|| i32::from_be_bytes(*version).into())
}

/// Whether a file is a carrom database, damaged or not.
pub(super) fn is_ours(path: &Path) -> bool {
    let mut start = Vec::new();
    let read = File::open(path).and_then(|file| file.take(1 << 20).read_to_end(&mut start));
    read.is_ok() && begins_like_ours(&start)
}

/// Whether these are the first bytes of a carrom database, damaged or not: they start like every
/// database, except for at most one byte, and contain the definition of the answers' table or of
/// its index.
pub(super) fn begins_like_ours(start: &[u8]) -> bool {
    let strange = start
        .iter()
        .zip(MAGIC)
        .filter(|(found, magic)| found != magic);
    let holds = |words: &str| start.windows(words.len()).any(|it| it == words.as_bytes());
    strange.count() < 2
        && (holds("CREATE TABLE attempt (") || holds("CREATE INDEX attempt_of_player ON"))
}

/// Checks a database page by page.
pub(super) fn check(connection: &Connection) -> Result<(), DatabaseError> {
    let found: String = connection.query_row("PRAGMA integrity_check(1)", [], |row| row.get(0))?;
    match found.as_str() {
        "ok" => Ok(()),
        // SQLite's report begins with the name of the database, which is left out, because a
        // connection here has only one database.
        _ => Err(DatabaseError::Damaged(
            found.replace("*** in database main ***", "").trim().into(),
        )),
    }
}
