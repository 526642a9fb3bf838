//! Lines of any length from a stream, in bounded memory.

use std::io::{self, BufRead};

use thiserror::Error;

/// The longest line that is kept; a problem takes a few hundred bytes.
pub(super) const LONGEST: usize = 64 * 1024;

/// A line of the input.
pub(super) enum InputLine<'a> {
    /// Its bytes without the line break.
    Whole(&'a [u8]),
    /// It was longer than [`LONGEST`] and was skipped.
    TooLong,
}

/// An input or output error.
#[derive(Debug, Error)]
pub(super) enum BatchError {
    #[error("cannot read the problems")]
    Read(#[source] io::Error),
    #[error("cannot write to standard output")]
    Write(#[source] io::Error),
}

/// Reads one line after another into one buffer.
pub(super) struct LineReader<R> {
    input: R,
    line: Vec<u8>,
    /// Whether everything that has arrived is used up, so that the next read may wait.
    may_wait: bool,
}

impl<R: BufRead> LineReader<R> {
    pub(super) fn new(input: R) -> Self {
        Self {
            input,
            line: Vec::new(),
            may_wait: false,
        }
    }

    /// The next line, or `None` at the end. Calls `before_waiting` before it waits for more
    /// input, so that the answers so far can be sent.
    pub(super) fn next(
        &mut self,
        mut before_waiting: impl FnMut() -> io::Result<()>,
    ) -> Result<Option<InputLine<'_>>, BatchError> {
        self.line.clear();
        let mut too_long = false;
        let mut any = false;
        loop {
            if self.may_wait {
                before_waiting().map_err(BatchError::Write)?;
            }
            let arrived = match self.input.fill_buf() {
                Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
                arrived => arrived.map_err(BatchError::Read)?,
            };
            if arrived.is_empty() {
                break;
            }
            any = true;
            let line_break = arrived.iter().position(|byte| *byte == b'\n');
            let (piece, used) = match line_break {
                Some(end) => (arrived.get(..end).unwrap_or_default(), end + 1),
                None => (arrived, arrived.len()),
            };
            too_long |= self.line.len() + piece.len() > LONGEST;
            if !too_long {
                self.line.extend_from_slice(piece);
            }
            self.may_wait = used == arrived.len();
            self.input.consume(used);
            if line_break.is_some() {
                break;
            }
        }
        Ok(match (any, too_long) {
            (false, _) => None,
            (true, true) => Some(InputLine::TooLong),
            (true, false) => Some(InputLine::Whole(&self.line)),
        })
    }
}
