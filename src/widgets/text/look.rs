//! The player's choice of glyphs and colours.

use crate::widgets::{Blocks, Charset, Theme};

/// The charset, the block elements and the theme, which every widget needs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Look {
    /// The glyphs.
    pub charset: Charset,
    /// The finest block elements among these glyphs.
    pub blocks: Blocks,
    /// The colours.
    pub theme: Theme,
}
