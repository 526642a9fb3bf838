//! Long text in large type, on as many pages as necessary.

use std::ops::Range;
use std::rc::Rc;

use ratatui::{buffer::Buffer, layout::Rect};

use super::{Align, Big, BigText, LetterSize};
use crate::widgets::{Look, Role, areas};

/// Paragraphs in large letters, divided into pages.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct BigPages {
    pages: Vec<BigPage>,
    /// Whether a page ends early, because the next word is too long for its lines.
    pub(crate) ends_early: bool,
}

/// A paragraph to be set in large letters.
#[derive(Debug, Clone)]
pub(crate) struct BigParagraph {
    pub(crate) text: Rc<BigText>,
    /// Whether the paragraph must not be split if it fits on one page.
    pub(crate) whole: bool,
    pub(crate) size: LetterSize,
    /// The number of empty rows below the paragraph.
    pub(crate) gap: u16,
}

/// The contents of a page.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct BigPage {
    parts: Vec<BigPart>,
    /// The number of rows used, including the gap below the last paragraph.
    taken: u16,
}

/// A paragraph on a page, or the part of a paragraph that fits on the page.
#[derive(Debug, Clone, PartialEq, Eq)]
struct BigPart {
    row: u16,
    paragraph: usize,
    big: Big,
    /// Whether the paragraph ends on this page.
    ends: bool,
}

impl BigPages {
    /// Sets paragraphs. The first page has the columns and rows of `first`, and all other pages
    /// have those of `rest`. A paragraph that is not marked as whole may continue on the next page.
    /// A word that is too long for a line of the first page starts the next page. `None` if there
    /// are more than `most` pages, if a word or a line does not fit on an empty page after the
    /// first, or if any letter has no large form.
    pub(crate) fn set(
        paragraphs: &[BigParagraph],
        [first, rest]: [(u16, u16); 2],
        most: usize,
    ) -> Option<Self> {
        let mut pages = vec![BigPage::default()];
        let mut ends_early = false;
        for (paragraph, it) in paragraphs.iter().enumerate() {
            let (text, size) = (&it.text, it.size);
            let mut from = 0;
            while from < text.len() {
                if pages.len() > most {
                    return None;
                }
                let (columns, rows) = if pages.len() == 1 { first } else { rest };
                let page = pages.last_mut()?;
                let room = rows.saturating_sub(page.taken);
                let is_fresh = page.parts.is_empty();
                let mut big = Big::begin(text, from, size, (columns, room), is_fresh)?;
                let fits = big.lines_in(room);
                let too_long = fits == big.lines.len() && from + big.words() < text.len();
                ends_early |= too_long;
                let is_whole = fits == big.lines.len() && !too_long;
                let most = match is_whole || is_fresh || !it.whole {
                    true => fits,
                    false => 0,
                };
                if most == 0 {
                    // Not even one line fits on an empty page, so another page would not help.
                    if is_fresh && pages.len() > 1 {
                        return None;
                    }
                    pages.push(BigPage::default());
                    continue;
                }
                big.lines.truncate(most);
                from += big.words();
                let part = BigPart {
                    row: page.taken,
                    paragraph,
                    ends: from == text.len(),
                    big,
                };
                page.taken += part.big.rows() + it.gap;
                page.parts.push(part);
                if from < text.len() {
                    pages.push(BigPage::default());
                }
            }
        }
        Some(Self { pages, ends_early })
    }

    /// The number of pages.
    pub(crate) fn count(&self) -> usize {
        self.pages.len()
    }

    /// The page with this number, counted from 0; if there are fewer pages, the last page.
    pub(crate) fn page(&self, number: usize) -> Option<&BigPage> {
        self.pages.get(number.min(self.count().saturating_sub(1)))
    }
}

impl BigPage {
    /// Draws the page, with each paragraph in its role; returns the row below each paragraph that
    /// ends on this page.
    pub(crate) fn draw(
        &self,
        area: Rect,
        buf: &mut Buffer,
        look: &Look,
        role: impl Fn(usize) -> Role,
    ) -> Vec<(usize, u16)> {
        let mut ends = Vec::new();
        for part in &self.parts {
            let [_, place] = areas::upper(area, part.row);
            part.big
                .draw(place, buf, look, role(part.paragraph), Align::Left);
            if part.ends {
                ends.push((part.paragraph, part.row + part.big.rows()));
            }
        }
        ends
    }

    /// The paragraphs on the page, each with the rows that it occupies.
    pub(crate) fn places(&self) -> impl Iterator<Item = (usize, Range<u16>)> + '_ {
        let rows = |part: &BigPart| part.row..part.row + part.big.rows();
        { self.parts.iter() }.map(move |part| (part.paragraph, rows(part)))
    }
}
