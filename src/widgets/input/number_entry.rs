//! A number being typed.

use strum::{EnumMessage, IntoStaticStr};

use super::{KeyTable, Outcome};
use crate::messages::Key;

/// The maximum number of characters that can be typed.
const LONGEST: usize = 9;

/// A number being typed, digit by digit.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct NumberEntry {
    text: String,
}

/// What the keys do while a number is being typed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum EntryAction {
    /// type a number; Enter sets it, Esc cancels it
    Type(char),
    /// delete the last digit
    Erase,
    /// set the typed number
    Enter,
    /// discard the number that is being typed
    GiveUp,
}

impl NumberEntry {
    /// Whether there is typed text that has been neither accepted nor discarded.
    pub(crate) fn is_open(&self) -> bool {
        !self.text.is_empty()
    }

    /// The typed text.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// The typed text with a cursor after it; `None` while there is no text.
    pub(crate) fn shown(&self) -> Option<String> {
        self.is_open().then(|| format!("{}_", self.text))
    }

    /// The number typed so far; `None` if the text is not a number yet.
    pub(crate) fn value(&self) -> Option<f64> {
        self.text.parse().ok().filter(|v: &f64| v.is_finite())
    }

    /// Clears the typed text and returns its number.
    pub(crate) fn take(&mut self) -> Option<f64> {
        let value = self.value();
        self.text.clear();
        value
    }

    /// The keys for typing; once something has been typed, Enter accepts the number and Escape
    /// discards it.
    pub(crate) fn keys(&self) -> KeyTable<EntryAction> {
        let typed = |c| (Key::Char(c), EntryAction::Type(c));
        let open = self.is_open();
        KeyTable::new("number")
            .each(('0'..='9').map(typed), "type")
            .or(['.', ',', '-', '−'].map(typed))
            .on(Key::Backspace, EntryAction::Erase, "")
            .when(open)
            .on(Key::Enter, EntryAction::Enter, "set")
            .when(open)
            .on(Key::Escape, EntryAction::GiveUp, "cancel")
            .when(open)
    }

    /// Carries out an action; returns `Done` with the number once it is entered.
    pub(crate) fn act(&mut self, action: EntryAction) -> Outcome<f64> {
        match action {
            EntryAction::Type(c) => self.push(c),
            EntryAction::Erase => drop(self.text.pop()),
            EntryAction::GiveUp => self.text.clear(),
            EntryAction::Enter => return self.take().map_or(Outcome::Used, Outcome::Done),
        }
        Outcome::Used
    }

    fn push(&mut self, c: char) {
        let c = match c {
            ',' => '.',
            '−' => '-',
            c => c,
        };
        let misplaced = match c {
            '-' => !self.text.is_empty(),
            '.' => self.text.contains('.'),
            _ => false,
        };
        if !misplaced && self.text.len() < LONGEST {
            self.text.push(c);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn press(entry: &mut NumberEntry, key: Key) -> Outcome<f64> {
        let action = entry.keys().exact(key);
        action.map_or(Outcome::Ignored, |action| entry.act(action))
    }

    fn typed(keys: &str) -> (NumberEntry, Outcome<f64>) {
        let mut entry = NumberEntry::default();
        let mut last = Outcome::Ignored;
        for c in keys.chars() {
            last = press(
                &mut entry,
                match c {
                    '\n' => Key::Enter,
                    '<' => Key::Backspace,
                    '!' => Key::Escape,
                    c => Key::Char(c),
                },
            );
        }
        (entry, last)
    }

    #[test]
    fn a_number_is_typed_and_entered() {
        assert_eq!(typed("-12.5\n").1, Outcome::Done(-12.5));
        assert_eq!(typed("7<3\n").1, Outcome::Done(3.0));
    }

    #[test]
    fn a_text_that_is_not_a_number_is_never_entered() {
        assert_eq!(typed("-\n").1, Outcome::Used);
        assert_eq!(typed(".\n").1, Outcome::Used);
        assert_eq!(typed("1.2.3").0.text(), "1.23");
        assert_eq!(typed("1-").0.text(), "1");
        assert_eq!(typed("123456789012").0.text().len(), LONGEST);
    }

    #[test]
    fn escape_discards_a_number_and_is_unused_without_one() {
        let (mut entry, last) = typed("12!");
        assert_eq!(last, Outcome::Used);
        assert!(!entry.is_open());
        assert_eq!(press(&mut entry, Key::Escape), Outcome::Ignored);
        assert_eq!(press(&mut entry, Key::Enter), Outcome::Ignored);
    }
}
