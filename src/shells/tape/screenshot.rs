//! A screen that a tape has kept.

use ratatui::buffer::Buffer;

use crate::widgets::{Sheet, cells, svg};

/// A screen, kept under a name.
#[derive(Debug, Clone, PartialEq)]
pub struct Screenshot {
    /// Its name: letters, digits, `-` and `_`.
    pub name: String,
    /// What every cell showed.
    pub cells: Buffer,
    /// What the screen said in words.
    pub sheets: Vec<Sheet>,
}

impl Screenshot {
    /// The rows without the blanks at their ends, a line break after each.
    pub fn text(&self) -> String {
        cells::text(&self.cells)
    }

    /// The screen as a picture that needs nothing else to be shown.
    pub fn svg(&self) -> String {
        svg::of_screen(&self.cells)
    }
}
