//! What the app asks of the shell that drives it.

use super::{SearchTask, StoreCall};

/// A thing only the world outside can do.
#[derive(Debug, Clone, PartialEq)]
pub enum Effect {
    /// Leave the program.
    Quit,
    /// Search, and hand the [`SearchResult`](super::SearchResult) back as an input.
    Search(Box<SearchTask>),
    /// Do something with what is kept, and hand the
    /// [`StoreAnswer`](super::StoreAnswer) back as an input.
    Keep(StoreCall),
    /// Write a text to a file of this name where the player is, in a terminal the folder
    /// it was started in, and hand back as an [`Input::Exported`](super::Input::Exported)
    /// where it is. (What a [`StoreRequest`](super::StoreRequest) exports goes to the folder for data
    /// instead, with whatever else is kept.)
    Export {
        /// The name: letters, digits, hyphens and an ending.
        name: String,
        /// The text.
        content: String,
    },
}
