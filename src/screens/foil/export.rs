//! The plot of a page as a picture in a file.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Foil, view};
use crate::widgets::panel::draw_panel;
use crate::widgets::{Look, svg};

/// Columns and rows of a picture.
const SIZE: (u16, u16) = (84, 32);

/// The plot as it stands, as an SVG picture.
pub(super) fn svg_of(foil: &Foil, look: Look) -> String {
    let area = Rect::new(0, 0, SIZE.0, SIZE.1);
    let mut buf = Buffer::empty(area);
    buf.set_style(area, look.theme.base());
    let title = view::title(foil);
    let inside = draw_panel(&mut buf, area, title, look.charset, &look.theme);
    let picture = view::picture(foil, inside, look);
    svg::of_screen_with(&buf, &[picture], &look)
}
