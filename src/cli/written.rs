//! Files that a command writes.

use anyhow::anyhow;

use crate::files::{Document, Existing, Unwritten, put};

/// Writes documents, all of them or none; those that are there already are replaced with
/// --force alone.
pub(super) fn write(documents: &[Document], force: bool) -> anyhow::Result<()> {
    let existing = if force { Existing::Go } else { Existing::Stay };
    put(documents, existing).map_err(|error| match error {
        Unwritten::There(_) => anyhow!("{error} (--force replaces it)"),
        Unwritten::Failed(..) => error.into(),
    })
}
