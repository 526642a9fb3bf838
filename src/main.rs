//! The carrom command.

use std::env;
use std::io::{self, Write};
use std::process::ExitCode;

fn main() -> ExitCode {
    carrom::cli::run(env::args_os()).unwrap_or_else(|failure| {
        // Standard error may be gone with its window, and then nobody is left to tell.
        let _ = writeln!(io::stderr(), "carrom: {:#}", failure.error());
        ExitCode::from(failure.status())
    })
}
