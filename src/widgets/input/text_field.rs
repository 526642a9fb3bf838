//! A line of text being typed, such as a name or a code.

use tui_input::{Input as Line, InputRequest as Request};
use unicode_segmentation::UnicodeSegmentation;

use crate::messages::Key;

/// The maximum number of characters (code points) in one pasted letter; this is enough for accents
/// and emoji sequences.
const LONGEST_LETTER: usize = 32;

/// Text being typed, with a cursor.
#[derive(Debug, Clone, Default)]
pub struct TextField {
    line: Line,
    /// The maximum length in letters as perceived by a reader (grapheme clusters).
    most: usize,
}

impl TextField {
    /// Creates a field that contains `text` and holds at most `most` letters.
    pub fn new(text: &str, most: usize) -> Self {
        let text: String = text.graphemes(true).take(most).collect();
        Self {
            line: Line::new(text),
            most,
        }
    }

    /// The typed text.
    pub fn text(&self) -> &str {
        self.line.value()
    }

    /// The text before the cursor, and the text after it.
    pub(crate) fn around_cursor(&self) -> (&str, &str) {
        let text = self.line.value();
        let at = text.char_indices().nth(self.line.cursor());
        text.split_at(at.map_or(text.len(), |(at, _)| at))
    }

    /// The typed text with a mark at the cursor.
    pub fn shown(&self) -> String {
        let (before, after) = self.around_cursor();
        format!("{before}_{after}")
    }

    /// Handles a key: a letter; a key that moves the cursor by a letter or to one of the ends; or a
    /// key that deletes. Returns whether the key was used.
    pub fn update(&mut self, key: Key) -> bool {
        let request = match key {
            Key::Char(c) if !c.is_control() => {
                self.insert(c.encode_utf8(&mut [0; 4]));
                return true;
            }
            Key::Backspace | Key::Ctrl('h') => Request::DeletePrevChar,
            Key::Delete | Key::Ctrl('d') => Request::DeleteNextChar,
            Key::Left | Key::Ctrl('b') => Request::GoToPrevChar,
            Key::Right | Key::Ctrl('f') => Request::GoToNextChar,
            Key::Home | Key::Ctrl('a') => Request::GoToStart,
            Key::End | Key::Ctrl('e') => Request::GoToEnd,
            Key::Ctrl('w') => Request::DeletePrevWord,
            Key::Ctrl('u') => Request::DeleteLine,
            Key::Ctrl('k') => Request::DeleteTillEnd,
            _ => return false,
        };
        self.line.handle(request);
        true
    }

    /// Inserts a letter at the cursor; returns whether there was room for it.
    fn insert(&mut self, letter: &str) -> bool {
        let before = self.line.clone();
        for c in letter.chars() {
            self.line.handle(Request::InsertChar(c));
        }
        let fits = self.text().graphemes(true).count() <= self.most;
        if !fits {
            self.line = before;
        }
        fits
    }

    /// Inserts as much of the pasted text as fits. The rest, which may be long, is not examined.
    pub fn paste(&mut self, text: &str) {
        let is_letter = |letter: &&str| {
            !letter.contains(char::is_control) && letter.chars().nth(LONGEST_LETTER).is_none()
        };
        let mut letters = text.graphemes(true).filter(is_letter);
        while let Some(letter) = letters.next()
            && self.insert(letter)
        {}
    }
}

impl PartialEq for TextField {
    fn eq(&self, other: &Self) -> bool {
        (self.text(), self.line.cursor()) == (other.text(), other.line.cursor())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn typed(keys: &[Key]) -> TextField {
        let mut field = TextField::new("", 6);
        for key in keys {
            field.update(*key);
        }
        field
    }

    #[test]
    fn letters_are_inserted_at_the_cursor() {
        let field = typed(&[Key::Char('a'), Key::Char('c'), Key::Left, Key::Char('b')]);
        assert_eq!(field.text(), "abc");
        assert_eq!(field.around_cursor(), ("ab", "c"));
    }

    #[test]
    fn words_and_lines_are_deleted() {
        let mut field = TextField::new("one two", 20);
        field.update(Key::Ctrl('w'));
        assert_eq!(field.text().trim_end(), "one");
        field.update(Key::Ctrl('u'));
        assert_eq!(field.text(), "");
    }

    #[test]
    fn it_accepts_no_more_letters_than_its_limit() {
        let mut field = TextField::new("e\u{301}e\u{301}e\u{301}e\u{301}", 6);
        field.paste("xyz\u{301}");
        let pile = format!("e{}", "\u{301}".repeat(1000));
        field.paste(&pile);
        assert_eq!(field.text(), "e\u{301}e\u{301}e\u{301}e\u{301}xy");
        assert!(!field.update(Key::Enter));
    }
}
