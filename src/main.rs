//! The carrom command.

use std::env;
use std::io::{self, Write};
use std::process::ExitCode;

use carrom::files::escape_control_lines;

fn main() -> ExitCode {
    carrom::cli::run(env::args_os()).unwrap_or_else(|failure| {
        // Standard error may have been closed together with the terminal window; then the message
        // cannot be shown.
        let message = format!("{:#}", failure.error());
        let _ = writeln!(io::stderr(), "carrom: {}", escape_control_lines(&message));
        ExitCode::from(failure.status())
    })
}
