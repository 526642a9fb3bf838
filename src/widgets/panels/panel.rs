//! Framed panels with a title.

use ratatui::{
    buffer::Buffer,
    layout::Rect,
    symbols::border,
    text::Span,
    widgets::{Block, Widget},
};

use crate::widgets::{Charset, Role, Theme, sheet};

/// A frame that any terminal can draw.
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

/// A framed block with a title, for use with any widget of ratatui: `+- title --+`
/// in ASCII, rounded lines in Unicode. An empty title leaves the frame whole.
#[must_use]
pub(crate) fn panel(title: &str, charset: Charset, theme: &Theme) -> Block<'static> {
    let lines = match charset {
        Charset::Ascii => ASCII,
        Charset::Unicode => border::ROUNDED,
    };
    let block = Block::bordered()
        .border_set(lines)
        .border_style(theme.style(Role::Border));
    if title.is_empty() {
        return block;
    }
    let stub = Span::styled(lines.horizontal_top, theme.style(Role::Border));
    let title = format!(" {} ", charset.text(title));
    block.title(vec![stub, Span::styled(title, theme.style(Role::Title))])
}

/// Draws an empty [`panel`] and says what room is inside it.
pub(crate) fn draw_panel(
    buffer: &mut Buffer,
    area: Rect,
    title: &str,
    charset: Charset,
    theme: &Theme,
) -> Rect {
    sheet::frame(area, &charset.text(title));
    let block = panel(title, charset, theme);
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
        let inside = draw_panel(&mut buffer, area, title, charset, &Theme::default());
        assert_eq!(inside, Rect::new(1, 1, 14, 1));
        (0..3)
            .map(|y| (0..16).map(|x| buffer[(x, y)].symbol()).collect())
            .collect()
    }

    #[test]
    fn frames_in_both_charsets() {
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
    fn no_size_is_too_small() {
        for width in 0..5 {
            for height in 0..4 {
                let area = Rect::new(0, 0, width, height);
                let mut buffer = Buffer::empty(area);
                draw_panel(
                    &mut buffer,
                    area,
                    "title",
                    Charset::Ascii,
                    &Theme::default(),
                );
            }
        }
    }
}
