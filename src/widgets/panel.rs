//! A bordered panel with a title.

use super::{Charset, Role, Theme};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Draws a border round `area` with a title.
pub fn panel(area: Rect, buf: &mut Buffer, title: &str, _: Charset, theme: &Theme) {
    buf.set_stringn(
        area.x,
        area.y,
        format!("+- {title} -"),
        area.width.into(),
        theme.style(Role::Border),
    );
}
