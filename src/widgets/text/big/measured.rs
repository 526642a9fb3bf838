//! The words of a string, prepared for large type. Many areas and sizes are tried, so the letters
//! of each word are put together only once.

use std::cell::OnceCell;
use std::ops::Range;

use super::strokes::{self, LetterRows};
use super::{BLANK, Ink, LetterSize, pixels_of};
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
        let blank = match size {
            LetterSize::Strokes => strokes::BLANK,
            LetterSize::Plain => 1,
            _ => size.columns(BLANK),
        };
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
        let blanks = words.len().saturating_sub(1);
        let mut words = self.words[words].iter();
        match size {
            LetterSize::Plain => {
                Some(words.map(|it| text::width(&it.text)).sum::<usize>() + blanks)
            }
            LetterSize::Strokes => {
                let letters = words.try_fold(0, |sum, it| Some(sum + it.strokes()?[0].len()));
                Some(letters? + blanks * strokes::BLANK)
            }
            _ => {
                let letters = words.try_fold(0, |sum, it| Some(sum + it.pixels()?.len()));
                Some(size.columns(letters? + blanks * BLANK))
            }
        }
    }

    pub(super) fn ink(&self, words: Range<usize>, size: LetterSize) -> Option<Ink> {
        if size == LetterSize::Strokes {
            return self.strokes(words).map(Ink::Strokes);
        }
        let words = self.words[words].iter();
        if size == LetterSize::Plain {
            let words: Vec<&str> = words.map(|it| it.text.as_str()).collect();
            return Some(Ink::Plain(words.join(" ")));
        }
        let words: Option<Vec<&[u8]>> = words.map(|it| it.pixels().map(Vec::as_slice)).collect();
        Some(Ink::Pixels(words?.join(&[0; BLANK][..])))
    }

    /// A line of words in letters made of strokes.
    pub(super) fn strokes(&self, words: Range<usize>) -> Option<LetterRows> {
        let words: Option<Vec<_>> = self.words[words].iter().map(BigWord::strokes).collect();
        Some(strokes::beside(&words?))
    }
}

impl BigWord {
    fn pixels(&self) -> Option<&Vec<u8>> {
        let pixels = self.pixels.get_or_init(|| pixels_of(&self.text));
        pixels.as_ref()
    }

    fn strokes(&self) -> Option<&LetterRows> {
        let strokes = self.strokes.get_or_init(|| strokes::joined(&self.text));
        strokes.as_ref()
    }
}
