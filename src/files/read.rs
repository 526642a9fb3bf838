//! Reads the bytes of a file, or of standard input.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::FileError;

/// The default limit on the size of a text file, in bytes.
pub(crate) const LARGEST: usize = 1 << 20;

/// The name of standard input in messages.
pub(crate) const STDIN: &str = "standard input";

/// The bytes of a file, cut off one byte beyond `most`, so that `Source::of_bytes` refuses a longer
/// file.
///
/// # Errors
/// Returns an error if the file cannot be read.
pub fn read(path: &Path, most: usize) -> Result<Vec<u8>, FileError> {
    let bytes = File::open(path).and_then(|file| take(file, most));
    bytes.map_err(|error| unreadable(&path.display().to_string(), &error))
}

/// Like [`read`], but `-` is [`STDIN`].
///
/// # Errors
/// Returns an error if the file cannot be read.
pub(crate) fn read_given(path: &Path, most: usize) -> Result<Vec<u8>, FileError> {
    match path.as_os_str() == "-" {
        true => take(io::stdin(), most).map_err(|error| unreadable(STDIN, &error)),
        false => read(path, most),
    }
}

fn take(source: impl Read, most: usize) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let more = (most as u64).saturating_add(1);
    source.take(more).read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn unreadable(name: &str, error: &io::Error) -> FileError {
    FileError::of_file(name, format!("cannot be read: {error}"))
}
