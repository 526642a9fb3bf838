//! How things are drawn for this player: glyphs and colours.

use crate::widgets::{Charset, Theme};

/// Charset and theme together, as every widget needs them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Look {
    /// The glyphs.
    pub charset: Charset,
    /// The colours.
    pub theme: Theme,
}
