//! The errors of a database.

use std::io::{self, ErrorKind};

use rusqlite::ErrorCode;
use thiserror::Error;

use super::schema::VERSION;

/// Why a request to the database failed.
#[derive(Debug, Error)]
pub(super) enum DatabaseError {
    /// The database is damaged; this is SQLite's message.
    #[error("it is damaged; SQLite reports: {0}")]
    Damaged(String),
    /// The database is damaged and was not repaired, for this reason.
    #[error("it is damaged and could not be repaired: {0}")]
    Unmended(Box<DatabaseError>),
    /// The file is not a carrom database, for this reason.
    #[error("it is not a carrom database: {0}")]
    NotOurs(String),
    /// Something that is not a file has the name of the database.
    #[error("{0}")]
    NoFile(String),
    /// A newer version of carrom has written the database, in the format with this number.
    #[error(
        "a newer version of carrom wrote it (format {0}; this one knows formats up to {VERSION}), \
         so it is left unchanged"
    )]
    Newer(i64),
    /// Part of the data is in the database's log, and nothing can be written.
    #[error(
        "the latest data is in {0}, which cannot be read in a read-only folder; copy the folder to \
         one that can be written to"
    )]
    InLog(String),
    #[error("{}", in_words(.0))]
    Sqlite(#[from] rusqlite::Error),
    /// The folder cannot be used.
    #[error("{}", if is_full(.0) { no_room(.0) } else { .0.to_string() })]
    Folder(#[from] io::Error),
}

impl DatabaseError {
    /// The error for a file that does not start like a carrom database.
    pub(super) fn begins_otherwise() -> Self {
        Self::NotOurs("it does not start like one".into())
    }

    /// Whether a later attempt may succeed.
    pub(super) fn is_busy(&self) -> bool {
        self.is_any_of(&[ErrorCode::DatabaseBusy, ErrorCode::DatabaseLocked])
    }

    /// Whether another file, or something that is not a file, has the name of the database.
    pub(super) fn is_strange(&self) -> bool {
        matches!(self, Self::NotOurs(_) | Self::NoFile(_))
    }

    /// Whether the file is damaged. An interruption means damage too, because an undamaged database
    /// never exceeds the limit on work.
    pub(super) fn is_damage(&self) -> bool {
        use ErrorCode::{DatabaseCorrupt, NotADatabase, OperationInterrupted};
        matches!(self, Self::Damaged(_))
            || self.is_any_of(&[DatabaseCorrupt, NotADatabase, OperationInterrupted])
    }

    /// Whether the disk is full.
    pub(super) fn is_full(&self) -> bool {
        self.is_any_of(&[ErrorCode::DiskFull])
            || matches!(self, Self::Folder(error) if is_full(error))
    }

    /// Whether the disk may be full: for some of its files SQLite reports only that they cannot be
    /// created or written.
    pub(super) fn may_be_full(&self) -> bool {
        self.is_any_of(&[ErrorCode::SystemIoFailure, ErrorCode::CannotOpen])
    }

    /// Whether carrom is not allowed to write to the file or its folder.
    pub(super) fn is_forbidden(&self) -> bool {
        match self {
            Self::Folder(error) => matches!(
                error.kind(),
                ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem
            ),
            _ => self.is_any_of(&[ErrorCode::ReadOnly, ErrorCode::CannotOpen]),
        }
    }

    /// Whether this is an error of SQLite with one of these codes.
    fn is_any_of(&self, codes: &[ErrorCode]) -> bool {
        let Self::Sqlite(error) = self else {
            return false;
        };
        { error.sqlite_error_code() }.is_some_and(|code| codes.contains(&code))
    }
}

/// Whether something could not be written because the disk is full.
pub(super) fn is_full(error: &io::Error) -> bool {
    let full = [ErrorKind::StorageFull, ErrorKind::QuotaExceeded];
    full.contains(&error.kind())
}

/// The message for a full disk, with the reported reason.
pub(super) fn no_room(why: &dyn std::error::Error) -> String {
    format!("there is no room on the disk ({why})")
}

/// An explanation of SQLite's error, followed by its message.
fn in_words(error: &rusqlite::Error) -> String {
    let words = match error.sqlite_error_code() {
        Some(ErrorCode::DiskFull) => return no_room(error),
        Some(ErrorCode::DatabaseBusy | ErrorCode::DatabaseLocked) => {
            "another program has locked it; "
        }
        Some(
            ErrorCode::DatabaseCorrupt | ErrorCode::NotADatabase | ErrorCode::OperationInterrupted,
        ) => "it is damaged; ",
        Some(ErrorCode::ReadOnly | ErrorCode::CannotOpen | ErrorCode::PermissionDenied) => {
            "it cannot be opened for writing; "
        }
        Some(ErrorCode::SystemIoFailure) => "the disk does not work properly; ",
        _ => "",
    };
    format!("{words}SQLite reports: {error}")
}
