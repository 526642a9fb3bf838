//! Files and folders given on the command line.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::anyhow;

use super::{Failure, GlobalOptions, print_text};
use crate::files::{self, FileError};

/// The name of a file for messages, and its bytes, up to one more than the `most` that
/// may be read; `-` is standard input.
///
/// # Errors
/// If it cannot be read.
pub(super) fn bytes(path: &Path, most: usize) -> Result<(String, Vec<u8>), FileError> {
    if path.as_os_str() == "-" {
        let name = "standard input";
        return Ok((name.into(), files::read_stdin(name, most)?));
    }
    Ok((path.display().to_string(), files::read(path, most)?))
}

/// What is in these files and folders, or without any what is in the program.
pub(super) fn library<L: Default>(
    paths: &[PathBuf],
    embedded: fn() -> L,
    add_file: fn(&mut L, &Path),
    add_dir: fn(&mut L, &Path),
) -> L {
    if paths.is_empty() {
        return embedded();
    }
    let mut library = L::default();
    for path in paths {
        let add = if path.is_dir() { add_dir } else { add_file };
        add(&mut library, path);
    }
    library
}

/// Prints the report of a check, and refuses files that have errors, all of which it
/// tells, or among which no `what` were found.
pub(super) fn conclude(
    report: &str,
    errors: &[FileError],
    (found, what): (usize, &str),
    options: &GlobalOptions,
) -> Result<ExitCode, Failure> {
    print_text(report, options)?;
    if !errors.is_empty() {
        let messages: Vec<_> = errors.iter().map(ToString::to_string).collect();
        return Err(Failure::Input(anyhow!("{}", messages.join("\n"))));
    }
    match found {
        0 => Err(Failure::Input(anyhow!("no {what} found"))),
        _ => Ok(ExitCode::SUCCESS),
    }
}
