//! `carrom solve`: one collision resolved, as a worked solution, as JSON, or many of
//! them as JSON Lines.

mod answer;
mod args;
mod batch;
mod lines;
mod problem;
mod record;
mod text;

use std::io::{self, BufRead, BufWriter, Write};

use crate::cli::Status;
use crate::physics::worked;
use answer::Answer;
pub use args::SolveArgs;
pub use problem::Fault;

/// Why nothing could be solved.
#[derive(Debug, thiserror::Error)]
pub enum SolveError {
    /// An argument is out of range or contradicts another: exit code 2.
    #[error(transparent)]
    Argument(#[from] Fault),
    /// Input could not be read or output not written: exit code 1.
    #[error("cannot read the problems or write the answers: {0}")]
    Io(#[from] io::Error),
}

/// Solves what the arguments say, writing to `out`; `input` is read only by
/// `--batch`, and formulas are spelt in ASCII unless `unicode`.
///
/// A reader that hangs up (as `head` does) ends the work quietly.
///
/// # Errors
///
/// [`SolveError::Argument`] names the argument at fault and what was expected;
/// [`SolveError::Io`] is a failure to read or write. A bad line of a batch is no
/// error: it is answered as such, and the run ends with [`Status::Failed`].
pub fn run(
    args: &SolveArgs,
    unicode: bool,
    input: impl BufRead,
    out: impl Write,
) -> Result<Status, SolveError> {
    let mut out = BufWriter::with_capacity(1 << 16, out);
    let solved = if args.batch {
        batch::run(input, &mut out).map_err(SolveError::Io)
    } else {
        one(args, unicode, &mut out)
    };
    match solved.and_then(|status| Ok(out.flush().map(|()| status)?)) {
        Err(SolveError::Io(error)) if error.kind() == io::ErrorKind::BrokenPipe => Ok(Status::Done),
        ended => ended,
    }
}

fn one(args: &SolveArgs, unicode: bool, out: &mut impl Write) -> Result<Status, SolveError> {
    let (collision, given) = args.problem().collision().map_err(args::as_option)?;
    if args.json {
        Answer::of(&collision).write_line(out)?;
    } else {
        let steps = worked::steps(&collision, given);
        out.write_all(text::render(&steps, unicode).as_bytes())?;
    }
    Ok(Status::Done)
}
