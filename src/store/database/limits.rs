//! Limits for a database that anybody may have written: its schema runs nothing, and no
//! statement works for longer than a file of its size needs.

use rusqlite::Connection;
use rusqlite::config::DbConfig;

/// How many instructions SQLite runs between two looks at the budget.
const STEP: u32 = 1000;
/// Steps that any database may take.
const STEPS: u64 = 10_000;
/// Further steps for each kibibyte of its file. Upgrading, checking and reading everything
/// takes about 10.
const STEPS_PER_KIB: u64 = 64;

/// Has a connection use nothing of a schema but its tables and indexes.
pub(super) fn distrust(connection: &Connection) -> rusqlite::Result<()> {
    for (config, is_on) in [
        (DbConfig::SQLITE_DBCONFIG_DEFENSIVE, true),
        (DbConfig::SQLITE_DBCONFIG_TRUSTED_SCHEMA, false),
        (DbConfig::SQLITE_DBCONFIG_ENABLE_VIEW, false),
        (DbConfig::SQLITE_DBCONFIG_ENABLE_TRIGGER, false),
    ] {
        connection.set_db_config(config, is_on)?;
    }
    Ok(())
}

/// Interrupts a connection once it has worked for longer than any database of this many
/// bytes needs.
pub(super) fn limit_work(connection: &mut Connection, bytes: u64) -> rusqlite::Result<()> {
    let mut left = STEPS + bytes / 1024 * STEPS_PER_KIB;
    let is_spent = move || {
        left = left.saturating_sub(1);
        left == 0
    };
    connection.progress_handler(STEP.cast_signed(), Some(is_spent))
}

/// Lets a connection work for as long as it likes: what it holds is known.
pub(super) fn unlimit_work(connection: &mut Connection) -> rusqlite::Result<()> {
    connection.progress_handler(0, None::<fn() -> bool>)
}
