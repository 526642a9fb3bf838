//! carrom in a browser: another shell for the same app.
//!
//! The page (`page/`) sends inputs and the time, and receives cells, pictures and requests.
//! Messages in both directions are JSON, followed by the bytes of files if there are any:
//!
//! ```text
//!   exports    the functions that the page calls by name, and the shared memory
//!   message    the page's commands and the replies
//!   shell      the app with its screen and its saved data
//!   opening    what a link opens: #quiz=mixed-7&player=Ana
//!   keeping    the store, whose files the browser saves
//!   own        a teacher's own levels, chapters and questions, and other opened files
//!   report     the report of a round to a learning platform
//! ```

#[expect(unsafe_code, reason = "exporting a function by name is unsafe")]
pub mod exports;
mod keeping;
mod message;
mod opening;
mod own;
mod report;
mod shell;

pub use message::{Command, Reply};
pub use shell::Shell;
