//! Panels for the back row of a class: text in the largest letters that fit beside a picture.
//!
//! The text must be legible from the back row, so it takes precedence: a picture shrinks before
//! letters do, and long text continues on further pages instead of being set in letters that are
//! too small. The exception is a panel whose first page has to show everything at once
//! ([`Panel::together`]).

use std::ops::RangeInclusive;
use std::rc::Rc;

use ratatui::buffer::Buffer;
use ratatui::layout::{Margin, Rect};

use super::cells::Writing;
use super::{ActionAt, Block, Content, LargeText, Panel};
use crate::widgets::bar::bar;
use crate::widgets::big::{Align, BigPages, BigParagraph, BigText, LetterSize};
use crate::widgets::flow::Run;
use crate::widgets::{Charset, Item, Look, Role, Room, Words, areas, sheet, text};

/// The number of rows between two paragraphs: the usual number, and the number that is used to save
/// pages.
const GAPS: [u16; 2] = [1, 0];
/// The number of empty columns on the left of the text, whether or not a picture is beside it.
const APART: u16 = 1;
/// The amounts, in tenths of the full size, by which a picture on a page that has to show
/// everything may be smaller than elsewhere, in the order in which they are tried.
const SMALLER: [u16; 2] = [0, 2];
/// The minimum width of text beside a picture, in columns.
const LEAST: u16 = 24;
/// The number of screen rows outside the body.
const CHROME: u16 = 2;

/// The kind of picture beside the text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Beside {
    /// There is no picture.
    Nothing,
    /// A picture that the text does not depend on.
    Helps,
    /// A picture that shows something that the text does not say.
    Needed,
}

impl Beside {
    /// The allowed sizes of the picture, in tenths of the full size.
    fn tenths(self) -> RangeInclusive<u16> {
        match self {
            Self::Nothing => 0..=0,
            Self::Helps => 5..=10,
            Self::Needed => 7..=10,
        }
    }
}

/// A panel with [`LargeText`] and its picture, divided into pages.
pub(crate) struct PlacedPages<'p> {
    /// The parts, each of which begins a new page.
    parts: Vec<PagedText<'p>>,
}

/// Consecutive paragraphs divided into pages; the first paragraph begins a new page.
struct PagedText<'p> {
    texts: Vec<PagedParagraph<'p>>,
    pages: BigPages,
    /// The size of the smallest letters.
    size: LetterSize,
    /// The layout of the first page, and that of all other pages.
    layouts: [VotePageLayout; 2],
}

/// A paragraph of a panel.
#[derive(Clone, Copy)]
struct PagedParagraph<'p> {
    /// The index of the paragraph's block in the panel.
    block: usize,
    text: &'p LargeText,
    /// The text that is shown: all of it or, if there is no room, its last sentence.
    shown: &'p str,
    /// Whether the paragraph can be clicked.
    acts: bool,
}

/// The area of the picture, which may be empty, and the area of the text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct VotePageLayout {
    picture: Rect,
    words: Rect,
}

impl<'p> PlacedPages<'p> {
    /// Lays a panel out beside a picture, on a screen whose body has `body_rows` rows; `None` if
    /// any letter has no large form or the text does not fit.
    pub(crate) fn new<A>(
        panel: &'p Panel<A>,
        beside: Beside,
        room: Room,
        body_rows: u16,
        look: &Look,
    ) -> Option<Self> {
        // A web page lays out the recorded blocks itself and does not use these cells.
        let screen_rows = match room.pictures {
            Some(_) => 0,
            None => body_rows + CHROME,
        };
        let blocks: Vec<_> = panel.blocks.iter().enumerate().collect();
        let is_break = |(block, _): &(Block, Vec<A>)| matches!(block.content, Content::PageBreak);
        let setting = PageSetting {
            beside,
            more: { blocks.iter() }.any(|(_, it)| is_break(it)),
            room,
            screen_rows,
            look,
        };
        let mut parts = Vec::new();
        for (number, blocks) in blocks.split(|(_, it)| is_break(it)).enumerate() {
            let texts = blocks.iter().filter_map(|(at, (block, actions))| {
                let Content::LargeText(text) = &block.content else {
                    return None;
                };
                Some(PagedParagraph {
                    block: *at,
                    text,
                    shown: &text.text,
                    acts: !actions.is_empty(),
                })
            });
            let texts: Vec<_> = texts.collect();
            if panel.together && number == 0 && room.pictures.is_none() {
                let one = PagedText::new(&texts, setting, 1).map(|one| vec![one]);
                if let Some(of_part) = one.or_else(|| on_one_page(&texts, setting)) {
                    parts.extend(of_part);
                    continue;
                }
            }
            parts.push(PagedText::new(&texts, setting, usize::MAX)?);
        }
        Some(Self { parts })
    }

    /// The number of pages.
    pub(crate) fn count(&self) -> u16 {
        self.parts.iter().map(PagedText::count).sum::<usize>() as u16
    }

    /// The part on a page, and the number of the page within that part.
    fn at(&self, page: u16) -> Option<(&PagedText<'p>, usize)> {
        let mut page = usize::from(page);
        self.parts.iter().find_map(|part| {
            if page < part.count() {
                return Some((part, page));
            }
            page -= part.count();
            None
        })
    }

    /// The area of the picture, which may be empty, and the area of the text on a page.
    pub(crate) fn places(&self, page: u16) -> [Rect; 2] {
        let layout = self.at(page).map(|(part, page)| part.layout(page));
        layout.map_or([Rect::default(); 2], |it| [it.picture, it.words])
    }

    /// Whether these pages, which have a heading in large letters above them, are as good as
    /// `other`, the layout with a small heading: the first part of each is a single page, the
    /// letters have the same size, which is one that headings can have, and the picture is not much
    /// smaller.
    pub(crate) fn are_as_good_as(&self, other: &Self) -> bool {
        let [Some(own), Some(other)] = [self, other].map(|it| it.parts.first()) else {
            return false;
        };
        (own.count(), other.count()) == (1, 1)
            && own.size == other.size
            && own.size.is_of_names()
            && 4 * own.layouts[0].picture.height >= 3 * other.layouts[0].picture.height
    }

    /// The cells of a page that can be clicked.
    pub(super) fn targets(&self, page: u16) -> impl Iterator<Item = (Rect, ActionAt)> + '_ {
        let at = self.at(page).into_iter();
        at.flat_map(|(part, page)| part.places(page))
            .map(|(block, cells)| (cells, (block, 0)))
    }

    /// Draws a page with the bars of its paragraphs, and the page number if there are several
    /// pages.
    pub(super) fn draw<A>(&self, page: u16, buf: &mut Buffer, writing: &Writing<A>) {
        let Some((part, own)) = self.at(page) else {
            return;
        };
        part.draw(own, buf, &writing.look);
        let (count, place) = (self.count(), part.layout(own).words);
        if count > 1 && place.height > 0 {
            let page = page + 1;
            let key = match &writing.pages {
                Some([back, _]) if page == count => format!("  {back}: back"),
                Some([_, on]) => format!("  {on}: the rest"),
                None => String::new(),
            };
            let note = format!("page {page} of {count}{key}");
            let column = place.right().saturating_sub(text::width(&note) as u16);
            let column = column.max(place.x);
            let style = writing.look.theme.style(Role::Key);
            let room = place.right() - column;
            buf.set_stringn(column, place.bottom() - 1, note, room.into(), style);
        }
    }
}

impl PagedText<'_> {
    fn count(&self) -> usize {
        self.pages.count()
    }

    fn layout(&self, page: usize) -> VotePageLayout {
        self.layouts[page.min(1)]
    }

    /// The indices and areas of the blocks on a page that can be clicked.
    fn places(&self, page: usize) -> impl Iterator<Item = (usize, Rect)> + '_ {
        let words = self.layout(page).words;
        self.pages.page(page).iter().filter_map(move |part| {
            let it = self.texts.get(part.paragraph)?;
            let [cells, _] = part.split(words);
            (it.acts && !cells.is_empty()).then_some((it.block, cells))
        })
    }

    fn draw(&self, page: usize, buf: &mut Buffer, look: &Look) {
        let place = self.layout(page).words;
        self.record(page, place, look.charset);
        for part in self.pages.page(page) {
            let Some(PagedParagraph { text, .. }) = self.texts.get(part.paragraph) else {
                continue;
            };
            let [own, below] = part.split(place);
            part.big.draw(own, buf, look, text.role, Align::Left);
            if let (true, Some(share)) = (part.ends && !below.is_empty(), text.share) {
                let bar = bar(share, below.width, look.charset);
                let style = look.theme.style(Role::Predicted);
                buf.set_stringn(below.x, below.y, bar, below.width.into(), style);
            }
        }
    }

    /// Records all paragraphs for shells that show them without pages.
    fn record(&self, page: usize, place: Rect, charset: Charset) {
        for PagedParagraph {
            block, text, acts, ..
        } in &self.texts
        {
            sheet::note(place, || {
                let cells = self.places(page).find(|(number, _)| number == block);
                Item {
                    words: text.words(charset),
                    press: cells.map(|(_, cells)| [cells.x, cells.y]),
                    chosen: acts.then_some(false),
                }
            });
            if let Some(share) = text.share {
                sheet::note(place, || {
                    Item::new(Words::meter("", share, "", Role::Predicted))
                });
            }
        }
    }
}

impl LargeText {
    /// The text in its recorded form.
    pub(super) fn words(&self, charset: Charset) -> Words {
        let runs = vec![Run::new(self.text.as_str(), self.role).spelt(charset)];
        Words::Large { runs }
    }
}

/// The conditions under which paragraphs are set.
#[derive(Clone, Copy)]
struct PageSetting<'l> {
    beside: Beside,
    /// Whether there are other pages besides those being set.
    more: bool,
    room: Room,
    screen_rows: u16,
    look: &'l Look,
}

/// Sets a question with its choices so that the first page shows all choices, in letters that are
/// just large enough if necessary: with the picture if possible, otherwise without it and, if
/// there is too little room, with only the last sentence of the question or none of it. Further
/// pages then show the question and the picture. Other text is set on one page with its picture.
/// `None` if that is not possible.
fn on_one_page<'p>(
    texts: &[PagedParagraph<'p>],
    setting: PageSetting,
) -> Option<Vec<PagedText<'p>>> {
    let with_picture = { SMALLER.into_iter() }.find_map(|smaller| {
        let tenths = setting.beside.tenths();
        let tenths = tenths.start().saturating_sub(smaller)..=*tenths.end();
        PagedText::on_one_page(texts, tenths, setting)
    });
    if let Some(one) = with_picture {
        return Some(vec![one]);
    }
    let choices = texts.iter().position(|it| it.text.whole)?;
    let (stem, choices) = texts.split_at(choices);
    let sentence = stem.last().map(|it| PagedParagraph {
        shown: last_sentence(it.shown),
        ..*it
    });
    let short: Vec<_> = sentence.iter().chain(choices).copied().collect();
    let setting = PageSetting {
        more: true,
        ..setting
    };
    let alone = PageSetting {
        beside: Beside::Nothing,
        ..setting
    };
    let first = [texts, &short, choices]
        .into_iter()
        .find_map(|texts| PagedText::on_one_page(texts, 0..=0, alone))?;
    Some(vec![first, PagedText::new(stem, setting, usize::MAX)?])
}

fn last_sentence(text: &str) -> &str {
    let start = text::sentence_ends(text).last().unwrap_or(0);
    text[start..].trim_start()
}

/// The sizes of letters and the gaps with which paragraphs are set.
#[derive(Clone, Copy)]
struct PageStyle {
    /// The size of the letters of a question, and that of its choices.
    sizes: [LetterSize; 2],
    /// The number of rows below a paragraph, and below a paragraph with a bar.
    gaps: [u16; 2],
}

impl<'p> PagedText<'p> {
    /// Sets paragraphs in letters of one size on as few pages as possible, preferring larger
    /// letters and then a larger picture. `None` if there would be more than `most` pages.
    fn new(paragraphs: &[PagedParagraph<'p>], setting: PageSetting, most: usize) -> Option<Self> {
        let beside = setting.beside;
        let alone = VotePageLayout::new(setting.room, Beside::Nothing, 0);
        let layouts: Vec<_> = { beside.tenths().rev() }
            .map(|tenths| VotePageLayout::new(setting.room, beside, tenths))
            .flat_map(|with| [[with, with], [with, alone]])
            .collect();
        let has_bars = paragraphs.iter().any(|it| it.text.share.is_some());
        let gaps = GAPS.into_iter().filter(|gap| *gap > 0 || !has_bars);
        let styles = gaps.flat_map(|gap| {
            let sizes = LetterSize::legible(setting.look.charset, setting.screen_rows);
            sizes.map(move |size| PageStyle {
                sizes: [size; 2],
                gaps: [gap; 2],
            })
        });
        let styles: Vec<_> = styles.collect();
        Self::best(paragraphs, setting, &styles, &layouts, most)
    }

    /// Sets paragraphs on one page beside a picture with one of these heights, in tenths of the
    /// full height. Choices have the largest letters that leave enough room for the letters of the
    /// question. `None` if that is not possible.
    fn on_one_page(
        paragraphs: &[PagedParagraph<'p>],
        tenths: RangeInclusive<u16>,
        setting: PageSetting,
    ) -> Option<Self> {
        let layout = |tenths| [VotePageLayout::new(setting.room, setting.beside, tenths); 2];
        let layouts: Vec<_> = tenths.rev().map(layout).collect();
        let sizes = LetterSize::for_one_page(setting.look.charset, setting.screen_rows);
        let pairs = { sizes.iter().enumerate() }
            .flat_map(|(i, choice)| sizes[i..].iter().map(move |stem| [*stem, *choice]));
        let styles = pairs.flat_map(|sizes| {
            GAPS.map(|gap| PageStyle {
                sizes,
                gaps: [gap, gap + 1],
            })
        });
        let styles: Vec<_> = styles.collect();
        Self::best(paragraphs, setting, &styles, &layouts, 1)
    }

    /// Sets paragraphs on as few pages as possible, in the first of the `styles` and then in the
    /// first of the `layouts` with which that is possible. Characters without a large form are spelt
    /// out; `None` if that is not possible, if the text does not fit, or if there would be more than
    /// `most` pages.
    fn best(
        paragraphs: &[PagedParagraph<'p>],
        setting: PageSetting,
        styles: &[PageStyle],
        layouts: &[[VotePageLayout; 2]],
        most: usize,
    ) -> Option<Self> {
        let has_bar = |it: &PagedParagraph| it.text.share.is_some();
        let bar_below = u16::from(paragraphs.last().is_some_and(has_bar));
        let placed = |words: &[Rc<BigText>], style: PageStyle, layouts: [VotePageLayout; 2]| {
            let texts = { paragraphs.iter().zip(words) }.map(|(it, text)| BigParagraph {
                text: Rc::clone(text),
                whole: it.text.whole,
                size: style.sizes[usize::from(it.text.whole)],
                gap: style.gaps[usize::from(has_bar(it))],
            });
            let texts: Vec<_> = texts.collect();
            let set = |foot: u16| {
                let rows = |it: VotePageLayout| it.words.height.saturating_sub(bar_below + foot);
                BigPages::set(&texts, layouts.map(|it| (it.words.width, rows(it))), most)
            };
            let pages = match set(setting.more.into()) {
                Some(pages) if pages.count() == 1 => pages,
                _ if most == 1 => return None,
                // If there are several pages, the last row shows the page number.
                _ => set(1)?,
            };
            Some(Self {
                texts: paragraphs.to_vec(),
                pages,
                size: style.sizes[0],
                layouts,
            })
        };
        let spellings = [setting.look.charset, Charset::Ascii];
        spellings.into_iter().find_map(|spelling| {
            let word = |it: &PagedParagraph| BigText::new(it.shown, spelling).into();
            let words: Vec<Rc<BigText>> = paragraphs.iter().map(word).collect();
            let (words, placed) = (&words, &placed);
            fewest_pages(styles.iter().flat_map(|style| {
                let layouts = layouts.iter();
                layouts.filter_map(move |layouts| placed(words, *style, *layouts))
            }))
        })
    }
}

impl VotePageLayout {
    /// A picture whose height is `tenths` tenths of the largest possible height, with the text
    /// beside the picture, or below it in a portrait area.
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
        if areas::is_portrait(area) {
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

/// The first layout with the fewest pages, where a layout in which any page ends early counts as
/// one page longer. The search stops at the first layout with a single page.
fn fewest_pages<'p>(all: impl Iterator<Item = PagedText<'p>>) -> Option<PagedText<'p>> {
    let cost = |it: &PagedText| it.count() + usize::from(it.pages.ends_early);
    let mut best: Option<PagedText> = None;
    for placed in all {
        if placed.count() == 1 {
            return Some(placed);
        }
        if best.as_ref().is_none_or(|it| cost(&placed) < cost(it)) {
            best = Some(placed);
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    impl PlacedPages<'_> {
        /// For each part: the size of its letters, the number of letters, the number of pages, and
        /// the area of the picture on the first page.
        pub(crate) fn parts(&self) -> impl Iterator<Item = (LetterSize, usize, usize, Rect)> + '_ {
            self.parts.iter().map(|part| {
                let letters = part.texts.iter().map(|it| it.shown.chars().count());
                (
                    part.size,
                    letters.sum(),
                    part.count(),
                    part.layouts[0].picture,
                )
            })
        }

        /// Whether the first page shows all choices with their bars.
        pub(crate) fn begins_with_all_choices(&self) -> bool {
            let Some(part) = self.parts.first() else {
                return false;
            };
            let area = part.layout(0).words;
            part.texts.iter().enumerate().all(|(number, it)| {
                let mut ends = part.pages.page(0).iter();
                let end = ends.find(|part| part.paragraph == number && part.ends);
                let has_bar = end.map(|end| !end.split(area)[1].is_empty());
                !it.text.whole || has_bar.is_some_and(|has| has || it.text.share.is_none())
            })
        }
    }
}
