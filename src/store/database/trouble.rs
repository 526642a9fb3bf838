//! What may be wrong with a database.

use std::io;

use rusqlite::ErrorCode;
use thiserror::Error;

use super::schema::VERSION;

/// What is wrong.
#[derive(Debug, Error)]
pub(super) enum Trouble {
    /// It is not what it should be.
    #[error("{0}")]
    Damaged(String),
    /// A newer carrom has written it.
    #[error(
        "it was written by a newer carrom (format {0}, and this one knows formats up to \
         {VERSION}), so it is left as it is"
    )]
    Newer(i64),
    /// SQLite failed.
    #[error("{0}")]
    Sqlite(#[from] rusqlite::Error),
    /// The folder cannot be used.
    #[error("{0}")]
    Folder(#[from] io::Error),
}

impl Trouble {
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

    fn code(&self) -> Option<ErrorCode> {
        match self {
            Self::Sqlite(error) => error.sqlite_error_code(),
            _ => None,
        }
    }
}
