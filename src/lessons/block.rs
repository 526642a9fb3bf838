//! The text of a page: paragraphs, lists, formulas and numbers.

use super::inline::{self, PageSource};
use super::{Formula, Quantity, SourceLine};
use crate::files::all;
use crate::physics::Collision;

/// A block of text.
#[derive(Debug, Clone, PartialEq)]
pub enum TextBlock {
    /// A paragraph.
    Paragraph(Vec<Inline>),
    /// A list item, with its number if the list is numbered.
    Item(Option<u32>, Vec<Inline>),
    /// A formula on a separate line.
    Formula(Formula),
}

/// A piece of a paragraph.
#[derive(Debug, Clone, PartialEq)]
pub enum Inline {
    /// Text with one emphasis.
    Text(String, Tone),
    /// A formula in running text.
    Formula(Formula),
    /// A number that changes together with the page's figure.
    Live(Quantity),
}

impl Inline {
    /// Pieces of text without emphasis, with the numbers of the collision in the page's figure. The
    /// spaces of a formula are no-break spaces.
    pub(super) fn plain(pieces: &[Self], figure: Option<&Collision>) -> String {
        let plain = |piece: &Self| match piece {
            Self::Text(text, _) => text.clone(),
            Self::Formula(formula) => formula.inline().replace(' ', "\u{a0}"),
            Self::Live(quantity) => figure.map_or(String::new(), |it| quantity.shown(it)),
        };
        pieces.iter().map(plain).collect()
    }
}

/// The emphasis of text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tone {
    /// No emphasis.
    Plain,
    /// Emphasized.
    Emphasis,
    /// Strong emphasis, used for important terms.
    Strong,
    /// The name of a key to press.
    Key,
}

/// Reads the blocks of text in these lines.
pub(super) fn read(lines: &[SourceLine], page: &PageSource) -> Option<Vec<TextBlock>> {
    let is_text = |text: &str| !text.is_empty() && formula(text).is_none();
    let goes_on = |(_, before): &SourceLine, (_, text): &SourceLine| {
        let (before, text) = (before.trim(), text.trim());
        is_text(before) && is_text(text) && item(text).0.is_none()
    };
    let blocks = lines.chunk_by(goes_on);
    let blocks = blocks.filter(|lines| lines.iter().any(|(_, text)| !text.trim().is_empty()));
    all(blocks.map(|lines| block(lines, page)).collect())
}

/// Reads the lines of one block.
fn block(lines: &[SourceLine], page: &PageSource) -> Option<TextBlock> {
    let ((number, first), others) = lines.split_first()?;
    let first = first.trim();
    if let Some(formula) = formula(first) {
        let formula = page.source.accept(*number, Formula::read(formula));
        return formula.map(TextBlock::Formula);
    }
    let (item, rest) = item(first);
    let others = others.iter().map(|(_, text)| text.trim());
    let text: Vec<&str> = std::iter::once(rest).chain(others).collect();
    let pieces = inline::read(*number, &text.join("\n"), page)?;
    Some(match item {
        None => TextBlock::Paragraph(pieces),
        Some(number) => TextBlock::Item(number, pieces),
    })
}

/// The formula on a line of its own.
fn formula(text: &str) -> Option<&str> {
    text.strip_prefix("$$")?.strip_suffix("$$")
}

/// The list item that begins on a line, with its number and the rest of the line.
fn item(text: &str) -> (Option<Option<u32>>, &str) {
    if let Some(rest) = text.strip_prefix("- ") {
        return (Some(None), rest);
    }
    if let Some((number, rest)) = text.split_once(". ")
        && number.len() <= 2
        && let Ok(number) = number.parse()
    {
        return (Some(Some(number)), rest);
    }
    (None, text)
}
