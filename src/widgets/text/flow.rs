//! Running text in more than one style, broken into rows.

use std::mem;
use std::ops::Range;

use serde::Serialize;

use crate::lessons::Formula;
use crate::widgets::{Charset, Role, text};

/// A piece of text in a single style. No-break spaces keep words together.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Run {
    /// The text.
    pub text: String,
    /// The style of the text.
    pub role: Role,
    /// The formula that the text represents, if there is one, for screen readers.
    #[serde(skip)]
    pub(crate) formula: Option<Formula>,
}

impl Run {
    /// Creates a piece of text in a single style.
    pub fn new(text: impl Into<String>, role: Role) -> Self {
        Self {
            text: text.into(),
            role,
            formula: None,
        }
    }

    /// Creates a formula on one line, with no-break spaces.
    pub(crate) fn formula(formula: &Formula, role: Role) -> Self {
        Self {
            formula: Some(formula.clone()),
            ..Self::new(formula.inline().replace(' ', "\u{a0}"), role)
        }
    }

    /// This text spelt in a charset, with no-break spaces where lines must not break.
    pub(crate) fn spelt(&self, charset: Charset) -> Self {
        let text = text::unbroken(&charset.text(&self.text));
        Self {
            text,
            ..self.clone()
        }
    }
}

impl<T: Into<String>> From<(T, Role)> for Run {
    fn from((text, role): (T, Role)) -> Self {
        Self::new(text, role)
    }
}

/// A word, made of pieces without a space between them.
type FlowWord = Vec<Run>;

/// Breaks `runs` at spaces into rows of at most `columns` (at least 1), spelt in `charset`. A
/// number stays with its unit, and a word longer than a row is broken at the end of the row.
pub(crate) fn flow(runs: &[Run], columns: usize, charset: Charset) -> Vec<Vec<Run>> {
    let columns = columns.max(1);
    let (mut rows, mut row) = (Vec::new(), Vec::new());
    let mut used = 0;
    let words = words(runs).into_iter();
    let words: Vec<_> = words
        .flat_map(|word| within(word, columns, charset))
        .collect();
    for word in held(&words, columns) {
        let width = width(&word);
        let gap = usize::from(used > 0);
        if used > 0 && used + gap + width > columns {
            rows.push(mem::take(&mut row));
            used = 0;
        } else if gap > 0 {
            let role = word.first().map_or(Role::Text, |run| run.role);
            push(&mut row, " ", role);
            used += 1;
        }
        for run in word {
            for letter in run.text.chars() {
                let letter = letter.to_string();
                let width = text::width(&letter);
                if used > 0 && used + width > columns {
                    rows.push(mem::take(&mut row));
                    used = 0;
                }
                push(&mut row, &letter, run.role);
                used += width;
            }
        }
    }
    rows.push(row);
    rows
}

fn width(word: &FlowWord) -> usize {
    word.iter().map(|run| text::width(&run.text)).sum()
}

/// Joins words that belong together into one word, if it fits into a row.
fn held(words: &[FlowWord], columns: usize) -> Vec<FlowWord> {
    let letters = |word: &FlowWord| word.iter().map(|run| run.text.as_str()).collect::<String>();
    let letters: Vec<String> = words.iter().map(letters).collect();
    let joined = |range: Range<usize>| {
        let mut group = FlowWord::new();
        for word in words.get(range).unwrap_or_default() {
            if let (false, Some(first)) = (group.is_empty(), word.first()) {
                group.push(Run::new(" ", first.role));
            }
            group.extend(word.iter().cloned());
        }
        group
    };
    let held = text::held(&letters, columns);
    held.into_iter().map(joined).collect()
}

fn push(row: &mut Vec<Run>, text: &str, role: Role) {
    match row.last_mut() {
        Some(last) if last.role == role => last.text.push_str(text),
        _ => row.push(Run::new(text, role)),
    }
}

fn words(runs: &[Run]) -> Vec<FlowWord> {
    let mut words: Vec<FlowWord> = vec![Vec::new()];
    for run in runs {
        for (i, part) in run.text.split([' ', '\n']).enumerate() {
            if i > 0 {
                words.push(Vec::new());
            }
            if let Some(word) = words.last_mut()
                && !part.is_empty()
            {
                word.push(Run::new(part, run.role));
            }
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

/// A word in a charset; if the word is too long for a row, its parts between no-break spaces.
fn within(word: FlowWord, columns: usize, charset: Charset) -> Vec<FlowWord> {
    let whole = spelt(word.clone(), charset);
    if width(&whole) <= columns {
        return vec![whole];
    }
    let parted = word.into_iter().map(|run| Run {
        text: run.text.replace('\u{a0}', " "),
        ..run
    });
    let parts = words(&parted.collect::<Vec<_>>()).into_iter();
    parts.map(|part| spelt(part, charset)).collect()
}

/// A word in a charset. In ASCII a degree sign is separated from its number by a space even if they
/// are in different pieces.
fn spelt(word: FlowWord, charset: Charset) -> FlowWord {
    let mut spelt: FlowWord = Vec::new();
    for run in word {
        let after_number = spelt
            .last()
            .is_some_and(|last| last.text.ends_with(|c: char| c.is_ascii_alphanumeric()));
        let mut text = charset.text(&run.text).replace('\u{a0}', " ");
        if charset == Charset::Ascii && run.text.starts_with('°') && after_number {
            text.insert(0, ' ');
        }
        spelt.push(Run { text, ..run });
    }
    spelt
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn rows(runs: &[(&str, Role)], columns: usize, charset: Charset) -> Vec<String> {
        let runs: Vec<_> = runs
            .iter()
            .map(|(text, role)| Run::new(*text, *role))
            .collect();
        let row = |row: Vec<Run>| row.into_iter().map(|run| run.text).collect();
        flow(&runs, columns, charset).into_iter().map(row).collect()
    }

    #[test]
    fn words_in_several_styles_are_not_broken() {
        let runs = [
            ("the ", Role::Text),
            ("line of impact", Role::Title),
            (".", Role::Text),
        ];
        assert_eq!(rows(&runs, 11, Charset::Ascii), ["the line of", "impact."]);
        let runs = [("so ", Role::Text), ("u\u{a0}=\u{a0}1", Role::Title)];
        assert_eq!(rows(&runs, 6, Charset::Unicode), ["so", "u = 1"]);
    }

    #[test]
    fn a_formula_too_long_for_a_row_breaks_between_its_terms() {
        let formula = "tan\u{a0}θ₁\u{a0}=\u{a0}sin\u{a0}Θ\u{a0}/\u{a0}(cos\u{a0}Θ\u{a0}+\u{a0}m₁\u{a0}/\u{a0}m₂)";
        assert_eq!(
            rows(
                &[("so ", Role::Text), (formula, Role::Title)],
                27,
                Charset::Unicode
            ),
            ["so tan θ₁", "= sin Θ / (cos Θ + m₁ / m₂)"]
        );
    }

    #[test]
    fn a_degree_follows_its_number_across_styles() {
        let runs = [("30", Role::Title), ("°.", Role::Text)];
        assert_eq!(rows(&runs, 20, Charset::Ascii), ["30 deg."]);
        assert_eq!(rows(&runs, 20, Charset::Unicode), ["30°."]);
    }

    #[test]
    fn a_number_keeps_its_unit_across_styles() {
        let runs = [
            ("with ", Role::Text),
            ("40", Role::Title),
            (" g m/s.", Role::Text),
        ];
        for columns in 9..14 {
            let broken = rows(&runs, columns, Charset::Ascii);
            assert_eq!(broken, ["with", "40 g m/s."], "{columns}");
        }
        assert_eq!(rows(&runs, 6, Charset::Unicode), ["with", "40 g", "m/s."]);
        let runs = [("here α = ", Role::Text), ("0", Role::Title)];
        assert_eq!(rows(&runs, 9, Charset::Ascii), ["here", "alpha = 0"]);
    }

    proptest! {
        #[test]
        fn no_row_is_too_long(text in "[a-z α°]{0,80}", columns in 1usize..40) {
            for charset in [Charset::Ascii, Charset::Unicode] {
                for row in rows(&[(&text, Role::Text)], columns, charset) {
                    prop_assert!(text::width(&row) <= columns);
                }
            }
        }
    }
}
