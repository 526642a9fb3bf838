//! A figure as a picture in a file.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::Shown;
use crate::lessons::Figure;
use crate::widgets::panel::draw_panel;
use crate::widgets::{Look, svg};

/// Columns and rows of a picture.
const SIZE: (u16, u16) = (84, 32);

/// Why a figure cannot be drawn.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct FigureError(String);

/// The figure that these words describe, as an SVG picture: `curves alpha_deg=30`.
///
/// # Errors
/// What was expected of the words.
pub fn draw_figure(words: &str, look: &Look) -> Result<String, FigureError> {
    let figure = Figure::from_words(words).map_err(FigureError)?;
    Ok(svg_of(&Shown::new(figure, None, false), look))
}

/// A figure as it stands, as an SVG picture.
pub(in crate::screens::learn) fn svg_of(shown: &Shown, look: &Look) -> String {
    let area = Rect::new(0, 0, SIZE.0, SIZE.1);
    let mut buf = Buffer::empty(area);
    buf.set_style(area, look.theme.base());
    let inside = draw_panel(&mut buf, area, &shown.title(), look.charset, &look.theme);
    shown.write(inside, &mut buf, look);
    svg::of_screen_with(&buf, &shown.pictures(inside, look, None), look)
}
