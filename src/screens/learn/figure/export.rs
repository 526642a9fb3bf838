//! A figure as a picture in a file.

use super::LiveFigure;
use crate::lessons::Figure;
use crate::widgets::{Look, svg};

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
    Ok(svg_of(&LiveFigure::new(figure, None, false), look))
}

/// A figure as it stands, as an SVG picture.
pub(in crate::screens::learn) fn svg_of(shown: &LiveFigure, look: &Look) -> String {
    svg::of_panel(&shown.title(), look, |area, cells| {
        shown.lay_out(area, cells, look, None)
    })
}
