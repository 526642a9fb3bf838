//! What the app asks of the shell that drives it.

use super::{Request, Task};

/// A thing only the world outside can do.
#[derive(Debug, Clone, PartialEq)]
pub enum Effect {
    /// Leave the program.
    Quit,
    /// Think, and hand the [`Thought`](super::Thought) back as an input.
    Think(Box<Task>),
    /// Do something with what is kept, and hand the
    /// [`Answer`](super::Answer) back as an input.
    Keep(Request),
    /// Write a text to a file of this name where the player will find it, and hand
    /// back as an [`Input::Exported`](super::Input::Exported) where it is.
    Export {
        /// The name: letters, digits, hyphens and an ending.
        name: String,
        /// The text.
        content: String,
    },
}
