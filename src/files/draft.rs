//! Writes whole files: under a name there is the old file or the new one, never a part.

use std::fs;
use std::io::{self, ErrorKind, Write};
#[cfg(unix)]
use std::os::unix::fs::PermissionsExt;
use std::path::Path;

use tempfile::{Builder, TempPath};

/// How the names of files begin that are not finished, or not yet in their place.
pub(crate) const UNFINISHED: &str = ".new-";

/// A whole file that is not yet in its place: it was brought to the disk beside that
/// place, in the same folder, and is removed again if it is never put there.
#[derive(Debug)]
pub(crate) struct UnplacedFile(TempPath);

impl UnplacedFile {
    /// Writes a text to a file in `folder` that is not there yet, and brings it to the
    /// disk. Whoever may read other new files may read this one: the umask decides.
    ///
    /// # Errors
    /// If it cannot be written as a whole; then nothing of it is left.
    pub(crate) fn write(folder: &Path, text: &str) -> io::Result<Self> {
        Self::write_with_mode(folder, text, 0o666)
    }

    /// The same, and at no moment can anybody else on this computer read it, where files have
    /// such permissions.
    ///
    /// # Errors
    /// As for [`Self::write`].
    pub(crate) fn write_private(folder: &Path, text: &str) -> io::Result<Self> {
        Self::write_with_mode(folder, text, 0o600)
    }

    #[cfg_attr(not(unix), allow(unused_variables, reason = "only Unix has modes"))]
    fn write_with_mode(folder: &Path, text: &str, mode: u32) -> io::Result<Self> {
        let mut builder = Builder::new();
        builder.prefix(UNFINISHED);
        #[cfg(unix)]
        builder.permissions(fs::Permissions::from_mode(mode));
        let mut file = builder.tempfile_in(folder)?;
        file.write_all(text.as_bytes())?;
        file.as_file().sync_all()?;
        Ok(Self(file.into_temp_path()))
    }

    /// Puts it in the place of what is there, if anything is, with the permissions that
    /// had.
    ///
    /// # Errors
    /// If that cannot be done, such as for a folder.
    pub(crate) fn replace(self, path: &Path) -> io::Result<()> {
        if let Ok(old) = fs::metadata(path) {
            fs::set_permissions(&self.0, old.permissions())?;
        }
        self.0.persist(path)?;
        Ok(())
    }

    /// Puts it in a place where nothing is, a link that leads nowhere included; says
    /// `false` if something is.
    ///
    /// # Errors
    /// If that cannot be done.
    pub(crate) fn place(&self, path: &Path) -> io::Result<bool> {
        // A link is refused where there is something; a rename would replace it.
        match fs::hard_link(&self.0, path) {
            // The other name goes when this is dropped.
            Ok(()) => Ok(true),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => Ok(false),
            // Not every file system has links.
            Err(_) if is_there(path) => Ok(false),
            Err(_) => fs::rename(&self.0, path).map(|()| true),
        }
    }
}

/// Whether there is anything of this name, a link that leads nowhere included.
pub(super) fn is_there(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok()
}

/// Brings to the disk which files there are in a folder.
///
/// # Errors
/// If that cannot be done.
pub(crate) fn fsync_dir(folder: &Path) -> io::Result<()> {
    // Only Unix lets a folder be opened; elsewhere the rename has to do.
    #[cfg(unix)]
    fs::File::open(folder)?.sync_all()?;
    #[cfg(not(unix))]
    let _ = folder;
    Ok(())
}
