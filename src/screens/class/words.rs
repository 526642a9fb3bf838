//! The words of a step in the largest letters that fit beside its picture.
//!
//! The back row has to read them, so words come first: a picture shrinks before letters do, and
//! letters no smaller than can be read go on over several pages.

use ratatui::buffer::Buffer;
use ratatui::layout::{Margin, Rect};

use crate::widgets::bar::bar;
use crate::widgets::big::{BigPages, BigText, LetterSize};
use crate::widgets::flow::Run;
use crate::widgets::{Charset, Item, Look, Role, Room, Words, areas, sheet};

/// Rows between two paragraphs, and where that saves a page.
const GAPS: [u16; 2] = [1, 0];
/// Columns between a picture and the words beside it, and on their right.
const APART: u16 = 1;
/// Fewest columns of words beside a picture.
const LEAST: u16 = 24;
/// Rows of the screen that are no part of its body.
const CHROME: u16 = 2;

/// Something said, in large letters.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Paragraph {
    pub(super) text: String,
    pub(super) role: Role,
    /// Whether it is to stand whole on a page.
    pub(super) whole: bool,
    /// A bar below it, for such a share of all.
    pub(super) share: Option<f64>,
}

impl Paragraph {
    /// Words alone.
    pub(super) fn new(text: impl Into<String>, role: Role) -> Self {
        Self {
            text: text.into(),
            role,
            whole: false,
            share: None,
        }
    }
}

/// The picture beside the words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Beside {
    /// None.
    Nothing,
    /// One without which the words can be understood.
    Helps,
    /// One that says what the words do not.
    Needed,
}

impl Beside {
    /// The tenths of its full size that it may have, the largest first.
    fn tenths(self) -> std::ops::RangeInclusive<u16> {
        match self {
            Self::Nothing => 0..=0,
            Self::Helps => 5..=10,
            Self::Needed => 7..=10,
        }
    }
}

/// Words and a picture in their places.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PlacedWords {
    pages: BigPages,
    /// How large the letters are.
    pub(super) size: LetterSize,
    /// The picture and the words on the first page and on all others.
    layouts: [Layout; 2],
}

/// A picture, perhaps of no cell, and the words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Layout {
    picture: Rect,
    words: Rect,
}

impl PlacedWords {
    /// Words on as few pages as can be, then in the largest letters, then with the largest
    /// picture; `more` says that there are other pages too. What is not to be had in large type
    /// is spelt out; `None` if that does not help.
    pub(super) fn new(
        paragraphs: &[Paragraph],
        beside: Beside,
        more: bool,
        room: Room,
        screen_rows: u16,
        look: &Look,
    ) -> Option<Self> {
        // A bar below the last paragraph has its row too.
        let last = u16::from(paragraphs.last().is_some_and(|it| it.share.is_some()));
        let alone = Layout::new(room, Beside::Nothing, 0);
        let all_layouts: Vec<_> = { beside.tenths().rev() }
            .map(|tenths| Layout::new(room, beside, tenths))
            .flat_map(|with| [[with, with], [with, alone]])
            .collect();
        let has_bars = paragraphs.iter().any(|it| it.share.is_some());
        let placed = |texts: &[_], gap, size, layouts: [Layout; 2]| {
            let set = |foot: u16| {
                let rows = |it: Layout| it.words.height.saturating_sub(last + foot);
                let rooms = layouts.map(|it| (it.words.width, rows(it)));
                BigPages::set(texts, gap, size, rooms)
            };
            // The last row of several pages says which one it is.
            let one = set(u16::from(more)).filter(|pages| pages.count() == 1);
            let pages = one.or_else(|| set(1))?;
            Some(Self {
                pages,
                size,
                layouts,
            })
        };
        let best = |spelling: Charset| {
            let each = paragraphs.iter();
            let texts = each.map(|it| (BigText::new(&it.text, spelling).into(), it.whole));
            let texts: Vec<_> = texts.collect();
            let texts = &texts;
            // The largest letters and pictures come first.
            let gaps = GAPS.into_iter().filter(|gap| *gap > 0 || !has_bars);
            let sizes = gaps.flat_map(|gap| {
                let sizes = LetterSize::legible(look.charset, screen_rows);
                sizes.map(move |size| (gap, size))
            });
            fewest_pages(sizes.flat_map(|(gap, size)| {
                let layouts = all_layouts.iter();
                layouts.filter_map(move |layouts| placed(texts, gap, size, *layouts))
            }))
        };
        [look.charset, Charset::Ascii].into_iter().find_map(best)
    }

    /// How many pages there are.
    pub(super) fn pages(&self) -> usize {
        self.pages.count()
    }

    fn layout(&self, page: usize) -> Layout {
        self.layouts[page.min(1)]
    }

    /// The place of the picture on a page; of no cell where there is none.
    pub(super) fn picture(&self, page: usize) -> Rect {
        self.layout(page).picture
    }

    /// The paragraph at a cell of a page.
    pub(super) fn at(&self, page: usize, (column, row): (u16, u16)) -> Option<usize> {
        let words = self.layout(page).words;
        let inside = words.contains((column, row).into());
        self.pages.page(page).filter(|_| inside)?.at(row - words.y)
    }

    /// The place of the words on a page.
    pub(super) fn words(&self, page: usize) -> Rect {
        self.layout(page).words
    }

    /// Draws the words of a page, with the bars of its paragraphs.
    pub(super) fn draw(
        &self,
        page: usize,
        paragraphs: &[Paragraph],
        buf: &mut Buffer,
        look: &Look,
    ) {
        let page = page.min(self.pages().saturating_sub(1));
        let place = self.layout(page).words;
        let Some(shown) = self.pages.page(page) else {
            return;
        };
        record(paragraphs, place, look.charset);
        let role = |paragraph: usize| paragraphs.get(paragraph).map_or(Role::Text, |it| it.role);
        for (paragraph, row) in shown.draw(place, buf, look, role) {
            let share = paragraphs.get(paragraph).and_then(|it| it.share);
            if let Some(share) = share.filter(|_| row < place.height) {
                let bar = bar(share, place.width, look.charset);
                let style = look.theme.style(Role::Predicted);
                buf.set_stringn(place.x, place.y + row, bar, place.width.into(), style);
            }
        }
    }
}

/// Records words for who needs no pages to show them all.
fn record(paragraphs: &[Paragraph], place: Rect, charset: Charset) {
    for paragraph in paragraphs {
        let run = Run::new(paragraph.text.as_str(), paragraph.role);
        sheet::note(place, || {
            let runs = vec![run.spelt(charset)];
            Item::new(Words::Large { runs })
        });
        if let Some(share) = paragraph.share {
            sheet::note(place, || {
                Item::new(Words::meter("", share, "", Role::Predicted))
            });
        }
    }
}

impl Layout {
    /// A picture of so many tenths of the largest square one, and the words beside it, or
    /// below it where the area is upright.
    fn new(room: Room, beside: Beside, tenths: u16) -> Self {
        let area = room.area;
        let [_, words] = areas::left(area, APART);
        if beside == Beside::Nothing {
            let picture = Rect { width: 0, ..area };
            return Self { picture, words };
        }
        if let Some(sizes) = room.pictures {
            let [picture, words] = areas::sized_picture_and_panel(area, sizes.any);
            let picture = picture.inner(Margin::new(1, 1));
            return Self { picture, words };
        }
        let is_upright = 4 * u32::from(area.height) >= 3 * u32::from(area.width);
        if is_upright {
            let rows = (area.width / 2).min(area.height / 5 * 3) * tenths / 10;
            let [picture, words] = areas::upper(area, rows);
            let [_, words] = areas::left(words, APART);
            return Self { picture, words };
        }
        let rows = area.height * tenths / 10;
        let columns = (2 * rows).saturating_sub(1);
        let columns = columns.min(area.width.saturating_sub(LEAST + APART));
        let [picture, words] = areas::left(area, columns);
        let [_, words] = areas::left(words, APART);
        let [picture, _] = areas::upper(picture, rows);
        Self { picture, words }
    }
}

/// The first of those with the fewest pages; one that ends early counts twice. After one with a
/// single page nobody looks further.
fn fewest_pages(all: impl Iterator<Item = PlacedWords>) -> Option<PlacedWords> {
    let cost = |it: &PlacedWords| it.pages() + usize::from(it.pages.ends_early());
    let mut best: Option<PlacedWords> = None;
    for placed in all {
        if placed.pages() == 1 {
            return Some(placed);
        }
        if best.as_ref().is_none_or(|it| cost(&placed) < cost(it)) {
            best = Some(placed);
        }
    }
    best
}

/// The rows of the whole screen that has such a body.
pub(super) const fn screen_rows(body: Rect) -> u16 {
    body.height + CHROME
}
