//! `carrom solve`: solves one collision, as a worked solution or as JSON, or many as JSON
//! Lines.

mod answer;
mod args;
mod batch;
mod problem;
mod record;
mod text;

use std::io::{self, BufWriter, Write};
use std::process::ExitCode;

use anyhow::anyhow;

use super::{Failure, GlobalOptions, write_json_line};
use crate::physics::worked::{self, WorkedStep};
use crate::shells::plain::{self, Leave, Talk};
use answer::SolveAnswer;
pub(super) use args::Args;
use batch::BatchError;

/// The size in bytes of the output buffer, which has room for more than a hundred answers.
const BUFFER: usize = 1 << 16;

/// Solves the problem in the arguments, or a batch. A reader that stops early, as `head` does,
/// ends the work quietly; a bad line of a batch is answered with an error and makes the
/// command fail.
pub(super) fn run(args: &Args, options: &GlobalOptions) -> Result<ExitCode, Failure> {
    let mut out = BufWriter::with_capacity(BUFFER, io::stdout().lock());
    let written = if args.batch {
        batch::run(io::stdin().lock(), &mut out)
    } else {
        let text = args.answer(options)?;
        let written = out.write_all(&text).map_err(BatchError::Write);
        written.map(|()| ExitCode::SUCCESS)
    };
    let flushed = |status| out.flush().map(|()| status).map_err(BatchError::Write);
    match written.and_then(flushed) {
        Err(BatchError::Write(error)) if error.kind() == io::ErrorKind::BrokenPipe => {
            // The reader has closed the pipe, so the rest of the buffer is discarded.
            let _ = out.into_parts();
            Ok(ExitCode::SUCCESS)
        }
        written => Ok(written?),
    }
}

/// Prints a worked solution in plain lines; without an impact angle or an offset it asks for
/// the collision first.
pub(super) fn plain(args: &Args) -> Result<(), Failure> {
    let steps = args.is_complete().then(|| args.steps()).transpose()?;
    let (mut input, mut output) = (io::stdin().lock(), io::stdout().lock());
    match plain::solve(&mut Talk::new(&mut input, &mut output), steps) {
        // Quitting early is not a failure.
        Ok(()) | Err(Leave::Ended) => Ok(()),
        Err(Leave::Failed(error)) => Err(anyhow!(error).into()),
    }
}

impl Args {
    /// The worked solution of the problem in the arguments.
    pub(super) fn steps(&self) -> Result<Vec<WorkedStep>, Failure> {
        let solvable = self.solvable()?;
        let mut steps = worked::steps(&solvable.collision, solvable.by_offset);
        if let Some(knowns) = steps.first_mut() {
            knowns.why += &format!(" Assumed: {}.", solvable.assumed.join("; "));
        }
        Ok(steps)
    }

    /// The answer to the problem in the arguments.
    fn answer(&self, options: &GlobalOptions) -> Result<Vec<u8>, Failure> {
        if self.json {
            let mut line = Vec::new();
            write_json_line(&mut line, &SolveAnswer::of(self.solvable()?))?;
            return Ok(line);
        }
        Ok(text::render(&self.steps()?, options.printed()).into_bytes())
    }
}
