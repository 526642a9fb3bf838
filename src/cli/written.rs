//! Files that a command writes.

use std::path::Path;

use anyhow::anyhow;

use crate::files::{Document, Existing, Unwritten, put};

/// Writes documents, all of them or none; those that are there already are replaced with
/// --force alone. Folders that are not there are made.
pub(super) fn write(documents: &[Document], force: bool) -> anyhow::Result<()> {
    let existing = if force { Existing::Go } else { Existing::Stay };
    put(documents, existing).map_err(|error| match error {
        Unwritten::There(_) => anyhow!("{error} (--force replaces it)"),
        Unwritten::Failed(..) => error.into(),
    })
}

/// The same for documents in or beside the file that somebody has named, whose folder has
/// to be there: a name mistyped makes none.
pub(super) fn write_beside(
    named: &Path,
    documents: &[Document],
    force: bool,
) -> anyhow::Result<()> {
    let folder = named.parent().filter(|it| !it.as_os_str().is_empty());
    match folder {
        Some(folder) if !folder.is_dir() => Err(anyhow!(
            "cannot write {}: its folder is not there",
            named.display()
        )),
        _ => write(documents, force),
    }
}
