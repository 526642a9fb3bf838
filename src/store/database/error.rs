//! What may be wrong with a database.

use std::io::{self, ErrorKind};

use rusqlite::ErrorCode;
use thiserror::Error;

use super::schema::VERSION;

/// What is wrong.
#[derive(Debug, Error)]
pub(super) enum DatabaseError {
    /// It is not what it should be.
    #[error("{0}")]
    Damaged(String),
    /// A newer carrom has written it.
    #[error(
        "it was written by a newer carrom (format {0}, and this one knows formats up to \
         {VERSION}), so it is left as it is"
    )]
    Newer(i64),
    /// A part of it is in its log, and nothing can be written.
    #[error(
        "what was kept last is in {0}, which cannot be read where nothing can be written; \
         copy the folder to where something can"
    )]
    InLog(String),
    /// SQLite failed.
    #[error("{0}")]
    Sqlite(#[from] rusqlite::Error),
    /// The folder cannot be used.
    #[error("{0}")]
    Folder(#[from] io::Error),
}

impl DatabaseError {
    /// Whether it may go well a little later.
    pub(super) fn is_busy(&self) -> bool {
        let busy = [ErrorCode::DatabaseBusy, ErrorCode::DatabaseLocked];
        self.code().is_some_and(|code| busy.contains(&code))
    }

    /// Whether the file is no sound database of ours.
    pub(super) fn is_damage(&self) -> bool {
        let damage = [ErrorCode::DatabaseCorrupt, ErrorCode::NotADatabase];
        matches!(self, Self::Damaged(_)) || self.code().is_some_and(|code| damage.contains(&code))
    }

    /// Whether nothing may be written where it is.
    pub(super) fn is_forbidden(&self) -> bool {
        let forbidden = [ErrorCode::ReadOnly, ErrorCode::CannotOpen];
        match self {
            Self::Folder(error) => matches!(
                error.kind(),
                ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem
            ),
            _ => self.code().is_some_and(|code| forbidden.contains(&code)),
        }
    }

    fn code(&self) -> Option<ErrorCode> {
        match self {
            Self::Sqlite(error) => error.sqlite_error_code(),
            _ => None,
        }
    }
}
