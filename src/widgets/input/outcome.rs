//! What became of a key or of the mouse.

/// What an input meant to the part that it was offered to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome<T = ()> {
    /// Nothing: somebody else may use it.
    Ignored,
    /// It was used, and more of the same may follow.
    Used,
    /// It was used, and this came of it.
    Done(T),
}

impl<T> Outcome<T> {
    /// Whether it meant anything.
    pub(crate) fn is_used(&self) -> bool {
        !matches!(self, Self::Ignored)
    }
}
