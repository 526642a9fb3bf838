//! The result of a key or a mouse event.

/// The result of an input for the part that received it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome<T = ()> {
    /// It was not used, and other parts may use it.
    Ignored,
    /// It was used, and more of the same may follow.
    Used,
    /// It was used, with this result.
    Done(T),
}

impl<T> Outcome<T> {
    /// Whether it was used.
    pub(crate) fn is_used(&self) -> bool {
        !matches!(self, Self::Ignored)
    }
}
