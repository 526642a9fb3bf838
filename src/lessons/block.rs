//! The text of a page: paragraphs, lists, formulas and numbers.

use super::inline::{self, PageSource};
use super::{Formula, Quantity, SourceLine};
use crate::files::all;

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
    let mut blocks = Vec::new();
    let mut open: Option<OpenBlock> = None;
    for &(number, line) in lines {
        let text = line.trim();
        let formula = text
            .strip_prefix("$$")
            .and_then(|rest| rest.strip_suffix("$$"));
        let (item, rest) = item(text);
        let ends = text.is_empty() || formula.is_some() || item.is_some();
        if let Some(done) = open.take_if(|_| ends) {
            blocks.push(done.close(page));
        }
        if let Some(formula) = formula {
            let formula = page.source.accept(number, Formula::read(formula));
            blocks.push(formula.map(TextBlock::Formula));
        } else if !text.is_empty() {
            match &mut open {
                Some(open) => {
                    open.text.push('\n');
                    open.text.push_str(text);
                }
                None => {
                    open = Some(OpenBlock {
                        line: number,
                        item,
                        text: rest.to_owned(),
                    });
                }
            }
        }
    }
    blocks.extend(open.map(|open| open.close(page)));
    all(blocks)
}

/// A paragraph or a list item that is still being read.
struct OpenBlock {
    line: usize,
    item: Option<Option<u32>>,
    text: String,
}

impl OpenBlock {
    fn close(self, page: &PageSource) -> Option<TextBlock> {
        let pieces = inline::read(self.line, &self.text, page)?;
        Some(match self.item {
            None => TextBlock::Paragraph(pieces),
            Some(number) => TextBlock::Item(number, pieces),
        })
    }
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
