//! Writes the files of a command.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use anyhow::anyhow;

use super::{Failure, print_names};
use crate::files::{Document, Existing, Unwritten, put};

/// Writes documents, all of them or none; existing files are replaced only with --force.
/// Missing folders are created.
pub(super) fn write<T: AsRef<[u8]>>(documents: &[(PathBuf, T)], force: bool) -> anyhow::Result<()> {
    let existing = if force { Existing::Go } else { Existing::Stay };
    put(documents, existing).map_err(|error| match error {
        Unwritten::There(_) => anyhow!("{error} (--force replaces it)"),
        Unwritten::Failed(..) => error.into(),
    })
}

/// Writes documents and prints their names.
pub(super) fn write_named(documents: &[Document], force: bool) -> Result<(), Failure> {
    write(documents, force)?;
    Ok(print_names(documents)?)
}

/// Writes documents in or beside a file that the user has named. Its folder has to exist, so that a
/// typo does not create one.
pub(super) fn write_beside<T: AsRef<[u8]>>(
    named: &Path,
    documents: &[(PathBuf, T)],
    force: bool,
) -> anyhow::Result<()> {
    let folder = named.parent().filter(|it| !it.as_os_str().is_empty());
    match folder {
        Some(folder) if !folder.is_dir() => Err(anyhow!(
            "cannot write {}: its folder does not exist",
            named.display()
        )),
        _ => write(documents, force),
    }
}

/// Like [`write_beside`], and prints the names of the files.
pub(super) fn write_named_beside<T: AsRef<[u8]>>(
    named: &Path,
    documents: &[(PathBuf, T)],
    force: bool,
) -> Result<(), Failure> {
    write_beside(named, documents, force)?;
    Ok(print_names(documents)?)
}

/// A file to write in one of two formats, as determined by its extension.
#[derive(Debug, Clone)]
pub(super) struct NamedFile {
    pub(super) path: PathBuf,
    pub(super) is_second: bool,
}

/// Reads a file name that ends in one of two extensions.
pub(super) fn named_file(path: &str, endings: [&str; 2]) -> Result<NamedFile, String> {
    let path = PathBuf::from(path);
    let ending = lower_ending(&path);
    let place = endings.iter().position(|it| ending.as_deref() == Some(it));
    let [first, second] = endings;
    match place {
        Some(place) => Ok(NamedFile {
            path,
            is_second: place == 1,
        }),
        None => Err(format!(
            "expected a file name that ends in .{first} or .{second}"
        )),
    }
}

/// The extension of a file name, in lower case.
pub(super) fn lower_ending(path: &Path) -> Option<String> {
    let ending = path.extension().and_then(OsStr::to_str);
    ending.map(str::to_lowercase)
}
