//! `carrom solve`: one collision resolved, as a worked solution, as JSON, or many of
//! them as JSON Lines.

mod answer;
mod args;
mod batch;
mod lines;
mod problem;
mod record;
mod text;

use std::io::{self, BufWriter, Write};
use std::process::ExitCode;

use super::{Failure, GlobalOptions, plain};
use crate::physics::worked;
use crate::widgets::Charset;
use answer::SolveAnswer;
pub(super) use args::Args;
use lines::BatchError;

/// Room for some hundreds of answers.
const BUFFER: usize = 1 << 16;

/// Solves what the arguments say. A reader that hangs up, as `head` does, ends the
/// work quietly; a bad line of a batch is answered as such and counts as failed work.
pub(super) fn run(args: &Args, options: &GlobalOptions) -> Result<ExitCode, Failure> {
    if args.plain {
        return plainly(args);
    }
    let mut out = BufWriter::with_capacity(BUFFER, io::stdout().lock());
    let written = if args.batch {
        batch::run(io::stdin().lock(), &mut out)
    } else {
        let text = one(args, options)?;
        let written = out.write_all(&text).map_err(BatchError::Write);
        written.map(|()| ExitCode::SUCCESS)
    };
    let flushed = |status| out.flush().map(|()| status).map_err(BatchError::Write);
    match written.and_then(flushed) {
        Err(BatchError::Write(error)) if error.kind() == io::ErrorKind::BrokenPipe => {
            // What is left over has nowhere to go.
            let _ = out.into_parts();
            Ok(ExitCode::SUCCESS)
        }
        written => Ok(written?),
    }
}

/// The one problem of the arguments, or one that is asked for, said in lines.
fn plainly(args: &Args) -> Result<ExitCode, Failure> {
    if !args.is_complete() {
        return plain::solve(None);
    }
    let (collision, by_offset) = args
        .collision()
        .map_err(|fault| Failure::Input(fault.into()))?;
    plain::solve(Some(&worked::steps(&collision, by_offset)))
}

/// The one problem of the arguments, answered.
fn one(args: &Args, options: &GlobalOptions) -> Result<Vec<u8>, Failure> {
    let (collision, by_offset) = args
        .collision()
        .map_err(|fault| Failure::Input(fault.into()))?;
    if args.json {
        let mut line = Vec::new();
        SolveAnswer::of(&collision).write_line(&mut line)?;
        return Ok(line);
    }
    let unicode = options.printed() == Charset::Unicode;
    Ok(text::render(&worked::steps(&collision, by_offset), unicode).into_bytes())
}
