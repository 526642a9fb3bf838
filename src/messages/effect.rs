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
    /// Write a text to a file of this name where the player is, in a terminal the folder
    /// it was started in, and hand back as an [`Input::Exported`](super::Input::Exported)
    /// where it is. (What a [`Wish`](super::Wish) exports goes to the folder for data
    /// instead, with whatever else is kept.)
    Export {
        /// The name: letters, digits, hyphens and an ending.
        name: String,
        /// The text.
        content: String,
    },
}
