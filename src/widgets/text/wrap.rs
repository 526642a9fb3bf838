//! Plain text in columns.

use std::ops::Range;
use std::time::Duration;

use unicode_segmentation::UnicodeSegmentation;
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
/// a vector (`(60, 0)`) or of a difference (`90 - 30`), the factors of a product
/// (`2 × 15`, `m₂ u₂`), a sign of equality from what stands on either side, an operator
/// from what follows it, a sine from its angle and its factor.
fn belong_together(before: &str, after: &str) -> bool {
    let minus = ["-", "−"];
    let operators = ["=", "+", "/"];
    let unit = after.trim_end_matches(['.', ',', ';', ':', '?', '!', ')', ']']);
    let number = before
        .trim_end_matches([')', ']'])
        .ends_with(char::is_numeric);
    let measured = number && UNITS.contains(&unit) || before.ends_with('g') && unit == "m/s";
    let vector = before.starts_with('(') && before.ends_with(',') && after.contains(')');
    let difference = number && minus.contains(&after) || minus.contains(&before);
    let is_function = |word: &str| {
        let word = word.trim_start_matches(['(', '-', '−']);
        ["sin", "cos", "tan", "sqrt", "√"].contains(&word)
    };
    let function = is_function(before) || number && is_function(after);
    let equality = after == "=" && is_sign(before);
    let operation = operators.contains(&before);
    measured
        || vector
        || difference
        || function
        || equality
        || operation
        || is_product(before, after)
}

/// Whether a word is a sign of physics, as `α`, that stays with what it equals.
fn is_sign(word: &str) -> bool {
    const LONGEST: usize = 6;
    word.starts_with(char::is_alphabetic)
        && word.ends_with(char::is_alphanumeric)
        && word.chars().count() <= LONGEST
}

/// Whether two words stand beside each other in a product, a times sign being a word.
fn is_product(before: &str, after: &str) -> bool {
    let dots = ["·", "×", "."];
    // In ASCII a times sign is the letter that is also a coordinate.
    let digit_last = before.ends_with(|last: char| last.is_ascii_digit());
    let digit_first = after
        .trim_start_matches(['(', '-'])
        .starts_with(|first: char| first.is_ascii_digit());
    let times = after == "x" && digit_last || before == "x" && digit_first;
    let brackets = ['(', '[', ')', ']'];
    let is_indexed = |word: &str| {
        word.starts_with(char::is_alphabetic) && word.ends_with(char::is_numeric)
            || word.contains(['₁', '₂', '_'])
    };
    let is_letter = |word: &str| word.chars().count() == 1 && word.starts_with(char::is_alphabetic);
    let factor = before.trim_start_matches(brackets);
    let factors =
        (is_indexed(factor) || is_letter(factor)) && is_indexed(after.trim_matches(brackets));
    dots.contains(&before) || dots.contains(&after) || times || factors
}

/// Breaks `text` at spaces into lines of at most `columns` (at least 1); a number
/// keeps its unit beside it, and a word longer than a line is broken where it must
/// be. Line breaks in it are kept, and so are gaps of more than one blank, as between
/// columns: where not all fits, a line breaks first between two equations.
pub fn wrap(text: &str, columns: usize) -> Vec<String> {
    let columns = columns.max(1);
    let mut lines = Vec::new();
    for paragraph in text.split('\n') {
        let mut line = String::new();
        for (gap, entry) in entries(paragraph) {
            // A name stays with what it names; one equation may part from the next.
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

/// Breaks an equation into rows of at most `columns`, those after the first shorter by
/// `indent`: after a comma or between two equations, else before a sign of equality, else
/// before an operator, the outermost first, and only then as [`wrap`] does.
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

/// Where an equation breaks best, with no more than so many columns before.
fn equation_break(text: &str, columns: usize) -> Option<usize> {
    // Less than this would hardly be a row.
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

/// The entries of a text set in columns, each with the width of the gap before it: gaps
/// are of two blanks or more.
fn entries(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut gap = 0;
    text.split("  ").filter_map(move |piece| {
        // Of three blanks the third begins the next piece, or ends this one.
        let entry = piece.trim_matches(' ');
        gap += 2 + piece.len() - entry.len();
        let here = (!entry.is_empty()).then_some((gap, entry))?;
        gap = 0;
        Some(here)
    })
}

/// Goes on from `line` with the words of `text`.
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
        for c in word.chars() {
            if width(line) + c.to_string().width() > columns && !line.is_empty() {
                lines.push(std::mem::take(line));
            }
            line.push(c);
        }
    }
}

/// Words that belong together as one, as ranges of `words`, wherever a row of `columns`
/// has room for them. Rather than anything else a sign is parted from what it equals.
pub fn held<S: AsRef<str>>(words: &[S], columns: usize) -> Vec<Range<usize>> {
    let of = |range: Range<usize>| words.get(range).unwrap_or_default();
    let fits = |range: Range<usize>| {
        let taken: usize = of(range).iter().map(|word| width(word.as_ref()) + 1).sum();
        taken <= columns + 1
    };
    let mut held: Vec<Range<usize>> = Vec::new();
    let mut before = "";
    for (i, word) in words.iter().enumerate() {
        let word = word.as_ref();
        let belongs = i > 0 && belong_together(before, word);
        before = word;
        match held.last_mut() {
            Some(last) if belongs && fits(last.start..i + 1) => last.end = i + 1,
            Some(last) if belongs => {
                let group = of(last.clone()).iter();
                let equality = group.map(AsRef::as_ref).rposition(|word| word == "=");
                let start = equality.map(|at| last.start + at);
                let start = start.filter(|&start| start > last.start && fits(start..i + 1));
                last.end = start.unwrap_or(last.end);
                held.push(start.unwrap_or(i)..i + 1);
            }
            _ => held.push(i..i + 1),
        }
    }
    held
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
    for letter in text.graphemes(true) {
        if width(&clipped) + width(letter) + 2 > columns {
            break;
        }
        clipped += letter;
    }
    clipped + &".."[..columns.min(2)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equations_break_where_they_can_be_read() {
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
        // Words that are no unit, and lines too short for both.
        assert_eq!(wrap("1 and m", 5), ["1 and", "m"]);
        assert_eq!(wrap("200 m/s", 5), ["200", "m/s"]);
    }

    #[test]
    fn a_formula_breaks_where_it_can_be_read() {
        assert_eq!(wrap("and so with Z = 79", 13), ["and so with", "Z = 79"]);
        assert_eq!(wrap("= 3.46 + 2 × 15 × 0", 16), ["= 3.46", "+ 2 × 15 × 0"]);
        assert_eq!(
            wrap("= 3 x 4 along x and y", 15),
            ["= 3 x 4 along x", "and y"]
        );
        assert_eq!(
            wrap("(1 + e) m₂ u₂ₙ] / m", 10),
            ["(1 + e)", "m₂ u₂ₙ]", "/ m"]
        );
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
