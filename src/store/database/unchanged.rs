//! A database where nothing can be written: a copy on a disk for reading, or somebody
//! else's.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use rusqlite::backup::Backup;
use rusqlite::{Connection, OpenFlags};

use super::error::DatabaseError;
use super::schema;

/// Opens the database of this name in `folder` to look things up, without a file beside
/// it; looks it through first if it is to be `checked`.
pub(super) fn open(folder: &Path, name: &str, checked: bool) -> Result<Connection, DatabaseError> {
    let log = format!("{name}-wal");
    let in_log = fs::metadata(folder.join(&log)).is_ok_and(|about| about.len() > 0);
    // What cannot change needs no locks, but its log is not looked at either.
    let how = if in_log { "mode=ro" } else { "immutable=1" };
    let flags = OpenFlags::SQLITE_OPEN_READ_ONLY | OpenFlags::SQLITE_OPEN_URI;
    let connection = Connection::open_with_flags(address(&folder.join(name), how), flags)?;
    let found = match schema::version(&connection) {
        Ok(found) if found > schema::VERSION => return Err(DatabaseError::Newer(found)),
        Ok(found) => found,
        Err(trouble) if trouble.is_damage() => return Err(trouble),
        Err(_) if in_log => return Err(DatabaseError::InLog(log)),
        Err(trouble) => return Err(trouble),
    };
    if checked {
        schema::check_pages(&connection)?;
    }
    if found < schema::VERSION {
        return brought_up(&connection);
    }
    schema::check_tables(&connection)?;
    Ok(connection)
}

/// A copy in memory of an older database that cannot be changed, in the present version.
fn brought_up(older: &Connection) -> Result<Connection, DatabaseError> {
    let mut copy = Connection::open_in_memory()?;
    Backup::new(older, &mut copy)?.step(-1)?;
    schema::prepare(&mut copy)?;
    Ok(copy)
}

/// A path as the address of a file, all that means something there in percent.
fn address(path: &Path, how: &str) -> String {
    let mut address = String::from("file:");
    for byte in path.as_os_str().as_encoded_bytes() {
        match byte {
            b'/' | b'-' | b'.' | b'_' | b'0'..=b'9' | b'A'..=b'Z' | b'a'..=b'z' => {
                address.push(char::from(*byte));
            }
            byte => {
                // Writing to a text cannot fail.
                let _ = write!(address, "%{byte:02X}");
            }
        }
    }
    address + "?" + how
}
