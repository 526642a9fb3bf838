//! One press of a key.

use std::fmt;

/// A key press (or repeat), free of any terminal library's types.
///
/// Shift is already in the character of [`Key::Char`]; a press with Alt or with
/// the system key is not passed on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Key {
    /// A printable character; the space bar is `Char(' ')`.
    Char(char),
    /// A lower-case letter with Control held.
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
    Escape,
    /// Tab.
    Tab,
    /// Shift and Tab.
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
    /// A function key, from 1.
    F(u8),
}

impl From<char> for Key {
    fn from(c: char) -> Self {
        Self::Char(c)
    }
}

impl Key {
    /// The four arrows: up, down, left, right.
    pub const ARROWS: [Self; 4] = [Self::Up, Self::Down, Self::Left, Self::Right];
    /// The keys of pages: up, down.
    pub const PAGES: [Self; 2] = [Self::PageUp, Self::PageDown];

    /// The key of a text: a character stands for itself, a name for what a tape calls so.
    pub fn parse(text: &str) -> Option<Self> {
        let mut letters = text.chars();
        match (letters.next(), letters.next()) {
            (Some(c), None) if !c.is_control() => Some(Self::Char(c)),
            _ => Self::named(text),
        }
    }

    /// The key of a name as a tape writes it (`Right`, `Space`, `Ctrl+C`, `F1`),
    /// whatever the case of its letters; `None` if there is no such key.
    pub fn named(name: &str) -> Option<Self> {
        let lower = name.to_ascii_lowercase();
        Some(match lower.as_str() {
            "up" => Self::Up,
            "down" => Self::Down,
            "left" => Self::Left,
            "right" => Self::Right,
            "enter" => Self::Enter,
            "escape" | "esc" => Self::Escape,
            "tab" => Self::Tab,
            "shift+tab" => Self::BackTab,
            "backspace" => Self::Backspace,
            "delete" => Self::Delete,
            "space" => Self::Char(' '),
            "pageup" => Self::PageUp,
            "pagedown" => Self::PageDown,
            "home" => Self::Home,
            "end" => Self::End,
            other => {
                if let Some(letter) = other.strip_prefix("ctrl+") {
                    let mut letters = letter.chars();
                    return match (letters.next(), letters.next()) {
                        (Some(c), None) if c.is_ascii_lowercase() => Some(Self::Ctrl(c)),
                        _ => None,
                    };
                }
                let number = other.strip_prefix('f')?.parse().ok()?;
                return (1..=12).contains(&number).then_some(Self::F(number));
            }
        })
    }
}

impl fmt::Display for Key {
    /// The name as the bottom line of a screen shows it, in ASCII.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = match self {
            Self::Char(' ') => "Space",
            Self::Char(c) => return write!(f, "{c}"),
            Self::Ctrl(c) => return write!(f, "Ctrl+{}", c.to_ascii_uppercase()),
            Self::F(n) => return write!(f, "F{n}"),
            Self::Up => "Up",
            Self::Down => "Down",
            Self::Left => "Left",
            Self::Right => "Right",
            Self::Enter => "Enter",
            Self::Escape => "Esc",
            Self::Tab => "Tab",
            Self::BackTab => "Shift+Tab",
            Self::Backspace => "Backspace",
            Self::Delete => "Delete",
            Self::PageUp => "PageUp",
            Self::PageDown => "PageDown",
            Self::Home => "Home",
            Self::End => "End",
        };
        f.write_str(name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_a_tape_are_read() {
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
