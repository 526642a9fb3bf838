//! Collections read from many files: chapters, packs of levels, and questions.

use std::path::{Path, PathBuf};

use super::{FileError, LARGEST, List, list, read};

/// A collection that is read from files. Invalid files are left out and reported.
pub trait FileLibrary: Default {
    /// The extension of the collection's files.
    const ENDING: &'static str;
    /// The maximum number of these files in one folder; if there are more, none of them is read.
    const MOST_FILES: usize;

    /// The built-in collection.
    fn embedded() -> Self;

    /// The errors found in the files so far.
    fn problems_mut(&mut self) -> &mut Vec<FileError>;

    /// Adds the contents of a file.
    fn add_bytes(&mut self, path: &Path, bytes: &[u8]);

    /// Adds one file.
    fn add_file(&mut self, path: &Path) {
        match read(path, LARGEST) {
            Ok(bytes) => self.add_bytes(path, &bytes),
            Err(fault) => self.problems_mut().push(fault),
        }
    }

    /// Adds the files of a folder, and returns its subfolders.
    fn add_files_of(&mut self, folder: &Path) -> Vec<PathBuf> {
        let list = list(folder, Self::ENDING, Self::MOST_FILES).unwrap_or_else(|fault| {
            self.problems_mut().push(fault);
            List::default()
        });
        list.files.iter().for_each(|file| self.add_file(file));
        self.problems_mut().extend(list.odd);
        list.folders
    }

    /// Adds the files of a folder; an implementation may include its subfolders.
    fn add_dir(&mut self, folder: &Path) {
        self.add_files_of(folder);
    }

    /// The same collection with these folders and files added.
    #[must_use]
    fn with(mut self, paths: &[PathBuf]) -> Self {
        for path in paths {
            match path.is_dir() {
                true => self.add_dir(path),
                false => self.add_file(path),
            }
        }
        self
    }
}
