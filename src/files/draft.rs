//! Writes files atomically: a name always refers to the whole old file or the whole new one.

use std::fs;
use std::io::{self, ErrorKind, Write};
#[cfg(unix)]
use std::os::unix::fs::PermissionsExt;
use std::path::Path;

use tempfile::{Builder, TempPath};

/// The prefix for the names of unfinished files.
pub(crate) const UNFINISHED: &str = ".new-";

/// A complete file under a temporary name, in the folder of its final name. It has been synced to
/// the disk, and is removed if it is never renamed.
#[derive(Debug)]
pub(crate) struct UnplacedFile(TempPath);

impl UnplacedFile {
    /// Writes text to a new file in `folder`, and syncs it to the disk. If it is `private` and the
    /// system has file permissions, it is created so that only this user can read it; otherwise the
    /// umask decides.
    ///
    /// # Errors
    /// Returns an error if the file cannot be written completely; it is then removed.
    #[cfg_attr(not(unix), allow(unused_variables, reason = "only Unix has modes"))]
    pub(crate) fn write(
        folder: &Path,
        content: impl AsRef<[u8]>,
        private: bool,
    ) -> io::Result<Self> {
        let mut builder = Builder::new();
        builder.prefix(UNFINISHED);
        #[cfg(unix)]
        builder.permissions(fs::Permissions::from_mode(if private {
            0o600
        } else {
            0o666
        }));
        let mut file = builder.tempfile_in(folder)?;
        file.write_all(content.as_ref())?;
        file.as_file().sync_all()?;
        Ok(Self(file.into_temp_path()))
    }

    /// Moves the file to `path`; if a file exists there, replaces that file and keeps its
    /// permissions.
    ///
    /// # Errors
    /// Returns an error if the file cannot be moved, for example because there is a folder at
    /// `path`.
    pub(crate) fn replace(self, path: &Path) -> io::Result<()> {
        if let Ok(old) = fs::metadata(path) {
            fs::set_permissions(&self.0, old.permissions())?;
        }
        self.0.persist(path)?;
        Ok(())
    }

    /// Renames the file to `path` if nothing has that name; returns `false` if anything has it,
    /// even a broken link.
    ///
    /// # Errors
    /// Returns an error if the file cannot be renamed.
    pub(crate) fn place(&self, path: &Path) -> io::Result<bool> {
        // A hard link fails if the name exists; a rename would replace it.
        match fs::hard_link(&self.0, path) {
            // The temporary name is removed when `self` is dropped.
            Ok(()) => Ok(true),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => Ok(false),
            // Not every file system supports hard links.
            Err(_) if is_there(path) => Ok(false),
            Err(_) => fs::rename(&self.0, path).map(|()| true),
        }
    }
}

/// Whether anything has this name, even a broken link.
pub(super) fn is_there(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok()
}

/// Syncs the entries of a folder to the disk.
///
/// # Errors
/// Returns an error if the entries cannot be synced.
pub(crate) fn fsync_dir(folder: &Path) -> io::Result<()> {
    // `File::open` opens a folder only on Unix; elsewhere the rename has to be enough.
    #[cfg(unix)]
    fs::File::open(folder)?.sync_all()?;
    #[cfg(not(unix))]
    let _ = folder;
    Ok(())
}
