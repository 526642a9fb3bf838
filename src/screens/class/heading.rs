//! What a step is called, large enough for the back row.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::widgets::big::{Align, Big};
use crate::widgets::{Item, Lines, Look, Role, Words, areas, sheet, text};

/// A text that may be longer than its place: the place, and what writes it.
pub(super) type Text<'a> = (Rect, Box<dyn Fn(&mut Lines) + 'a>);

/// Columns of what is read line by line.
pub(super) const WIDEST: u16 = 100;
/// Rows of a screen's body from which on it has a heading in large type.
const LARGE_FROM: u16 = 21;
/// Rows of a body from which on the heading may be larger still.
const LARGER_FROM: u16 = 56;
/// Rows of a body from which on there is an empty row around the heading.
const AIRY_FROM: u16 = 30;

/// A heading with the line below it that says what to do.
#[derive(Debug, Clone)]
pub(super) struct Heading {
    /// What it may say, the best first; the first that fits is taken.
    texts: Vec<String>,
    line: String,
    /// Whether both are one line of plain type.
    small: bool,
}

impl Heading {
    /// A heading.
    pub(super) fn new(texts: &[&str], line: impl Into<String>) -> Self {
        Self {
            texts: texts.iter().map(ToString::to_string).collect(),
            line: line.into(),
            small: false,
        }
    }

    /// Whether it says nothing to do.
    pub(super) const fn is_bare(&self) -> bool {
        self.line.is_empty()
    }

    /// The same in one line of plain type, where large type would take room from the question.
    pub(super) fn small(self) -> Self {
        Self {
            small: true,
            ..self
        }
    }

    /// The heading in large type, if there is room for it.
    fn big(&self, area: Rect, look: &Look) -> Option<Big> {
        let most = match area.height {
            _ if self.small => return None,
            ..LARGE_FROM => return None,
            LARGE_FROM..LARGER_FROM => 4,
            _ => 8,
        };
        let width = area.width.saturating_sub(2);
        let mut texts = self.texts.iter();
        texts.find_map(|text| Big::fit(text, width, most, look.charset))
    }

    /// What is left of an area below it.
    pub(super) fn rest(&self, area: Rect, look: &Look) -> Rect {
        if self.small {
            return below(area, 1);
        }
        let air = u16::from(area.height >= AIRY_FROM);
        let heading = self.big(area, look).map_or(1, |big| big.rows() + air);
        let line = u16::from(!self.line.is_empty()) + air;
        below(area, heading + line)
    }

    /// Draws it in large letters where there is room, with the line below it.
    pub(super) fn draw(&self, area: Rect, buf: &mut Buffer, look: &Look) {
        let title = self.texts.first().map_or("", String::as_str);
        for (words, role) in [(title, Role::Title), (self.line.as_str(), Role::Key)]
            .into_iter()
            .filter(|(words, _)| !words.is_empty())
        {
            sheet::note(area, || {
                Item::new(Words::large(&look.charset.text(words), role))
            });
        }
        if self.small {
            let both = match self.line.as_str() {
                "" => title.to_owned(),
                line => format!("{title}. {line}"),
            };
            // What to do is more than what the step is called.
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

/// The middle of an area, no wider than a line that reads well.
pub(super) fn column(area: Rect) -> Rect {
    areas::middle(area, WIDEST)
}

/// One of the places of so many rows into which an area is cut, from 0 at its top.
pub(super) fn slot(area: Rect, number: usize, rows: u16) -> Rect {
    let place = below(area, rows.saturating_mul(number as u16));
    Rect {
        height: rows.min(place.height),
        ..place
    }
}

/// What is left of an area below so many rows.
pub(super) fn below(area: Rect, rows: u16) -> Rect {
    areas::upper(area, rows)[1]
}

/// Writes a line in the middle of the first row of an area, if it has one.
pub(super) fn centred(words: &str, area: Rect, buf: &mut Buffer, look: &Look, role: Role) {
    if area.height == 0 {
        return;
    }
    let words = look.charset.text(words);
    let words = text::clipped(&words, area.width.into());
    let column = area.x + (area.width - text::width(&words) as u16) / 2;
    let room = usize::from(area.right() - column);
    buf.set_stringn(column, area.y, words, room, look.theme.style(role));
}
