//! The words of a string, prepared for large type. Many areas and sizes are tried, so the letters
//! of each word are put together only once.

use std::cell::OnceCell;
use std::ops::Range;

use super::strokes::{self, LetterRows};
use super::{BLANK, LetterSize, pixels_of};
use crate::widgets::Charset;
use crate::widgets::text::{self, terms};

/// The maximum length of a group of words that is kept together on one line, in columns of plain
/// text.
const HELD: usize = 14;

#[derive(Debug, PartialEq, Eq)]
pub(crate) struct BigText {
    words: Vec<BigWord>,
    /// Groups of words that are kept together, in order.
    held: Vec<Range<usize>>,
}

/// A word in pixels and in strokes; each form is `None` if it lacks one of the letters.
#[derive(Debug, PartialEq, Eq)]
struct BigWord {
    text: String,
    pixels: OnceCell<Option<Vec<u8>>>,
    strokes: OnceCell<Option<LetterRows>>,
}

impl BigText {
    /// Splits a string into words, spelt in a charset.
    pub(crate) fn new(text: &str, charset: Charset) -> Self {
        let text = charset.text(text);
        let words: Vec<&str> = text.split_whitespace().collect();
        let held = terms::held(&words, HELD);
        let word = |text: &str| BigWord {
            text: text.to_owned(),
            pixels: OnceCell::new(),
            strokes: OnceCell::new(),
        };
        let words = words.into_iter().map(word).collect();
        Self { words, held }
    }

    pub(super) fn len(&self) -> usize {
        self.words.len()
    }

    /// Breaks the words, starting with the word at index `from`, into lines of `columns` columns,
    /// up to the first word that is too long for a line; `None` if any letter has no large form.
    /// Words that belong together stay together if possible.
    pub(super) fn lines(
        &self,
        from: usize,
        size: LetterSize,
        columns: usize,
    ) -> Option<Vec<Range<usize>>> {
        let mut parts: Vec<(Range<usize>, usize)> = Vec::new();
        'words: for held in self.held.iter().filter(|held| held.end > from) {
            let held = held.start.max(from)..held.end;
            let width = self.columns(held.clone(), size)?;
            if width <= columns {
                parts.push((held, width));
                continue;
            }
            for word in held {
                let width = self.columns(word..word + 1, size)?;
                if width > columns {
                    break 'words;
                }
                parts.push((word..word + 1, width));
            }
        }
        let blank = size.columns(size.blank());
        let mut lines: Vec<(Range<usize>, usize)> = Vec::new();
        for (part, width) in parts {
            match lines.last_mut() {
                Some((line, taken)) if *taken + blank + width <= columns => {
                    line.end = part.end;
                    *taken += blank + width;
                }
                _ => lines.push((part, width)),
            }
        }
        Some(lines.into_iter().map(|(line, _)| line).collect())
    }

    /// The width of words on one line, in columns.
    pub(super) fn columns(&self, words: Range<usize>, size: LetterSize) -> Option<usize> {
        let blanks = words.len().saturating_sub(1) * size.blank();
        let mut words = self.words[words].iter();
        let letters = words.try_fold(0, |sum, it| Some(sum + it.length(size)?));
        Some(size.columns(letters? + blanks))
    }

    /// A line of words in plain type.
    pub(super) fn plain(&self, words: Range<usize>) -> String {
        let words: Vec<&str> = self.words[words].iter().map(|it| &*it.text).collect();
        words.join(" ")
    }

    /// A line of words in letters made of pixels.
    pub(super) fn pixels(&self, words: Range<usize>) -> Option<Vec<u8>> {
        let words: Option<Vec<_>> = self.words[words].iter().map(BigWord::pixels).collect();
        Some(words?.join(&[0; BLANK][..]))
    }

    /// A line of words in letters made of strokes.
    pub(super) fn strokes(&self, words: Range<usize>) -> Option<LetterRows> {
        let words: Option<Vec<_>> = self.words[words].iter().map(BigWord::strokes).collect();
        Some(strokes::beside(&words?))
    }
}

impl BigWord {
    /// The length of the word at a size, in the unit of [`LetterSize::columns`].
    fn length(&self, size: LetterSize) -> Option<usize> {
        Some(match size {
            LetterSize::Plain => text::width(&self.text),
            LetterSize::Strokes => self.strokes()?[0].len(),
            _ => self.pixels()?.len(),
        })
    }

    fn pixels(&self) -> Option<&[u8]> {
        let pixels = self.pixels.get_or_init(|| pixels_of(&self.text));
        pixels.as_deref()
    }

    fn strokes(&self) -> Option<&LetterRows> {
        let strokes = self.strokes.get_or_init(|| strokes::joined(&self.text));
        strokes.as_ref()
    }
}
