//! Wrapping plain text to a width in columns.

use std::time::Duration;

use unicode_segmentation::UnicodeSegmentation;
use unicode_width::UnicodeWidthStr;

use super::terms::held;

/// The width of `text`, in columns.
pub fn width(text: &str) -> usize {
    // Nearly all text is ASCII, for which no table of widths is needed.
    match text.bytes().all(|byte| matches!(byte, b' '..=b'~')) {
        true => text.len(),
        false => text.width(),
    }
}

/// Breaks `text` at spaces into lines of at most `columns` (at least 1). A number stays with its
/// unit, and a word longer than a line is broken at the end of the line. Line breaks are kept, and
/// so are gaps of more than one space, such as those between columns; a line that is too long is
/// broken between two equations if possible.
pub fn wrap(text: &str, columns: usize) -> Vec<String> {
    let columns = columns.max(1);
    let mut lines = Vec::new();
    for paragraph in text.split('\n') {
        let mut line = String::new();
        for (gap, entry) in entries(paragraph) {
            // A name stays with its value, but two equations may be separated.
            let fits = width(&line) + gap + width(entry) <= columns;
            if !fits && line.contains('=') {
                lines.push(std::mem::take(&mut line));
            } else if !line.is_empty() {
                line.extend(std::iter::repeat_n(' ', gap - 1));
            }
            fill(&mut lines, &mut line, entry, columns);
        }
        lines.push(line);
    }
    lines
}

/// Breaks an equation into rows of at most `columns`; rows after the first are shorter by `indent`.
/// The equation is broken after a comma or between two equations if possible, otherwise before an
/// equals sign, otherwise before an operator, starting with the outermost. If none of these is
/// possible, it is broken where [`wrap`] would break it.
pub fn equation(text: &str, columns: usize, indent: usize) -> Vec<String> {
    let mut rows = Vec::new();
    let mut rest = text;
    let mut room = columns;
    while width(rest) > room {
        let Some(at) = equation_break(rest, room) else {
            rows.extend(wrap(rest, room));
            return rows;
        };
        let (row, after) = rest.split_at(at);
        rows.push(row.trim_end().to_owned());
        rest = after.trim_start();
        room = columns.saturating_sub(indent).max(1);
    }
    rows.push(rest.to_owned());
    rows
}

/// The best position at which to break an equation, after at most `columns` columns.
fn equation_break(text: &str, columns: usize) -> Option<usize> {
    // A shorter row would waste too much room.
    const SHORTEST: usize = 12;
    let mut depth = 0_usize;
    let mut best = None;
    for (at, c) in text.char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth = depth.saturating_sub(1),
            _ => {}
        }
        let (before, after) = text.split_at(at);
        if c != ' ' || before.ends_with(' ') {
            continue;
        }
        if width(before) > columns {
            break;
        }
        let long = width(before.trim_start()) >= SHORTEST;
        let rank = match after.split_whitespace().next() {
            _ if depth == 0 && before.ends_with(',') => 0,
            _ if after.starts_with("  ") && before.contains('=') => 0,
            Some("=") if depth == 0 && long => 1,
            Some("+" | "−" | "-" | "/") if long => 2 + depth,
            _ => continue,
        };
        if best.is_none_or(|(least, _)| rank <= least) {
            best = Some((rank, at));
        }
    }
    best.map(|(_, at)| at)
}

/// The entries of text that is arranged in columns, each with the width of the gap before it; a gap
/// has at least two spaces.
fn entries(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut gap = 0;
    text.split("  ").filter_map(move |piece| {
        // If there are three spaces, the third is at the start of the next piece.
        let entry = piece.trim_matches(' ');
        gap += 2 + piece.len() - entry.len();
        let here = (!entry.is_empty()).then_some((gap, entry))?;
        gap = 0;
        Some(here)
    })
}

/// Continues `line` with the words of `text`.
fn fill(lines: &mut Vec<String>, line: &mut String, text: &str, columns: usize) {
    let words: Vec<&str> = text.split(' ').filter(|word| !word.is_empty()).collect();
    for range in held(&words, columns) {
        let word = words.get(range).unwrap_or_default().join(" ");
        let gap = usize::from(!line.is_empty());
        if width(line) + gap + width(&word) > columns && !line.is_empty() {
            lines.push(line.trim_end().to_owned());
            line.clear();
        } else if gap == 1 {
            line.push(' ');
        }
        // A path is broken between its folders rather than within a name.
        for name in word.split_inclusive(['/', '\\']) {
            let fits = width(line) + width(name) <= columns || width(name) > columns;
            if !fits && !line.is_empty() {
                lines.push(std::mem::take(line));
            }
            break_word(lines, line, name, columns);
        }
    }
}

/// Continues `line` with a word; the word is broken if it is too long.
fn break_word(lines: &mut Vec<String>, line: &mut String, word: &str, columns: usize) {
    if width(line) + width(word) <= columns {
        return line.push_str(word);
    }
    for c in word.chars() {
        if width(line) + c.to_string().width() > columns && !line.is_empty() {
            lines.push(std::mem::take(line));
        }
        line.push(c);
    }
}

/// The time since an event, as short text.
pub(crate) fn ago(age: Duration) -> String {
    let minutes = age.as_secs() / 60;
    match minutes {
        0 => "now".into(),
        1..60 => format!("{minutes} min"),
        60..1440 => format!("{} h", minutes / 60),
        1440..2880 => "1 day".into(),
        _ => format!("{} days", minutes / 1440),
    }
}

/// `text` in at most `columns` columns: if it is too long, its beginning followed by "..".
/// Zero-width marks are limited too: there are at most two characters per column.
pub(crate) fn clipped(text: &str, columns: usize) -> String {
    let fits =
        |text: &str, columns| width(text) <= columns && text.chars().nth(2 * columns).is_none();
    if fits(text, columns) {
        return text.to_owned();
    }
    let mut clipped = String::new();
    for letter in text.graphemes(true) {
        if !fits(&format!("{clipped}{letter}"), columns.saturating_sub(2)) {
            break;
        }
        clipped += letter;
    }
    clipped + &".."[..columns.min(2)]
}

/// The positions at which one sentence ends and another begins.
pub(crate) fn sentence_ends(text: &str) -> impl Iterator<Item = usize> + '_ {
    let stops = { text.char_indices() }.filter(|(_, c)| ['.', '!', '?'].contains(c));
    { stops.map(|(at, _)| at + 1) }.filter(|end| {
        let mut next = text[*end..].chars();
        next.next().is_some_and(char::is_whitespace) && next.next().is_some_and(char::is_uppercase)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equations_break_at_readable_positions() {
        for (text, rows) in [
            ("u₁ₜ = 2 m/s", vec!["u₁ₜ = 2 m/s"]),
            (
                "energy before    ½ m₁u₁² + ½ m₂u₂² = 0.12 J",
                vec!["energy before    ½ m₁u₁² + ½ m₂u₂²", "= 0.12 J"],
            ),
            (
                "v₁ = v₁ₙ n + v₁ₜ t = (1.75, 0.433) m/s",
                vec!["v₁ = v₁ₙ n + v₁ₜ t", "= (1.75, 0.433) m/s"],
            ),
            (
                "θ₁ = 13.9° (anticlockwise from u₁), v₁ = 1.803 m/s",
                vec!["θ₁ = 13.9° (anticlockwise from u₁),", "v₁ = 1.803 m/s"],
            ),
            (
                "v₁ₙ = [(m₁ − e m₂) u₁ₙ + (1 + e) m₂ u₂ₙ] / (m₁ + m₂)",
                vec!["v₁ₙ = [(m₁ − e m₂) u₁ₙ", "+ (1 + e) m₂ u₂ₙ] / (m₁ + m₂)"],
            ),
            (
                "  = [(15 − 1 × 15) × 3.464 + 2 × 15 × 0] / 30 = 0 m/s",
                vec!["  = [(15 − 1 × 15) × 3.464", "+ 2 × 15 × 0] / 30 = 0 m/s"],
            ),
            (
                "striker  m₁ = 15 g   u₁ = (40, 0) m/s, speed 40 m/s",
                vec!["striker  m₁ = 15 g", "u₁ = (40, 0) m/s, speed 40 m/s"],
            ),
        ] {
            assert_eq!(equation(text, 37, 4), rows, "{text}");
        }
        let unbroken = equation("one word after another and no sign between", 20, 2);
        assert!(unbroken.iter().all(|row| width(row) <= 20));
    }

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
        // Here no unit follows a number, or the line is too short for both.
        assert_eq!(wrap("1 and m", 5), ["1 and", "m"]);
        assert_eq!(wrap("200 m/s", 5), ["200", "m/s"]);
    }

    #[test]
    fn a_formula_breaks_at_readable_positions() {
        assert_eq!(wrap("and so with Z = 79", 13), ["and so with", "Z = 79"]);
        assert_eq!(wrap("= 3.46 + 2 × 15 × 0", 16), ["= 3.46", "+ 2 × 15 × 0"]);
        assert_eq!(
            wrap("= 3 x 4 along x and y", 15),
            ["= 3 x 4 along x", "and y"]
        );
        assert_eq!(wrap("(1 + e) m₂ u₂ₙ] / m", 10), ["(1 + e) m₂", "u₂ₙ] / m"]);
        assert_eq!(
            wrap("too: 30 mm · sin 45° =", 17),
            ["too:", "30 mm · sin 45° ="]
        );
    }

    #[test]
    fn columns_stay_apart_and_break_between_equations() {
        let known = "target   m₂ = 15 g   u₂ = 0, at rest";
        assert_eq!(wrap(known, 40), [known]);
        assert_eq!(wrap(known, 30), ["target   m₂ = 15 g", "u₂ = 0, at rest"]);
        let impulse = "impulse  J = m₂ (v₂ₙ − u₂ₙ) = 52 g m/s";
        assert_eq!(
            wrap(impulse, 32),
            ["impulse  J = m₂ (v₂ₙ − u₂ₙ)", "= 52 g m/s"]
        );
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
        // A path is broken between its folders if the folders fit.
        assert_eq!(
            wrap("to /home/ada/carrom/game.toml", 12),
            ["to", "/home/ada/", "carrom/", "game.toml"]
        );
        assert_eq!(wrap("x /striking/ab", 6), ["x", "/strik", "ing/ab"]);
    }

    #[test]
    fn no_line_is_ever_too_long() {
        let text = "The striker keeps only its tangential component and leaves along the tangent.";
        for columns in 1..90 {
            assert!(
                wrap(text, columns)
                    .iter()
                    .all(|line| width(line) <= columns)
            );
        }
    }
}
