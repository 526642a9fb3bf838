//! What the app asks of the shell that drives it.

/// A thing only the world outside can do.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Effect {
    /// Leave the program.
    Quit,
}
