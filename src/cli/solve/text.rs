//! A worked solution as plain text.

use crate::physics::worked::WorkedStep;
use crate::widgets::{Charset, text};

/// The width to which prose is wrapped, in columns.
const WIDTH: usize = 78;
/// The indentation of prose, and of a line of working.
const PROSE: &str = "   ";
const WORKING: &str = "     ";

/// The numbered steps as text in this charset.
pub(super) fn render(steps: &[WorkedStep], charset: Charset) -> String {
    let step = |(number, step): (usize, &WorkedStep)| {
        let why = text::wrap(&charset.text(&step.why), WIDTH - PROSE.len());
        let why = why.into_iter().filter(|line| !line.is_empty());
        let why: String = why.map(|line| format!("{PROSE}{line}\n")).collect();
        let lines = step.lines.iter().map(|line| charset.text(line));
        let lines: String = lines.map(|line| format!("{WORKING}{line}\n")).collect();
        let gap = match why.is_empty() || lines.is_empty() {
            true => "",
            false => "\n",
        };
        format!("{number}. {}\n{why}{gap}{lines}", step.title)
    };
    let steps: Vec<String> = (1..).zip(steps).map(step).collect();
    steps.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::CollisionSpec;
    use crate::physics::worked;

    #[test]
    fn every_symbol_in_a_solution_has_an_ascii_spelling() {
        let solution = worked::steps(&CollisionSpec::default().collision(), false);
        let written = render(&solution, Charset::Ascii);
        assert!(
            written.is_ascii() && written.starts_with("1. "),
            "{written}"
        );
        let signs = render(&solution, Charset::Unicode).replace('?', "");
        assert!(!Charset::Ascii.text(&signs).contains('?'), "{signs}");
    }
}
