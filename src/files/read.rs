//! Reads the bytes of a file.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::Fault;

/// The bytes of a file, up to one more than the `most` that may be read.
///
/// # Errors
/// If it cannot be read.
pub fn read(path: &Path, most: usize) -> Result<Vec<u8>, Fault> {
    take(path, most).map_err(|error| {
        let name = path.display().to_string();
        Fault::of_file(&name, format!("cannot be read: {error}"))
    })
}

fn take(path: &Path, most: usize) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let more = (most as u64).saturating_add(1);
    File::open(path)?.take(more).read_to_end(&mut bytes)?;
    Ok(bytes)
}
