//! Lists the files in a folder, or those built into the program.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use include_dir::{Dir, File};

use super::FileError;

/// The contents of a folder, sorted by name.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct List {
    /// The subfolders without this extension.
    pub folders: Vec<PathBuf>,
    /// The plain files with the requested extension. Pipes are not among them, because opening one
    /// would wait for a writer.
    pub files: Vec<PathBuf>,
    /// Errors about anything else with this extension: folders, pipes, devices, broken links.
    pub odd: Vec<FileError>,
}

/// The subfolders of a folder, and its files with the extension `ending` (given without its dot),
/// of which there may be at most `most`.
///
/// # Errors
/// Returns an error if the folder cannot be read, or if it contains more than `most` of these
/// files.
pub fn list(folder: &Path, ending: &str, most: usize) -> Result<List, FileError> {
    let fault = |message| FileError::of_file(&folder.display().to_string(), message);
    let paths = fs::read_dir(folder).and_then(|entries| {
        let paths = entries.map(|entry| Ok(entry?.path()));
        paths.collect::<io::Result<Vec<_>>>()
    });
    let mut paths = paths.map_err(|error| fault(format!("cannot be read: {error}")))?;
    paths.sort();
    let (named, mut folders): (Vec<_>, Vec<_>) =
        paths.into_iter().partition(|path| has_ending(path, ending));
    folders.retain(|path| path.is_dir());
    let (files, odd): (Vec<_>, Vec<_>) = named.into_iter().partition(|path| path.is_file());
    let odd = odd.iter().map(|path| not_a_file(path)).collect();
    if files.len() > most {
        let found = files.len();
        return Err(fault(format!(
            "expected at most {most} files, found {found}"
        )));
    }
    Ok(List {
        folders,
        files,
        odd,
    })
}

/// The files with this extension in a built-in folder, sorted by name.
pub fn embedded<'a>(folder: &'a Dir<'a>, ending: &str) -> Vec<&'a File<'a>> {
    let files = folder.files();
    let mut files: Vec<_> = files
        .filter(|file| has_ending(file.path(), ending))
        .collect();
    files.sort_by_key(|file| file.path());
    files
}

/// The error for something that should be a file but is not.
pub(crate) fn not_a_file(path: &Path) -> FileError {
    let found = match fs::metadata(path) {
        Ok(about) if about.is_dir() => "a folder",
        Ok(_) => "something else",
        Err(_) => "a broken link",
    };
    let message = format!("expected a file, found {found}");
    FileError::of_file(&path.display().to_string(), message)
}

fn has_ending(path: &Path, ending: &str) -> bool {
    path.extension()
        .is_some_and(|extension| extension == ending)
}
