//! The errors of commands and their exit status.

use std::fmt::{Debug, Display};

use anyhow::Error;

/// The reason why a command failed; it determines the exit status.
#[derive(Debug)]
pub enum Failure {
    /// The work failed: exit status 1.
    Work(Error),
    /// The arguments or the input cannot be used: exit status 2.
    Input(Error),
}

impl Failure {
    /// The arguments or the input cannot be used, for this reason.
    pub(super) fn input(reason: impl Display + Debug + Send + Sync + 'static) -> Self {
        Self::Input(Error::msg(reason))
    }

    /// The exit status.
    pub fn status(&self) -> u8 {
        match self {
            Self::Work(_) => 1,
            Self::Input(_) => 2,
        }
    }

    /// The error to print.
    pub fn error(&self) -> &Error {
        match self {
            Self::Work(error) | Self::Input(error) => error,
        }
    }
}

/// Any other error means that the work failed.
impl<E: Into<Error>> From<E> for Failure {
    fn from(error: E) -> Self {
        Self::Work(error.into())
    }
}
