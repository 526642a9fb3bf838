//! Texts as files in a folder.

use std::fs::{self, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use super::folder_lock::FolderLock;
use super::text_store::{TextStore, free_names, number};
use crate::files::{self, FileError, UNFINISHED, UnplacedFile, fsync_dir};

/// The lock file for writing to a folder.
pub(super) const LOCK: &str = ".lock";

/// Texts as files in a folder, which is created when the first text is written.
pub(super) struct Disk {
    pub(super) folder: PathBuf,
    /// The suffix of the files' names.
    pub(super) ending: &'static str,
    /// The largest number of bytes that are read from a file.
    pub(super) largest: usize,
    /// Whether only this user can read the files.
    pub(super) private: bool,
}

impl Disk {
    /// Writes a text completely to a temporary file in the folder.
    fn draft(&self, text: &str) -> io::Result<UnplacedFile> {
        UnplacedFile::write(&self.folder, text, self.private)
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.join(format!("{name}{}", self.ending))
    }

    /// Waits for the lock on the folder.
    fn guard(&self) -> io::Result<FolderLock> {
        FolderLock::alone(&self.folder, LOCK)
    }

    /// Removes the temporary files of processes that were killed while writing. The caller must
    /// hold the lock.
    fn clear_up(&self) {
        let entries = fs::read_dir(&self.folder).into_iter().flatten();
        for entry in entries.flatten() {
            if entry.file_name().to_string_lossy().starts_with(UNFINISHED) {
                // A file that cannot be removed only takes up space.
                let _ = fs::remove_file(entry.path());
            }
        }
    }

    /// The names of all plain files with this suffix. Pipes are left out, because opening one would
    /// wait for a writer.
    fn names(&self) -> io::Result<Vec<String>> {
        let entries = match fs::read_dir(&self.folder) {
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Vec::new()),
            entries => entries?,
        };
        let mut names = Vec::new();
        for entry in entries {
            let entry = entry?;
            let file = entry.file_name();
            let name = file
                .to_str()
                .and_then(|name| name.strip_suffix(self.ending));
            if let Some(name) = name
                && !name.starts_with('.')
                && entry.path().is_file()
            {
                names.push(name.to_owned());
            }
        }
        Ok(names)
    }

    fn saved(&self, name: &str) -> Option<SystemTime> {
        fs::metadata(self.path(name)).ok()?.modified().ok()
    }

    /// Runs `act` on the path of a file while the folder is locked. If the file's content is not
    /// `old`, returns `false` and does nothing.
    fn change(
        &self,
        name: &str,
        old: &str,
        act: impl FnOnce(&Path) -> io::Result<()>,
    ) -> Result<bool, String> {
        self.reported(|| {
            let _guard = self.guard()?;
            let path = self.path(name);
            let is_unchanged = holds(&path, old)?;
            if is_unchanged {
                act(&path)?;
            }
            Ok(is_unchanged)
        })
    }

    /// Runs `act`; an error names the folder.
    fn reported<T>(&self, act: impl FnOnce() -> io::Result<T>) -> Result<T, String> {
        act().map_err(|error| format!("{}: {error}", self.folder.display()))
    }
}

impl TextStore for Disk {
    fn names(&self) -> Result<Vec<String>, String> {
        let mut names = self.reported(|| self.names())?;
        names.sort_by_cached_key(|name| (self.saved(name), number(name), name.clone()));
        names.reverse();
        Ok(names)
    }

    fn read(&self, name: &str) -> Result<Vec<u8>, FileError> {
        files::read(&self.path(name), self.largest)
    }

    fn age(&self, name: &str) -> Option<Duration> {
        self.saved(name)?.elapsed().ok()
    }

    fn place(&self, name: &str) -> String {
        self.path(name).display().to_string()
    }

    fn add(&mut self, kind: &str, text: &str) -> Result<String, String> {
        self.reported(|| {
            let guard = self.guard()?;
            if guard.is_certain() {
                self.clear_up();
            }
            let draft = self.draft(text)?;
            let known = self.names()?;
            for name in free_names(known.iter().map(String::as_str), kind) {
                if draft.place(&self.path(&name))? {
                    fsync_dir(&self.folder)?;
                    return Ok(name);
                }
            }
            Err(ErrorKind::AlreadyExists.into())
        })
    }

    fn replace(&mut self, name: &str, old: &str, text: &str) -> Result<bool, String> {
        self.change(name, old, |path| {
            self.draft(text)?.replace(path)?;
            fsync_dir(&self.folder)
        })
    }

    fn append(&mut self, name: &str, old: &str, added: &str) -> Result<bool, String> {
        self.change(name, old, |path| {
            let mut file = OpenOptions::new().append(true).open(path)?;
            let written = file
                .write_all(added.as_bytes())
                .and_then(|()| file.sync_data());
            if written.is_err() {
                // Remove the partial text; otherwise the file would no longer match the text that
                // this store remembers. This works on a full disk too.
                let _ = file.set_len(old.len() as u64);
            }
            written
        })
    }

    fn remove(&mut self, name: &str) -> Result<(), String> {
        self.reported(|| {
            let _guard = self.guard()?;
            match fs::remove_file(self.path(name)) {
                Err(error) if error.kind() == ErrorKind::NotFound => Ok(()),
                removed => removed.and_then(|()| fsync_dir(&self.folder)),
            }
        })
    }
}

/// Whether the path is a plain file with exactly this text.
fn holds(path: &Path, text: &str) -> io::Result<bool> {
    match fs::metadata(path) {
        Ok(about) if about.is_file() && about.len() == text.len() as u64 => {
            Ok(fs::read(path)? == text.as_bytes())
        }
        Err(error) if error.kind() != ErrorKind::NotFound => Err(error),
        _ => Ok(false),
    }
}
