//! A level that was won.

/// A level that was won, with the most stars it was ever won with.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Starred {
    /// The name of its pack.
    pub pack: String,
    /// Its id.
    pub level: String,
    /// How many, from 1.
    pub stars: u8,
}
