//! carrom in a browser: one more shell over the same app.
//!
//! The page (`page/`) hands inputs and the time in and takes cells, pictures and wishes out.
//! Both sides speak in JSON, with bytes of files behind it where there are any:
//!
//! ```text
//!   exports    what the page calls by name, and the memory that both use
//!   message    what the page says, and what it is told
//!   shell      the app with its screen and what is kept
//!   opening    what a link opens: #quiz=mixed-7&player=Ana
//!   keeping    the store, whose files the browser keeps
//!   own        a teacher's own levels, chapters and questions, and other files
//! ```

#[expect(unsafe_code, reason = "a name that a page can call counts as unsafe")]
pub mod exports;
mod keeping;
mod message;
mod opening;
mod own;
mod shell;

pub use message::{Command, Reply};
pub use shell::Shell;
