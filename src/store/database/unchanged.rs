//! Databases that cannot or must not be changed, such as those on a read-only disk or owned by
//! another user.

use std::fs;
use std::path::Path;

use rusqlite::backup::Backup;
use rusqlite::{Connection, OpenFlags};

use super::error::DatabaseError;
use super::mend::with_ending;
use super::{limits, schema, size};
use crate::files::percent_encoded;

/// Opens a database for reading; checks it first if `checked`. The only file that SQLite may create
/// is the index of an existing log.
pub(super) fn open(path: &Path, checked: bool) -> Result<Connection, DatabaseError> {
    let log = with_ending(path, "-wal");
    let connection = connection(path)?;
    let found = match schema::examine(&*connection.unchecked_transaction()?) {
        Err(trouble @ DatabaseError::Sqlite(_)) if !trouble.is_damage() && is_in_log(&log) => {
            let name = log.file_name().unwrap_or_default().display().to_string();
            return Err(DatabaseError::InLog(name));
        }
        found => found?,
    };
    if checked {
        schema::check(&connection)?;
    }
    if found < schema::VERSION {
        return brought_up(&connection);
    }
    Ok(connection)
}

/// The version of a database that this version of carrom can read. Neither the database nor its log
/// is changed.
pub(super) fn examine(path: &Path) -> Result<i64, DatabaseError> {
    schema::examine(&*connection(path)?.unchecked_transaction()?)
}

/// A read-only connection.
pub(super) fn connection(path: &Path) -> Result<Connection, DatabaseError> {
    // An immutable database needs no locks, but SQLite does not read its log.
    let how = if is_in_log(&with_ending(path, "-wal")) {
        "mode=ro"
    } else {
        "immutable=1"
    };
    let flags = OpenFlags::SQLITE_OPEN_READ_ONLY | OpenFlags::SQLITE_OPEN_URI;
    let mut connection = Connection::open_with_flags(address(path, how), flags)?;
    limits::distrust(&connection)?;
    limits::limit_work(&mut connection, size(path))?;
    Ok(connection)
}

/// Whether a log exists and is not empty.
fn is_in_log(log: &Path) -> bool {
    fs::metadata(log).is_ok_and(|about| about.len() > 0)
}

/// A copy in memory of an older database, upgraded to the current version.
fn brought_up(older: &Connection) -> Result<Connection, DatabaseError> {
    let mut copy = Connection::open_in_memory()?;
    Backup::new(older, &mut copy)?.step(-1)?;
    schema::prepare(&mut copy)?;
    Ok(copy)
}

/// A path as a URI with this parameter, which determines how SQLite opens the file.
fn address(path: &Path, how: &str) -> String {
    let path = percent_encoded(path.as_os_str().as_encoded_bytes());
    format!("file:{path}?{how}")
}
