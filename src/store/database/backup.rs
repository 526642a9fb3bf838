//! Copies of the database, one per day; the last three are kept.

use std::fs;
use std::path::Path;

use jiff::civil::Date;
use rusqlite::Connection;
use rusqlite::backup::Backup;

use super::error::DatabaseError;
use super::mend::Draft;
use super::salvage::{Columns, RowCounts};
use super::{schema, unchanged};
use crate::files::fsync_dir;

const KEPT: usize = 3;
/// The temporary name of an unfinished copy.
const DRAFT: &str = ".progress-backup.db";
/// The start of the copies' names; the day follows.
const START: &str = "progress-backup-";

/// Makes today's copy of an undamaged database, unless the copy already exists. The caller must
/// hold the lock.
pub(super) fn keep(
    connection: &Connection,
    folder: &Path,
    today: Date,
) -> Result<(), DatabaseError> {
    let path = folder.join(format!("{START}{today}.db"));
    if fs::exists(&path)? {
        return Ok(());
    }
    let draft = Draft::beside(&path, DRAFT)?;
    let mut copy = Connection::open(draft.path())?;
    Backup::new(connection, &mut copy)?.step(-1)?;
    // This makes the copy a single file that can be opened without a log.
    copy.pragma_update(None, "journal_mode", "DELETE")?;
    drop(copy);
    fs::rename(draft.path(), &path)?;
    fsync_dir(folder)?;
    for name in names(folder).iter().skip(KEPT) {
        fs::remove_file(folder.join(name))?;
    }
    Ok(())
}

/// The names of the copies, the latest first.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
    let mut names: Vec<_> = names
        .filter(|name| name.starts_with(START) && name.ends_with(".db"))
        .collect();
    names.sort_unstable_by(|a, b| b.cmp(a));
    names
}

/// Adds missing rows from the latest undamaged copy of the same version; returns the copy's name,
/// and how many rows were added to each table.
pub(super) fn fill_in(
    new: &Connection,
    folder: &Path,
    version: i64,
    tables: &[String],
) -> Result<Option<(String, RowCounts)>, DatabaseError> {
    for name in names(folder) {
        let path = folder.join(&name);
        let is_sound = unchanged::examine(&path).is_ok_and(|it| it == version)
            && unchanged::connection(&path).is_ok_and(|copy| schema::check(&copy).is_ok());
        if !is_sound {
            continue;
        }
        new.execute("ATTACH ?1 AS copy", [path.to_string_lossy()])?;
        let mut added = Vec::new();
        for table in tables {
            let columns = Columns::of(new, table)?.names.join(", ");
            let rows = new.execute(
                &format!(
                    "INSERT OR IGNORE INTO main.{table} ({columns}) \
                     SELECT {columns} FROM copy.{table}"
                ),
                [],
            )?;
            added.push((table.clone(), rows));
        }
        new.execute_batch("DETACH copy")?;
        return Ok(Some((name, added)));
    }
    Ok(None)
}
