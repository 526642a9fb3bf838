//! Framed panels with a title.

use ratatui::{
    buffer::Buffer,
    layout::Rect,
    symbols::border,
    text::Span,
    widgets::{Block, Widget},
};

use crate::widgets::{Charset, Look, Role, sheet};

/// A frame made of characters that every terminal has.
const ASCII: border::Set<'static> = border::Set {
    top_left: "+",
    top_right: "+",
    bottom_left: "+",
    bottom_right: "+",
    vertical_left: "|",
    vertical_right: "|",
    horizontal_top: "-",
    horizontal_bottom: "-",
};

/// Draws an empty frame with a title, like `+- title --+` in ASCII and with rounded corners in
/// Unicode, and returns the area inside. If the title is empty, the top line has no gap.
pub(crate) fn draw_panel(buffer: &mut Buffer, area: Rect, title: &str, look: &Look) -> Rect {
    let title = look.charset.text(title);
    sheet::frame(area, &title);
    let lines = match look.charset {
        Charset::Ascii => ASCII,
        Charset::Unicode => border::ROUNDED,
    };
    let style = look.theme.style(Role::Border);
    let mut block = Block::bordered().border_set(lines).border_style(style);
    if !title.is_empty() {
        let stub = Span::styled(lines.horizontal_top, style);
        let title = Span::styled(format!(" {title} "), look.theme.style(Role::Title));
        block = block.title(vec![stub, title]);
    }
    let inside = block.inner(area);
    block.render(area.intersection(buffer.area), buffer);
    inside
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(title: &str, charset: Charset) -> Vec<String> {
        let area = Rect::new(0, 0, 16, 3);
        let mut buffer = Buffer::empty(area);
        let look = Look {
            charset,
            ..Look::default()
        };
        let inside = draw_panel(&mut buffer, area, title, &look);
        assert_eq!(inside, Rect::new(1, 1, 14, 1));
        (0..3)
            .map(|y| (0..16).map(|x| buffer[(x, y)].symbol()).collect())
            .collect()
    }

    #[test]
    fn frames_are_drawn_in_both_charsets() {
        assert_eq!(
            drawn("the hit", Charset::Ascii),
            ["+- the hit ----+", "|              |", "+--------------+"]
        );
        assert_eq!(
            drawn("θ₁", Charset::Unicode),
            ["╭─ θ₁ ─────────╮", "│              │", "╰──────────────╯"]
        );
    }

    #[test]
    fn a_panel_of_any_size_is_drawn_without_a_panic() {
        for width in 0..5 {
            for height in 0..4 {
                let area = Rect::new(0, 0, width, height);
                let mut buffer = Buffer::empty(area);
                draw_panel(&mut buffer, area, "title", &Look::default());
            }
        }
    }
}
