//! The player's choice of glyphs and colours.

use crate::widgets::{Charset, Theme};

/// The charset and the theme, which every widget needs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Look {
    /// The glyphs.
    pub charset: Charset,
    /// The colours.
    pub theme: Theme,
}
