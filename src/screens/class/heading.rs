//! What a step is called, large enough for the back row.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::widgets::big::{Align, Big};
use crate::widgets::{Look, Role, text};

/// Rows of a screen's body from which on it has a heading in large type.
const LARGE_FROM: u16 = 21;
/// Rows of a body from which on the heading may be larger still.
const LARGER_FROM: u16 = 56;
/// Rows of a body from which on there is an empty row around the heading.
const AIRY_FROM: u16 = 30;

/// A heading with the line below it that says what to do.
pub(super) struct Heading<'a> {
    /// What it may say, the best first; the first that fits is taken.
    texts: &'a [&'a str],
    /// The line below it.
    line: &'a str,
}

impl<'a> Heading<'a> {
    /// A heading.
    pub(super) const fn new(texts: &'a [&'a str], line: &'a str) -> Self {
        Self { texts, line }
    }

    /// The heading in large type, if there is room for it.
    fn big(&self, area: Rect, look: &Look) -> Option<Big> {
        let most = match area.height {
            ..LARGE_FROM => return None,
            LARGE_FROM..LARGER_FROM => 4,
            _ => 8,
        };
        let fit = |text: &&str| Big::fit(text, area.width.saturating_sub(2), most, look.charset);
        self.texts.iter().find_map(fit)
    }

    /// What is left of an area below it.
    pub(super) fn rest(&self, area: Rect, look: &Look) -> Rect {
        let air = u16::from(area.height >= AIRY_FROM);
        let heading = self.big(area, look).map_or(1, |big| big.rows() + air);
        let line = u16::from(!self.line.is_empty()) + air;
        let rows = (heading + line).min(area.height);
        Rect {
            y: area.y + rows,
            height: area.height - rows,
            ..area
        }
    }

    /// Draws it and gives what is left below it.
    pub(super) fn draw(&self, area: Rect, buf: &mut Buffer, look: &Look) -> Rect {
        let rest = self.rest(area, look);
        let air = u16::from(area.height >= AIRY_FROM);
        let mut row = area.y;
        match self.big(area, look) {
            Some(big) => {
                big.draw(area, buf, look, Role::Title, Align::Centre);
                row += big.rows() + air;
            }
            None => {
                centred(
                    self.texts.first().unwrap_or(&""),
                    row,
                    area,
                    buf,
                    look,
                    Role::Title,
                );
                row += 1;
            }
        }
        centred(self.line, row, area, buf, look, Role::Key);
        rest
    }
}

/// Writes a line in the middle of a row, if the area has that row.
pub(super) fn centred(
    words: &str,
    row: u16,
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
    role: Role,
) {
    if row >= area.bottom() {
        return;
    }
    let words = look.charset.text(words);
    let words = text::clipped(&words, area.width.into());
    let column = area.x + (area.width - text::width(&words) as u16) / 2;
    let room = usize::from(area.right() - column);
    buf.set_stringn(column, row, words, room, look.theme.style(role));
}
