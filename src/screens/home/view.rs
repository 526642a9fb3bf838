//! How the first screen looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{CHOICES, Home};
use crate::screens::Context;
use crate::widgets::Role;

/// Which line of the menu stands at this cell.
pub(super) fn choice_at(area: Rect, _column: u16, row: u16) -> Option<usize> {
    let i = usize::from(row.checked_sub(area.y + 2)?);
    (i < CHOICES.len()).then_some(i)
}

/// Draws the menu.
pub(super) fn draw(home: &Home, area: Rect, buf: &mut Buffer, cx: &Context) {
    let theme = cx.settings.theme();
    for (i, choice) in CHOICES.iter().enumerate() {
        let role = if i == home.chosen {
            Role::Selected
        } else {
            Role::Text
        };
        let line = format!(" {}  {:8}{}", choice.key, choice.name, choice.about);
        buf.set_stringn(
            area.x + 2,
            area.y + 2 + i as u16,
            line,
            area.width.saturating_sub(4).into(),
            theme.style(role),
        );
    }
}
