//! Ink: the painter that draws a [`Picture`](super::picture::Picture) into cells, in
//! both charsets.
//!
//! Not one glyph a line-drawing rule, but **shape matching**: every stroke goes
//! into a small grid of samples in each cell (3 × 5 in ASCII, 2 × 4 in Unicode,
//! where they are braille dots), and each cell takes the glyph whose own ink is
//! nearest. Filled discs do the same with an 8 × 8 grid and block elements.

mod arrow;
mod canvas;
mod cell;
mod crowd;
mod disc;
pub(crate) mod gallery;
mod glyphs;
mod label;
mod plot;
mod shades;
mod stroke;
#[cfg(test)]
mod tests;

pub(super) use canvas::Canvas;
pub(crate) use disc::token;
pub(super) use label::PlacedLabel;

use super::Charset;

/// Samples in a cell of a charset: columns, rows.
const fn grid(charset: Charset) -> (usize, usize) {
    match charset {
        Charset::Ascii => glyphs::ascii::GRID,
        Charset::Unicode => (2, 4),
    }
}
