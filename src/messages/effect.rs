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
}
