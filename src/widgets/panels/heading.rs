//! The heading of a screen for a whole class, large enough for the back row.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::widgets::big::{Align, Big};
use crate::widgets::{Item, Look, Role, Words, areas, sheet, text};

/// The minimum number of rows in the body of a screen with a heading in large type.
const LARGE_FROM: u16 = 21;
/// The minimum number of rows in the body of a screen with an even larger heading.
const LARGER_FROM: u16 = 56;
/// The minimum number of rows in the body of a screen with empty rows around the heading.
const AIRY_FROM: u16 = 30;

/// A heading with a line of instructions below it.
#[derive(Debug, Clone)]
pub(crate) struct Heading {
    /// The possible wordings, best first; the first one that fits is used.
    texts: Vec<String>,
    line: String,
}

impl Heading {
    /// Creates a heading with these possible wordings and this line below.
    pub(crate) fn new(texts: &[&str], line: impl Into<String>) -> Self {
        Self {
            texts: texts.iter().map(ToString::to_string).collect(),
            line: line.into(),
        }
    }

    /// The heading in large type, if it fits.
    fn big(&self, area: Rect, look: &Look) -> Option<Big> {
        let most = match area.height {
            ..LARGE_FROM => return None,
            LARGE_FROM..LARGER_FROM => 4,
            _ => 8,
        };
        let width = area.width.saturating_sub(2);
        let mut texts = self.texts.iter();
        texts.find_map(|text| Big::fit(text, width, most, look.charset))
    }

    /// The area left below the heading. A `small` heading takes one line of plain type, or none if
    /// there is no instruction.
    pub(crate) fn rest(&self, area: Rect, look: &Look, small: bool) -> Rect {
        if small {
            return below(area, (!self.line.is_empty()).into());
        }
        let air = u16::from(area.height >= AIRY_FROM);
        let heading = self.big(area, look).map_or(1, |big| big.rows() + air);
        let line = u16::from(!self.line.is_empty()) + air;
        below(area, heading + line)
    }

    /// Draws the heading, in large letters if there is room and it is not `small`.
    pub(crate) fn draw(&self, area: Rect, buf: &mut Buffer, look: &Look, small: bool) {
        if small && self.line.is_empty() {
            return;
        }
        let title = self.texts.first().map_or("", String::as_str);
        for (words, role) in [(title, Role::Title), (self.line.as_str(), Role::Key)]
            .into_iter()
            .filter(|(words, _)| !words.is_empty())
        {
            sheet::note(area, || {
                Item::new(Words::large(&look.charset.text(words), role))
            });
        }
        if small {
            let both = match self.line.as_str() {
                "" => title.to_owned(),
                line => format!("{title}. {line}"),
            };
            // The instruction is more important than the title.
            let wide = text::width(&both) <= area.width.into();
            let words = if wide { &both } else { &self.line };
            return centred(words, area, buf, look, Role::Key);
        }
        let air = u16::from(area.height >= AIRY_FROM);
        let rows = match self.big(area, look) {
            Some(big) => {
                big.draw(area, buf, look, Role::Title, Align::Centre);
                big.rows() + air
            }
            None => {
                centred(title, area, buf, look, Role::Title);
                1
            }
        };
        centred(&self.line, below(area, rows), buf, look, Role::Key);
    }
}

/// The part of an area below its first rows.
fn below(area: Rect, rows: u16) -> Rect {
    areas::upper(area, rows)[1]
}

/// Writes a centred line into the first row of an area, if the area has any rows.
fn centred(words: &str, area: Rect, buf: &mut Buffer, look: &Look, role: Role) {
    if area.height == 0 {
        return;
    }
    let words = look.charset.text(words);
    let words = text::clipped(&words, area.width.into());
    let column = area.x + (area.width - text::width(&words) as u16) / 2;
    let room = usize::from(area.right() - column);
    buf.set_stringn(column, area.y, words, room, look.theme.style(role));
}
