//! The painter that draws a [`Picture`](super::picture::Picture) into cells, in both charsets.
//!
//! It uses **shape matching** instead of fixed line-drawing characters: every stroke marks samples
//! in a small grid in each cell (3 × 5 in ASCII; 2 × 4 in Unicode, where they are braille dots),
//! and each cell shows the glyph whose ink is nearest. Filled discs are matched in the same way,
//! with block elements in an 8 × 8 grid.

mod arrow;
mod canvas;
mod cell;
mod crowd;
mod disc;
pub(crate) mod gallery;
mod glyphs;
mod ground;
mod label;
mod plot;
mod shades;
mod stroke;
#[cfg(test)]
mod tests;

pub(super) use canvas::Canvas;
pub(crate) use disc::token;
pub(super) use label::PlacedLabel;
#[cfg(test)]
pub(crate) use tests::centres;

use super::Charset;

/// The number of samples in a cell of a charset: columns, rows.
const fn grid(charset: Charset) -> (usize, usize) {
    match charset {
        Charset::Ascii => glyphs::ascii::GRID,
        Charset::Unicode => (2, 4),
    }
}
