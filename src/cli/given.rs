//! Files and folders given on the command line.

use std::path::{Path, PathBuf};

use super::{Failure, GlobalOptions, print_text};
use crate::files::{self, FileError, FileErrors, FileLibrary};
use crate::screens::KeptSettings;

/// Reads something from a file's name and bytes.
type ReadNamed<T> = fn(&str, &[u8]) -> Result<T, FileErrors>;

/// Reads a file; `-` is standard input. `read` receives the file's name, for messages, and at most
/// `most` + 1 of its bytes.
pub(super) fn read<T>(path: &Path, most: usize, read: ReadNamed<T>) -> Result<T, Failure> {
    let (name, bytes) = named_bytes(path, most)?;
    read(&name, &bytes).map_err(Failure::input)
}

/// The name of a file, for messages, and at most `most` + 1 of its bytes; `-` is standard input.
pub(super) fn named_bytes(path: &Path, most: usize) -> Result<(String, Vec<u8>), Failure> {
    let bytes = files::read_given(path, most).map_err(Failure::input)?;
    let name = match path.as_os_str() == "-" {
        true => files::STDIN.to_owned(),
        false => path.display().to_string(),
    };
    Ok((name, bytes))
}

/// Reads a file in the data folder; the default if there is no such file.
///
/// # Errors
/// All errors in the file.
pub(super) fn kept<T: Default>(
    path: &Path,
    most: usize,
    read: ReadNamed<T>,
) -> Result<T, FileErrors> {
    if !path.exists() {
        return Ok(T::default());
    }
    read(&path.display().to_string(), &files::read(path, most)?)
}

/// The settings from earlier runs, which are in the data folder.
///
/// # Errors
/// All errors in the file.
pub(super) fn settings(folder: &Path) -> Result<KeptSettings, FileErrors> {
    let path = folder.join(KeptSettings::FILE);
    kept(&path, files::LARGEST, KeptSettings::read)
}

/// A library of the given files and folders, or the built-in library if none are given.
pub(super) fn library<L: FileLibrary>(paths: &[PathBuf]) -> L {
    match paths {
        [] => L::embedded(),
        paths => L::default().with(paths),
    }
}

/// Prints the report of a check. Fails with all errors in the files, or if they contain no `what`.
pub(super) fn conclude(
    report: &str,
    errors: &[FileError],
    (found, what): (usize, &str),
    options: &GlobalOptions,
) -> Result<(), Failure> {
    print_text(report, options)?;
    if !errors.is_empty() {
        let messages: Vec<_> = errors.iter().map(ToString::to_string).collect();
        return Err(Failure::input(messages.join("\n")));
    }
    match found {
        0 => Err(Failure::input(format!("no {what} found"))),
        _ => Ok(()),
    }
}
