//! Ink: the painter every picture is drawn with, in both charsets.
//!
//! A [`View`] says where the world is on the screen, a [`Sheet`] takes strokes in
//! world coordinates, each with a [`Pen`], and is drawn into a buffer at the end.
//!
//! Not one glyph a line-drawing rule, but **shape matching**: every stroke goes
//! into a small grid of samples in each cell (3 × 5 in ASCII, 2 × 4 in Unicode,
//! where they are braille dots), and each cell takes the glyph whose own ink is
//! nearest. Filled discs do the same with an 8 × 8 grid and block elements.
//!
//! ```
//! use carrom::widgets::{Charset, Role, Theme};
//! use carrom::widgets::ink::{Pen, Sheet, Side, View};
//! use glam::dvec2;
//! use ratatui::{buffer::Buffer, layout::Rect};
//!
//! let mut buffer = Buffer::empty(Rect::new(0, 0, 40, 12));
//! let view = View::fit(buffer.area, dvec2(-0.04, -0.02), dvec2(0.04, 0.02));
//! let mut sheet = Sheet::new(view, Charset::Unicode);
//! sheet.disc(dvec2(0.0, 0.0), 0.015, Role::Striker, 'S');
//! sheet.line(dvec2(-0.04, 0.01), dvec2(0.04, 0.01), Pen::new(Role::LineOfImpact).dashed());
//! let (tail, tip) = (dvec2(0.0, 0.0), dvec2(0.02, 0.018));
//! sheet.arrow(tail, tip, Role::StrikerOut);
//! assert!(sheet.label("v₁ = 2.00 m/s", tip, &Side::towards(tip - tail), Role::StrikerOut));
//! sheet.draw(&mut buffer, &Theme::default());
//! ```

mod arrow;
mod cell;
mod crowd;
mod disc;
mod glyphs;
mod label;
mod pen;
mod sheet;
mod stroke;
#[cfg(test)]
mod tests;
mod view;

pub use crowd::Body;
pub use disc::token;
pub use label::Side;
pub use pen::{Dash, Layer, Pen};
pub use sheet::Sheet;
pub use view::View;

use super::Charset;

/// Samples in a cell of a charset: columns, rows.
const fn grid(charset: Charset) -> (usize, usize) {
    match charset {
        Charset::Ascii => glyphs::ascii::GRID,
        Charset::Unicode => (2, 4),
    }
}
