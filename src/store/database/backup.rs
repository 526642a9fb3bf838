//! Copies of the database, one a day; the last three are kept.

use std::fs;
use std::path::Path;

use jiff::civil::Date;
use rusqlite::Connection;
use rusqlite::backup::Backup;

use super::error::DatabaseError;
use super::mend::{columns, remove};
use super::{schema, unchanged};
use crate::files::fsync_dir;

/// How many are kept.
const KEPT: usize = 3;
/// A copy, until it is whole.
const DRAFT: &str = ".progress-backup.db";
/// How their names begin; then comes the day.
const START: &str = "progress-backup-";

/// Keeps a copy of a sound database as that of this day, unless there is one. Nobody else
/// may do so meanwhile.
pub(super) fn keep(
    connection: &Connection,
    folder: &Path,
    today: Date,
) -> Result<(), DatabaseError> {
    let path = folder.join(format!("{START}{today}.db"));
    if fs::exists(&path)? {
        return Ok(());
    }
    let draft = folder.join(DRAFT);
    remove(&draft)?;
    let mut copy = Connection::open(&draft)?;
    Backup::new(connection, &mut copy)?.step(-1)?;
    // One file, that can be looked at without another beside it.
    copy.pragma_update(None, "journal_mode", "DELETE")?;
    drop(copy);
    fs::rename(&draft, &path)?;
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
    names.sort();
    names.reverse();
    names
}

/// Adds what these tables lack from the latest copy of the same version; says which that is.
pub(super) fn fill_in(
    new: &Connection,
    folder: &Path,
    version: i64,
    tables: &[&str],
) -> Result<Option<String>, DatabaseError> {
    for name in names(folder) {
        let path = folder.join(&name);
        let is_sound = unchanged::examine(&path).is_ok_and(|it| it == version)
            && unchanged::connection(&path).is_ok_and(|copy| schema::check(&copy).is_ok());
        if !is_sound {
            continue;
        }
        new.execute("ATTACH ?1 AS copy", [path.to_string_lossy()])?;
        for table in tables {
            let columns = columns(new, table, false)?.join(", ");
            new.execute_batch(&format!(
                "INSERT OR IGNORE INTO main.{table} ({columns}) SELECT {columns} FROM copy.{table}"
            ))?;
        }
        new.execute_batch("DETACH copy")?;
        return Ok(Some(name));
    }
    Ok(None)
}
