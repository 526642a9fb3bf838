//! Plain text in columns.

use std::time::Duration;

use unicode_width::UnicodeWidthStr;

/// Columns that `text` takes.
pub fn width(text: &str) -> usize {
    text.width()
}

/// Units as a text has them in either charset.
const UNITS: [&str; 21] = [
    "g", "kg", "m", "mm", "cm", "fm", "nm", "µm", "um", "mm²", "mm^2", "m/s", "s", "J", "mJ", "eV",
    "keV", "MeV", "deg", "%", "turns",
];

/// Whether a blank between two words is no place to break a row: it parts a number
/// from its unit (`2 m/s`), a unit from the rest of it (`g m/s`), the two numbers of
/// a vector (`(60, 0)`) or of a difference (`90 - 30`), a sign of equality from what
/// it equals, a sine from its angle.
pub fn belong_together(before: &str, after: &str) -> bool {
    let minus = ["-", "−"];
    let unit = after.trim_end_matches(['.', ',', ';', ':', '?', '!', ')', ']']);
    let number = before
        .trim_end_matches([')', ']'])
        .ends_with(char::is_numeric);
    let measured = number && UNITS.contains(&unit) || before.ends_with('g') && unit == "m/s";
    let vector = before.starts_with('(') && before.ends_with(',') && after.contains(')');
    let difference = number && minus.contains(&after) || minus.contains(&before);
    let function = before.trim_start_matches(['(', '-', '−']);
    let function = ["sin", "cos", "tan"].contains(&function);
    measured || vector || difference || function || before == "="
}

/// Breaks `text` at spaces into lines of at most `columns` (at least 1); a number
/// keeps its unit beside it, and a word longer than a line is broken where it must
/// be. Line breaks in it are kept.
pub fn wrap(text: &str, columns: usize) -> Vec<String> {
    let columns = columns.max(1);
    let mut lines = Vec::new();
    for paragraph in text.split('\n') {
        let mut line = String::new();
        for word in held(paragraph, columns) {
            let word = word.as_str();
            let gap = usize::from(!line.is_empty());
            if width(&line) + gap + width(word) > columns && !line.is_empty() {
                lines.push(std::mem::take(&mut line));
            } else if gap == 1 {
                line.push(' ');
            }
            for c in word.chars() {
                if width(&line) + c.to_string().width() > columns && !line.is_empty() {
                    lines.push(std::mem::take(&mut line));
                }
                line.push(c);
            }
        }
        lines.push(line);
    }
    lines
}

/// The words of `text`; those that belong together are one, if a line has room for it.
fn held(text: &str, columns: usize) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut before = "";
    for word in text.split(' ').filter(|word| !word.is_empty()) {
        match words.last_mut() {
            Some(last)
                if belong_together(before, word) && width(last) + 1 + width(word) <= columns =>
            {
                last.push(' ');
                last.push_str(word);
            }
            _ => words.push(word.to_owned()),
        }
        before = word;
    }
    words
}

/// A time that has passed, in few letters.
pub fn ago(age: Duration) -> String {
    let minutes = age.as_secs() / 60;
    match minutes {
        0 => "now".into(),
        1..60 => format!("{minutes} min"),
        60..1440 => format!("{} h", minutes / 60),
        1440..2880 => "1 day".into(),
        _ => format!("{} days", minutes / 1440),
    }
}

/// The beginning of a text, in at most so many columns; what is cut off is told by dots.
pub fn clipped(text: &str, columns: usize) -> String {
    if width(text) <= columns {
        return text.to_owned();
    }
    let mut clipped = String::new();
    for c in text.chars() {
        if width(&clipped) + c.to_string().width() + 2 > columns {
            break;
        }
        clipped.push(c);
    }
    clipped + &".."[..columns.min(2)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_break_at_spaces() {
        assert_eq!(wrap("one two three", 8), ["one two", "three"]);
        assert_eq!(wrap("one two three", 7), ["one two", "three"]);
        assert_eq!(wrap("", 7), [""]);
        assert_eq!(wrap("a\n\nb", 7), ["a", "", "b"]);
    }

    #[test]
    fn a_number_keeps_its_unit() {
        assert_eq!(wrap("it has 2 m/s, so", 8), ["it has", "2 m/s,", "so"]);
        assert_eq!(wrap("has 60 g m/s.", 9), ["has", "60 g m/s."]);
        assert_eq!(wrap("at (30 deg)", 9), ["at", "(30 deg)"]);
        assert_eq!(
            wrap("at last (60, 0) g m/s", 14),
            ["at last", "(60, 0) g m/s"]
        );
        assert_eq!(wrap("at 90 - 30 = 60", 10), ["at 90 - 30", "= 60"]);
        assert_eq!(wrap("n = (-sin α, 1)", 10), ["n", "= (-sin α,", "1)"]);
        assert_eq!(wrap("½ m₁u₁² = 0.12 J", 10), ["½ m₁u₁²", "= 0.12 J"]);
        // Words that are no unit, and lines too short for both.
        assert_eq!(wrap("1 and m", 5), ["1 and", "m"]);
        assert_eq!(wrap("200 m/s", 5), ["200", "m/s"]);
    }

    #[test]
    fn a_text_is_clipped_to_its_columns() {
        assert_eq!(clipped("ants", 4), "ants");
        assert_eq!(clipped("anteaters", 6), "ante..");
        for columns in 0..9 {
            assert!(width(&clipped("蟻蟻蟻蟻蟻", columns)) <= columns);
        }
    }

    #[test]
    fn a_word_longer_than_a_line_is_broken() {
        assert_eq!(wrap("a striking", 5), ["a", "strik", "ing"]);
    }

    #[test]
    fn no_line_is_ever_too_long() {
        let text = "The striker keeps only its sideways part, so it leaves square to the coin.";
        for columns in 1..90 {
            assert!(
                wrap(text, columns)
                    .iter()
                    .all(|line| width(line) <= columns)
            );
        }
    }
}
