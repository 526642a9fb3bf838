//! Writing the files of a command.

use std::path::Path;

use anyhow::anyhow;

use crate::files::{Document, Existing, Unwritten, put};

/// Writes documents, all of them or none; existing files are replaced only with --force.
/// Missing folders are created.
pub(super) fn write(documents: &[Document], force: bool) -> anyhow::Result<()> {
    let existing = if force { Existing::Go } else { Existing::Stay };
    put(documents, existing).map_err(|error| match error {
        Unwritten::There(_) => anyhow!("{error} (--force replaces it)"),
        Unwritten::Failed(..) => error.into(),
    })
}

/// The same for documents in or beside a file that the user has named. Its folder has to
/// exist, so that a typing error does not create one.
pub(super) fn write_beside(
    named: &Path,
    documents: &[Document],
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
