//! Many problems, one per line, answered in order.

use std::fmt::Display;
use std::io::{self, BufReader, Read, Write};
use std::process::ExitCode;

use serde::Serialize;
use thiserror::Error;

use super::answer::SolveAnswer;
use super::problem::Problem;
use crate::cli::write_json_line;
use crate::files::{BYTE_ORDER_MARK, escape_control, read_line};

/// The longest line that is read, in bytes; a typical problem has about a hundred.
const LONGEST: usize = 64 * 1024;

/// The longest error message, in characters, so that invalid input is not repeated in full.
const LONGEST_MESSAGE: usize = 200;

/// An input or output error.
#[derive(Debug, Error)]
pub(super) enum BatchError {
    #[error("cannot read the problems")]
    Read(#[source] io::Error),
    #[error("cannot write to standard output")]
    Write(#[source] io::Error),
}

/// The answer to a line that is not a problem.
#[derive(Debug, Serialize)]
struct RefusedLine {
    line: u64,
    error: String,
}

/// Answers every line of `input` that is not blank. A bad line is answered with an error;
/// the run continues and ends with exit status 1.
pub(super) fn run(input: impl Read, out: &mut impl Write) -> Result<ExitCode, BatchError> {
    let (mut input, mut line) = (BufReader::new(input), Vec::new());
    let mut status = ExitCode::SUCCESS;
    for number in 1.. {
        // Reading may block, so the answers so far are written first.
        if !input.buffer().contains(&b'\n') {
            out.flush().map_err(BatchError::Write)?;
        }
        let answer = match read_line(&mut input, LONGEST, &mut line).map_err(BatchError::Read)? {
            None => break,
            Some(false) => Err(format!("expected a line of at most {LONGEST} bytes")),
            Some(true) => {
                let marked = line.strip_prefix(BYTE_ORDER_MARK).filter(|_| number == 1);
                let text = marked.unwrap_or(&line);
                if text.trim_ascii().is_empty() {
                    continue;
                }
                answer(text)
            }
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
    Ok(SolveAnswer::of(problem.solvable().map_err(said)?))
}

/// A short, plain error message without JSON's line number, which is always 1 here and could be
/// mistaken for the line of the batch.
fn said(error: impl Display) -> String {
    let message = error
        .to_string()
        .replace(" at line 1 column ", " at column ")
        .replace("expected f64", "expected a number");
    escape_control(&message, LONGEST_MESSAGE)
}
