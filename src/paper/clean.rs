//! Makes names and titles that come from outside safe to print in one line of a document.

use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

use crate::files::is_invisible;

/// The maximum number of zero-width characters on one letter. A flag made of tags has six.
const MOST_UPON: usize = 6;

/// `text` as one line of at most `columns` columns (a wide letter takes up two), truncated with an
/// ellipsis if it is longer.
///
/// Line breaks, tabs and runs of spaces become one space. Control characters are removed, and so
/// are marks that change the direction of the following text; right-to-left letters stay and are
/// displayed correctly. At most six marks on one letter are kept.
pub fn clean(text: &str, columns: usize) -> String {
    let mut line = String::new();
    let (mut width, mut upon) = (0, 0);
    for letter in text.chars() {
        let letter = if letter.is_whitespace() { ' ' } else { letter };
        let starts = line.is_empty() || line.ends_with(' ');
        if is_invisible(letter) || (letter == ' ' && starts) {
            continue;
        }
        let taken = letter.width().unwrap_or(0);
        upon = if taken == 0 { upon + 1 } else { 0 };
        if upon > MOST_UPON || (taken == 0 && line.is_empty()) {
            continue;
        }
        width += taken;
        if width > columns || line.len() > 16 * columns {
            return cut(line, columns);
        }
        line.push(letter);
    }
    line.truncate(line.trim_end().len());
    // Letters that join may be wider together than separately.
    if line.width() > columns {
        return cut(line, columns);
    }
    line
}

/// `line` truncated so that it fits into `columns` columns with an ellipsis at its end.
fn cut(mut line: String, columns: usize) -> String {
    const JOINER: char = '\u{200d}';
    while line.width() + 1 > columns && line.pop().is_some() {}
    let kept = line.trim_end_matches([' ', JOINER]).len();
    line.truncate(kept);
    line.push('…');
    line
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_names_stay_unchanged() {
        for name in [
            "Ada",
            "Zoë Müller-Łukasiewicz",
            "球 さん",
            "שלום",
            "é",
            "👩‍👩‍👧‍👦",
            "🏴\u{e0067}\u{e0062}\u{e0065}\u{e006e}\u{e0067}\u{e007f}",
            "=1+1",
            "a & b <c> \"d\"",
        ] {
            assert_eq!(clean(name, 40), name);
        }
    }

    #[test]
    fn invisible_characters_are_left_out() {
        assert_eq!(clean(" two\r\n\t lines\u{2028}", 40), "two lines");
        assert_eq!(clean("\u{1b}[2J\u{0}x\u{7f}\u{9b}\u{fffe}", 40), "[2Jx");
        assert_eq!(clean("a\u{202e}b\u{2066}c\u{feff}", 40), "abc");
        assert_eq!(clean("\u{301}\u{200d}a", 40), "a");
        assert_eq!(clean(" \u{200b}\n", 40), "");
    }

    #[test]
    fn long_texts_are_truncated() {
        assert_eq!(clean("Ada Lovelace", 8), "Ada Lov…");
        assert_eq!(clean("Ada Lovelace", 5), "Ada…");
        assert_eq!(clean("Ada Lovelace", 12), "Ada Lovelace");
        for name in [
            "x".repeat(10_000),
            "球".repeat(10_000),
            format!("e{}", "\u{301}".repeat(10_000)),
            "e\u{301}\u{302}".repeat(10_000),
            "👩‍👩‍👧‍👦".repeat(5_000),
            "☺\u{fe0f}".repeat(9),
            "\u{202e}".repeat(10_000),
        ] {
            for columns in [0, 1, 2, 9, 40] {
                let line = clean(&name, columns);
                assert!(line.width() <= columns.max(1), "{columns}: {line:?}");
                assert!(line.chars().count() <= 16 * columns + 1);
            }
        }
    }
}
