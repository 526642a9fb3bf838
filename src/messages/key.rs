//! A single key press.

use std::fmt;

use strum::{EnumString, IntoStaticStr};

/// A key press (or an automatic repeat), independent of the types of any terminal library.
///
/// The character in [`Key::Char`] already takes Shift into account; shells do not pass on key
/// presses with Alt or the system key.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, EnumString, IntoStaticStr)]
#[strum(ascii_case_insensitive)]
pub enum Key {
    /// A printable character; the space bar is `Char(' ')`.
    #[strum(disabled)]
    Char(char),
    /// A lower-case letter pressed together with Control.
    #[strum(disabled)]
    Ctrl(char),
    /// Arrow up.
    Up,
    /// Arrow down.
    Down,
    /// Arrow left.
    Left,
    /// Arrow right.
    Right,
    /// Enter or Return.
    Enter,
    /// Escape.
    #[strum(to_string = "Esc", serialize = "Escape")]
    Escape,
    /// Tab.
    Tab,
    /// Shift and Tab together.
    #[strum(serialize = "Shift+Tab")]
    BackTab,
    /// Backspace.
    Backspace,
    /// Delete.
    Delete,
    /// Page up.
    PageUp,
    /// Page down.
    PageDown,
    /// Home.
    Home,
    /// End.
    End,
    /// A function key, numbered from 1.
    #[strum(disabled)]
    F(u8),
}

impl From<char> for Key {
    fn from(c: char) -> Self {
        Self::Char(c)
    }
}

impl Key {
    /// The four arrows: up, down, left, right.
    pub(crate) const ARROWS: [Self; 4] = [Self::Up, Self::Down, Self::Left, Self::Right];

    /// The key that a string stands for; the string is either a single character or the name of a
    /// key as in a tape.
    pub fn parse(text: &str) -> Option<Self> {
        match text.parse::<char>() {
            Ok(c) if !c.is_control() => Some(Self::Char(c)),
            _ => Self::named(text),
        }
    }

    /// The key with this name, as in a tape (`Right`, `Space`, `Ctrl+C`, `F1`), in upper or lower
    /// case; `None` if no key has this name.
    pub fn named(name: &str) -> Option<Self> {
        let lower = name.to_ascii_lowercase();
        if lower == "space" {
            return Some(Self::Char(' '));
        }
        if let Some(letter) = lower.strip_prefix("ctrl+") {
            let letter = letter.parse().ok().filter(char::is_ascii_lowercase);
            return letter.map(Self::Ctrl);
        }
        let function = || {
            let number = lower.strip_prefix('f')?.parse().ok()?;
            (1..=12).contains(&number).then_some(Self::F(number))
        };
        lower.parse().ok().or_else(function)
    }
}

impl fmt::Display for Key {
    /// Writes the character, or the name of the key as in a tape (`Space` for the space bar).
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Char(' ') => f.write_str("Space"),
            Self::Char(c) => write!(f, "{c}"),
            Self::Ctrl(c) => write!(f, "Ctrl+{}", c.to_ascii_uppercase()),
            Self::F(n) => write!(f, "F{n}"),
            named => f.write_str(named.into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn key_names_in_tapes_are_read() {
        assert_eq!(Key::named("Right"), Some(Key::Right));
        assert_eq!(Key::named("Space"), Some(Key::Char(' ')));
        assert_eq!(Key::named("Ctrl+C"), Some(Key::Ctrl('c')));
        assert_eq!(Key::named("Shift+Tab"), Some(Key::BackTab));
        assert_eq!(Key::named("F12"), Some(Key::F(12)));
    }

    #[test]
    fn other_names_are_refused() {
        for name in ["", "F0", "F13", "f", "Ctrl+", "Ctrl+AB", "Ctrl+1", "Enterx"] {
            assert_eq!(Key::named(name), None, "{name}");
        }
    }
}
