//! Limits for an untrusted database: its schema cannot run code, and a connection can do only a
//! limited amount of work, which depends on the database's size.

use rusqlite::Connection;
use rusqlite::config::DbConfig;

/// How many instructions SQLite runs between two checks of the budget.
const STEP: u32 = 1000;
/// The number of steps that any database may use.
const STEPS: u64 = 10_000;
/// The number of further steps for each kibibyte of the file. Upgrading, checking and reading
/// everything requires about 10.
const STEPS_PER_KIB: u64 = 64;

/// Restricts a connection to the tables and indexes of a schema.
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

/// Interrupts a connection once it has done more work than any database of `bytes` bytes
/// requires.
pub(super) fn limit_work(connection: &mut Connection, bytes: u64) -> rusqlite::Result<()> {
    let mut left = STEPS + bytes / 1024 * STEPS_PER_KIB;
    let is_spent = move || {
        left = left.saturating_sub(1);
        left == 0
    };
    connection.progress_handler(STEP.cast_signed(), Some(is_spent))
}

/// Removes the limit on work, once the database has been checked.
pub(super) fn unlimit_work(connection: &mut Connection) -> rusqlite::Result<()> {
    connection.progress_handler(0, None::<fn() -> bool>)
}

#[cfg(test)]
mod tests {
    use rusqlite::ErrorCode;

    use super::*;

    #[test]
    fn an_endless_query_is_interrupted() {
        let mut connection = Connection::open_in_memory().unwrap();
        limit_work(&mut connection, 0).unwrap();
        let endless = "WITH RECURSIVE number (n) AS (SELECT 1 UNION ALL SELECT n + 1 FROM number) \
            SELECT count(*) FROM number";
        let count = connection.query_row(endless, [], |row| row.get::<_, i64>(0));
        let code = count.unwrap_err().sqlite_error_code();
        assert_eq!(code, Some(ErrorCode::OperationInterrupted));
    }

    #[test]
    fn a_schema_is_not_trusted_and_cannot_be_written() {
        let connection = Connection::open_in_memory().unwrap();
        distrust(&connection).unwrap();
        connection.execute_batch("CREATE TABLE t (x)").unwrap();
        let trusted = connection.query_row("PRAGMA trusted_schema", [], |row| row.get(0));
        assert_eq!(trusted, Ok(false));
        let changed = "PRAGMA writable_schema = 1; DELETE FROM sqlite_schema";
        assert!(connection.execute_batch(changed).is_err());
        connection
            .execute_batch("CREATE VIEW v AS SELECT x FROM t")
            .unwrap();
        assert!(connection.prepare("SELECT x FROM v").is_err());
    }
}
