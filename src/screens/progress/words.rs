//! Words and figures of the screen.

use crate::widgets::text;

pub(super) use crate::progress::words::{degrees, percent};

/// A name from outside in at most so many columns, whatever it is.
pub(super) fn brief(name: &str, columns: usize) -> String {
    let mut shown = String::new();
    for letter in name.chars().filter(|letter| !letter.is_control()) {
        // Marks without a width of their own must not pile up without end either.
        let longer = text::width(&shown) + text::width(letter.encode_utf8(&mut [0; 4]));
        if longer > columns || shown.chars().count() >= columns {
            while text::width(&shown) + 2 > columns && shown.pop().is_some() {}
            return shown + "..";
        }
        shown.push(letter);
    }
    shown
}

/// A text padded with blanks on its right to so many columns.
pub(super) fn padded(text: &str, columns: usize) -> String {
    let missing = columns.saturating_sub(text::width(text));
    format!("{text}{}", " ".repeat(missing))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_name_takes_more_than_its_place() {
        for name in [
            "Ada".to_owned(),
            "球".repeat(9),
            "x".repeat(10_000),
            format!("e{}", "\u{301}".repeat(10_000)),
            "\u{1b}[2J\n\n\u{0}".into(),
            "👩‍👩‍👧‍👦".repeat(50),
        ] {
            for columns in [0, 1, 2, 5, 24] {
                let brief = brief(&name, columns);
                assert!(text::width(&brief) <= columns.max(2), "{brief:?}");
                assert!(brief.chars().count() <= columns + 2);
                assert!(!brief.chars().any(char::is_control));
            }
        }
        assert_eq!(brief("Ada", 24), "Ada");
        assert_eq!(brief("Ada Lovelace", 8), "Ada Lo..");
    }
}
