//! Text that may be longer than its place.

use ratatui::{buffer::Buffer, layout::Rect};

use crate::messages::Key;
use crate::widgets::{Lines, Look, Role, text};

/// How far a text has been scrolled.
///
/// What is written is asked for as a function on [`Lines`], so that its length
/// follows from the very rows that are drawn.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Scroll {
    rows: u16,
}

impl Scroll {
    /// Rows that the keys for a page go.
    pub const PAGE: i16 = 8;

    /// The same scrolled down by `rows` (up if negative), no further than to the last row
    /// of what `write` writes into `area`.
    #[must_use]
    pub fn by(self, rows: i16, area: Rect, look: Look, write: impl FnOnce(&mut Lines)) -> Self {
        let most = overflow(area, look, write);
        let rows = self.rows.min(most).saturating_add_signed(rows).min(most);
        Self { rows }
    }

    /// Draws what `write` writes. Where it does not fit, the frame below `area` says
    /// which key brings the rest.
    pub fn draw(self, area: Rect, buf: &mut Buffer, look: Look, write: impl Fn(&mut Lines)) {
        let most = overflow(area, look, &write);
        let rows = self.rows.min(most);
        write(&mut Lines::new(area, buf, look).scrolled(rows));
        if most > 0 {
            let hint = if rows < most {
                " PageDown: more "
            } else {
                " PageUp: back "
            };
            hint_below(area, buf, look, hint);
        }
    }
}

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

/// The keys that turn the pages of a text, with what a screen calls scrolling by so many
/// rows.
pub(crate) fn scroll_keys<A>(action: impl Fn(i16) -> A) -> [(Key, A); 2] {
    [
        (Key::PageUp, action(-Scroll::PAGE)),
        (Key::PageDown, action(Scroll::PAGE)),
    ]
}

/// Rows of what `write` writes that `area` has no room for.
pub(crate) fn overflow(area: Rect, look: Look, write: impl FnOnce(&mut Lines)) -> u16 {
    let written = rehearsed(area, look, |lines| {
        write(lines);
        lines.written()
    });
    written.saturating_sub(area.height)
}

/// What `write` gives when it writes where nobody sees it.
pub(crate) fn rehearsed<T>(area: Rect, look: Look, write: impl FnOnce(&mut Lines) -> T) -> T {
    let mut scratch = Buffer::empty(area);
    write(&mut Lines::unseen(area, &mut scratch, look))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::widgets::{Charset, Theme};

    const LOOK: Look = Look {
        charset: Charset::Ascii,
        theme: Theme::new(crate::widgets::Palette::Dark, crate::widgets::Depth::None),
    };
    const AREA: Rect = Rect::new(1, 1, 20, 4);

    fn write(lines: &mut Lines) {
        for row in 1..=6 {
            lines.line(&format!("row {row}"), Role::Text);
        }
    }

    fn drawn(scroll: Scroll) -> String {
        let mut buf = Buffer::empty(Rect::new(0, 0, 22, 6));
        scroll.draw(AREA, &mut buf, LOOK, write);
        buf.content
            .iter()
            .map(ratatui::buffer::Cell::symbol)
            .collect()
    }

    #[test]
    fn every_row_can_be_reached_and_none_beyond() {
        let mut scroll = Scroll::default();
        let top = drawn(scroll);
        assert!(top.contains("row 1") && top.contains("row 4") && !top.contains("row 5"));
        assert!(top.contains("PageDown: more"));
        scroll = scroll.by(100, AREA, LOOK, write);
        let bottom = drawn(scroll);
        assert!(bottom.contains("row 3") && bottom.contains("row 6") && !bottom.contains("row 2"));
        assert!(bottom.contains("PageUp: back"));
        scroll = scroll.by(-1, AREA, LOOK, write);
        assert!(drawn(scroll).contains("row 2"));
        scroll = scroll.by(-100, AREA, LOOK, write);
        assert_eq!(drawn(scroll), top);
    }

    #[test]
    fn a_text_that_fits_is_not_scrolled() {
        let one = |lines: &mut Lines| lines.line("row 1", Role::Text);
        let scroll = Scroll::default();
        assert_eq!(scroll.by(3, AREA, LOOK, one), Scroll::default());
    }
}
