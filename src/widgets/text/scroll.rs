//! Text that may be longer than its area.

use ratatui::{buffer::Buffer, layout::Rect};

use crate::widgets::{Look, Role, text};

/// The number of rows by which the page keys scroll.
pub(crate) const PAGE_ROWS: i16 = 8;

/// Writes a hint into the frame below `area`.
pub(crate) fn hint_below(area: Rect, buf: &mut Buffer, look: Look, hint: &str) {
    let width = text::width(hint) as u16;
    let column = area.right().saturating_sub(width + 1).max(area.x);
    if buf.area.contains((column, area.bottom()).into()) {
        let room = area.right().saturating_sub(column).into();
        let style = look.theme.style(Role::Key);
        buf.set_stringn(column, area.bottom(), hint, room, style);
    }
}
