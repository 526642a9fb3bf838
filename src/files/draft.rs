//! Writes whole files: under a name there is the old file or the new one, never a part.

use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process;

/// How the names of files begin that are not finished, or not yet in their place.
pub const UNFINISHED: &str = ".new-";

/// A whole file that is not yet in its place: it was brought to the disk beside that
/// place, in the same folder, and is removed again if it is never put there.
#[derive(Debug)]
pub struct Draft {
    at: PathBuf,
    placed: bool,
}

impl Draft {
    /// Writes a text to a file in `folder` that is not there yet, and brings it to the
    /// disk.
    ///
    /// # Errors
    /// If it cannot be written as a whole; then nothing of it is left.
    pub fn write(folder: &Path, text: &str) -> io::Result<Self> {
        let mut number = 0;
        let (at, mut file) = loop {
            let at = folder.join(format!("{UNFINISHED}{}-{number}", process::id()));
            match OpenOptions::new().write(true).create_new(true).open(&at) {
                Ok(file) => break (at, file),
                Err(error) if error.kind() == ErrorKind::AlreadyExists => number += 1,
                Err(error) => return Err(error),
            }
        };
        let draft = Self { at, placed: false };
        file.write_all(text.as_bytes())?;
        file.sync_all()?;
        Ok(draft)
    }

    /// Puts it in the place of what is there, if anything is, with the permissions that
    /// had.
    ///
    /// # Errors
    /// If that cannot be done, such as for a folder.
    pub fn replace(mut self, path: &Path) -> io::Result<()> {
        if let Ok(old) = fs::metadata(path) {
            fs::set_permissions(&self.at, old.permissions())?;
        }
        fs::rename(&self.at, path)?;
        self.placed = true;
        Ok(())
    }

    /// Puts it in a place where nothing is, a link that leads nowhere included; says
    /// `false` if something is.
    ///
    /// # Errors
    /// If that cannot be done.
    pub fn place(&mut self, path: &Path) -> io::Result<bool> {
        // A link is refused where there is something; a rename would replace it.
        match fs::hard_link(&self.at, path) {
            // The other name goes when this is dropped.
            Ok(()) => Ok(true),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => Ok(false),
            // Not every file system has links.
            Err(_) if is_there(path) => Ok(false),
            Err(_) => {
                fs::rename(&self.at, path)?;
                self.placed = true;
                Ok(true)
            }
        }
    }
}

impl Drop for Draft {
    fn drop(&mut self) {
        if !self.placed {
            // What cannot be removed takes some room, no more.
            let _ = fs::remove_file(&self.at);
        }
    }
}

/// Whether there is anything of this name, a link that leads nowhere included.
pub fn is_there(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok()
}

/// Brings to the disk which files there are in a folder.
///
/// # Errors
/// If that cannot be done.
pub fn fsync_dir(folder: &Path) -> io::Result<()> {
    // Only Unix lets a folder be opened; elsewhere the rename has to do.
    #[cfg(unix)]
    File::open(folder)?.sync_all()?;
    #[cfg(not(unix))]
    let _ = folder;
    Ok(())
}
