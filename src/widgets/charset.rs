//! The glyphs to draw with.

/// The glyphs to draw with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Charset {
    /// Printable ASCII alone.
    Ascii,
    /// Blocks, braille and box lines too.
    Unicode,
}

impl Charset {
    /// `text` in this charset.
    pub fn text(self, text: &str) -> String {
        text.to_string()
    }
}
