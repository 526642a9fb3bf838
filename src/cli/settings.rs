//! The settings from earlier runs.

use std::path::Path;

use crate::files::{self, FileErrors};
use crate::screens::KeptSettings;

/// The settings in a file; the defaults if there is no such file.
///
/// # Errors
/// All errors in the file.
pub(super) fn read(path: &Path) -> Result<KeptSettings, FileErrors> {
    if !path.exists() {
        return Ok(KeptSettings::default());
    }
    let bytes = files::read(path, files::LARGEST)?;
    KeptSettings::read(&path.display().to_string(), &bytes)
}
