//! Many problems, one per line, answered in order.

use std::fmt::Display;
use std::io::{BufRead, Write};
use std::process::ExitCode;

use serde::Serialize;

use super::answer::SolveAnswer;
use super::lines::{BatchError, InputLine, LONGEST, LineReader};
use super::problem::Problem;
use crate::cli::write_json_line;
use crate::files::{BYTE_ORDER_MARK, escape_control};

/// The longest error message, in characters: noise is not echoed at length.
const LONGEST_MESSAGE: usize = 200;

/// The answer to a line that is not a problem.
#[derive(Debug, Serialize)]
struct RefusedLine {
    line: u64,
    error: String,
}

/// Answers every line of `input` that is not blank. A bad line is answered with an error;
/// the run continues and ends with exit status 1.
pub(super) fn run(input: impl BufRead, out: &mut impl Write) -> Result<ExitCode, BatchError> {
    let mut lines = LineReader::new(input);
    let mut status = ExitCode::SUCCESS;
    let mut number = 0;
    while let Some(line) = lines.next(|| out.flush())? {
        number += 1;
        let is_first = number == 1;
        let answer = match line {
            InputLine::Whole(text) => {
                let marked = text.strip_prefix(BYTE_ORDER_MARK).filter(|_| is_first);
                let text = marked.unwrap_or(text);
                if text.trim_ascii().is_empty() {
                    continue;
                }
                answer(text)
            }
            InputLine::TooLong => Err(format!("expected a line of at most {LONGEST} bytes")),
        };
        let written = match answer {
            Ok(answer) => write_json_line(out, &answer),
            Err(error) => {
                status = ExitCode::FAILURE;
                let line = number;
                write_json_line(out, &RefusedLine { line, error })
            }
        };
        written.map_err(BatchError::Write)?;
    }
    Ok(status)
}

fn answer(text: &[u8]) -> Result<SolveAnswer, String> {
    let problem: Problem = serde_json::from_slice(text).map_err(said)?;
    let (collision, _) = problem.collision().map_err(said)?;
    Ok(SolveAnswer::of(&collision))
}

/// A short error message in plain words, without JSON's line number: it is always 1 here
/// and would be mistaken for the line of the batch.
fn said(error: impl Display) -> String {
    let message = error
        .to_string()
        .replace(" at line 1 column ", " at column ")
        .replace("expected f64", "expected a number");
    escape_control(&message, LONGEST_MESSAGE)
}
