//! Writes the files of a command.

use std::path::PathBuf;

use anyhow::anyhow;

use super::{Failure, print_names};
use crate::files::{Document, Existing, Unwritten, put};

/// Writes documents, all of them or none; existing files are replaced only with --force.
/// Missing folders are created.
pub(super) fn write(documents: &[(PathBuf, impl AsRef<[u8]>)], force: bool) -> Result<(), Failure> {
    let existing = if force { Existing::Go } else { Existing::Stay };
    put(documents, existing).map_err(|error| match error {
        Unwritten::There(_) => anyhow!("{error} (--force replaces it)").into(),
        Unwritten::Failed(..) => error.into(),
    })
}

/// Writes documents and prints their names.
pub(super) fn write_named(documents: &[Document], force: bool) -> Result<(), Failure> {
    write(documents, force)?;
    print_names(documents)
}

/// Writes documents. The user has named the first, and the others belong in its folder or in
/// subfolders. That folder has to exist, so that a typo does not create one.
pub(super) fn write_beside<T: AsRef<[u8]>>(
    documents: &[(PathBuf, T)],
    force: bool,
) -> Result<(), Failure> {
    if let Some((named, _)) = documents.first()
        && let Some(folder) = named.parent()
        && !(folder.as_os_str().is_empty() || folder.is_dir())
    {
        let named = named.display();
        return Err(anyhow!("cannot write {named}: its folder does not exist").into());
    }
    write(documents, force)
}

/// Like [`write_beside`], and prints the names of the files.
pub(super) fn write_named_beside<T: AsRef<[u8]>>(
    documents: &[(PathBuf, T)],
    force: bool,
) -> Result<(), Failure> {
    write_beside(documents, force)?;
    print_names(documents)
}

/// A file to write in one of two formats, as determined by its extension.
#[derive(Debug, Clone)]
pub(super) struct NamedFile {
    pub(super) path: PathBuf,
    pub(super) is_second: bool,
}

/// Reads a file name that ends in one of two extensions.
pub(super) fn named_file(path: &str, [first, second]: [&str; 2]) -> Result<NamedFile, String> {
    let path = PathBuf::from(path);
    let ends_in = |ending| {
        path.extension()
            .is_some_and(|it| it.eq_ignore_ascii_case(ending))
    };
    let is_second = ends_in(second);
    match is_second || ends_in(first) {
        true => Ok(NamedFile { path, is_second }),
        false => Err(format!(
            "expected a file name that ends in .{first} or .{second}"
        )),
    }
}
