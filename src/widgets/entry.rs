//! A number being typed.

use crate::messages::Key;

/// Longest text that can be typed.
const LONGEST: usize = 9;

/// A number on its way in, digit by digit.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct NumberEntry {
    text: String,
}

/// What a key meant to a [`NumberEntry`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Typed {
    /// Nothing: it is somebody else's key.
    Ignored,
    /// The text grew, shrank or was given up.
    Editing,
    /// Enter was pressed on a finished number.
    Entered(f64),
}

impl NumberEntry {
    /// Whether something has been typed and neither entered nor given up.
    pub fn is_open(&self) -> bool {
        !self.text.is_empty()
    }

    /// What has been typed.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The number as far as typed; `None` while it is not one yet.
    pub fn value(&self) -> Option<f64> {
        self.text.parse().ok().filter(|v: &f64| v.is_finite())
    }

    /// Empties the entry and gives the number it held.
    pub fn take(&mut self) -> Option<f64> {
        let value = self.value();
        self.text.clear();
        value
    }

    /// Takes a key. While the entry is open, Enter enters and Escape gives up.
    pub fn update(&mut self, key: Key) -> Typed {
        match key {
            Key::Char(c @ ('0'..='9' | '.' | '-')) => {
                let misplaced = match c {
                    '-' => !self.text.is_empty(),
                    '.' => self.text.contains('.'),
                    _ => false,
                };
                if !misplaced && self.text.len() < LONGEST {
                    self.text.push(c);
                }
            }
            _ if !self.is_open() => return Typed::Ignored,
            Key::Backspace => {
                self.text.pop();
            }
            Key::Escape => self.text.clear(),
            Key::Enter => {
                return match self.take() {
                    Some(value) => Typed::Entered(value),
                    None => Typed::Editing,
                };
            }
            _ => return Typed::Ignored,
        }
        Typed::Editing
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn typed(keys: &str) -> (NumberEntry, Typed) {
        let mut entry = NumberEntry::default();
        let mut last = Typed::Ignored;
        for c in keys.chars() {
            last = entry.update(match c {
                '\n' => Key::Enter,
                '<' => Key::Backspace,
                '!' => Key::Escape,
                c => Key::Char(c),
            });
        }
        (entry, last)
    }

    #[test]
    fn a_number_is_typed_and_entered() {
        assert_eq!(typed("-12.5\n").1, Typed::Entered(-12.5));
        assert_eq!(typed("7<3\n").1, Typed::Entered(3.0));
    }

    #[test]
    fn what_is_no_number_is_never_entered() {
        assert_eq!(typed("-\n").1, Typed::Editing);
        assert_eq!(typed(".\n").1, Typed::Editing);
        assert_eq!(typed("1.2.3").0.text(), "1.23");
        assert_eq!(typed("1-").0.text(), "1");
        assert_eq!(typed("123456789012").0.text().len(), LONGEST);
    }

    #[test]
    fn escape_gives_up_the_number_first_and_is_free_again_then() {
        let (mut entry, last) = typed("12!");
        assert_eq!(last, Typed::Editing);
        assert!(!entry.is_open());
        assert_eq!(entry.update(Key::Escape), Typed::Ignored);
        assert_eq!(entry.update(Key::Enter), Typed::Ignored);
    }
}
