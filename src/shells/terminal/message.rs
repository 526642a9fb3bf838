//! What the thread that draws is told by the others.

use std::io;

use crate::messages::Input;

/// One thing that happened.
#[derive(Debug)]
pub(super) enum Message {
    /// Something for the app.
    Input(Input),
    /// The terminal can no longer be read.
    Lost(io::Error),
    /// A signal of this number asks carrom to end.
    #[cfg(unix)]
    Leave(i32),
    /// The player wants the shell back for a while.
    #[cfg(unix)]
    Stop,
    /// carrom was stopped and runs again.
    #[cfg(unix)]
    Continue,
}
