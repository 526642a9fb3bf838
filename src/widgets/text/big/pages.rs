//! Long text in large type, on as many pages as necessary.

use std::rc::Rc;

use ratatui::layout::Rect;

use super::{Big, BigText, LetterSize};
use crate::widgets::areas;

/// Paragraphs in large letters, divided into pages.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct BigPages {
    pages: Vec<Vec<BigPart>>,
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

/// A paragraph on a page, or the part of a paragraph that fits on the page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct BigPart {
    /// The index of the paragraph.
    pub(crate) paragraph: usize,
    /// The first row.
    row: u16,
    pub(crate) big: Big,
    /// Whether the paragraph ends on this page.
    pub(crate) ends: bool,
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
        let mut pages: Vec<Vec<BigPart>> = vec![Vec::new()];
        // The rows used on the last page, including the gap below the last paragraph.
        let mut taken = 0;
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
                let room = rows.saturating_sub(taken);
                let is_fresh = page.is_empty();
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
                    pages.push(Vec::new());
                    taken = 0;
                    continue;
                }
                big.lines.truncate(most);
                from += big.words();
                let (row, ends) = (taken, from == text.len());
                taken += big.rows() + it.gap;
                page.push(BigPart {
                    paragraph,
                    row,
                    big,
                    ends,
                });
                if !ends {
                    pages.push(Vec::new());
                    taken = 0;
                }
            }
        }
        Some(Self { pages, ends_early })
    }

    /// The number of pages.
    pub(crate) fn count(&self) -> usize {
        self.pages.len()
    }

    /// The parts of the page with this number, counted from 0; if there are fewer pages, those of
    /// the last page.
    pub(crate) fn page(&self, number: usize) -> &[BigPart] {
        let page = self.pages.get(number).or_else(|| self.pages.last());
        page.map_or(&[], Vec::as_slice)
    }
}

impl BigPart {
    /// The area of the part on a page, and the area below it.
    pub(crate) fn split(&self, page: Rect) -> [Rect; 2] {
        let [_, area] = areas::upper(page, self.row);
        areas::upper(area, self.big.rows())
    }
}
