//! A worked solution as plain text.

use std::fmt::Write;

use crate::physics::worked::{WorkedStep, ascii};

/// Columns that prose is wrapped to.
const WIDTH: usize = 78;

/// The steps one below the other, numbered, in the signs the reader can see.
pub(super) fn render(steps: &[WorkedStep], unicode: bool) -> String {
    let mut text = String::new();
    for (count, step) in steps.iter().enumerate() {
        if count > 0 {
            text.push('\n');
        }
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{}. {}", count + 1, step.title);
        let why = if unicode {
            step.why.clone()
        } else {
            ascii(&step.why)
        };
        wrap(&mut text, &why, "   ");
        if !step.why.is_empty() && !step.lines.is_empty() {
            text.push('\n');
        }
        for line in &step.lines {
            let line = if unicode { line.clone() } else { ascii(line) };
            let _ = writeln!(text, "     {line}");
        }
    }
    text
}

fn wrap(text: &mut String, prose: &str, indent: &str) {
    let mut column = 0;
    for word in prose.split_whitespace() {
        let width = word.chars().count();
        if column > 0 && column + 1 + width <= WIDTH {
            text.push(' ');
            column += 1;
        } else {
            if column > 0 {
                text.push('\n');
            }
            text.push_str(indent);
            column = indent.len();
        }
        text.push_str(word);
        column += width;
    }
    if column > 0 {
        text.push('\n');
    }
}
