//! The settings of former runs.

use std::path::Path;

use crate::files::{self, FileErrors};
use crate::screens::KeptSettings;

/// What is kept of the settings in a file; nothing where there is no such file.
///
/// # Errors
/// All that is wrong with the file.
pub(super) fn read(path: &Path) -> Result<KeptSettings, FileErrors> {
    if !path.exists() {
        return Ok(KeptSettings::default());
    }
    let bytes = files::read(path, files::LARGEST)?;
    KeptSettings::read(&path.display().to_string(), &bytes)
}
