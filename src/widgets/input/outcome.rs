//! The result of a key or a mouse event.

/// How the widget that received an input handled it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome<T = ()> {
    /// The input was not used, so another widget may use it.
    Ignored,
    /// The input was used, and there is no result yet.
    Used,
    /// The input was used, with this result.
    Done(T),
}

impl<T> Outcome<T> {
    pub(crate) fn is_used(&self) -> bool {
        !matches!(self, Self::Ignored)
    }
}
