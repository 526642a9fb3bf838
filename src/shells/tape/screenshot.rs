//! The screenshots of a tape.

use ratatui::buffer::Buffer;

use crate::widgets::{Sheet, cells, svg};

/// A screen, saved under a name.
#[derive(Debug, Clone, PartialEq)]
pub struct Screenshot {
    /// Its name, which consists of letters, digits, `-` and `_`.
    pub name: String,
    /// The contents of every cell.
    pub cells: Buffer,
    /// The text of the screen, as blocks.
    pub sheets: Vec<Sheet>,
}

impl Screenshot {
    /// The rows without trailing spaces, each followed by a line break.
    pub fn text(&self) -> String {
        cells::text(&self.cells)
    }

    /// The screen as a self-contained SVG picture.
    pub fn svg(&self) -> String {
        svg::of_screen(&self.cells)
    }
}
