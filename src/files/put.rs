//! Writes documents to the given paths, and puts them in place only once all are complete.

use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use thiserror::Error;

use super::draft::{UnplacedFile, is_there};

/// The path of a file and its text.
pub type Document = (PathBuf, String);

/// What to do with existing files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Existing {
    /// Keep them and write nothing.
    Stay,
    /// Replace them.
    Go,
}

/// Why documents were not written.
#[derive(Debug, Error)]
pub enum Unwritten {
    /// A file with this name already exists.
    #[error("{} already exists", .0.display())]
    There(PathBuf),
    /// The file cannot be written, or its folder cannot be created.
    #[error("cannot write {}", .0.display())]
    Failed(PathBuf, #[source] io::Error),
}

/// Writes documents, and creates missing folders.
///
/// All of them are written completely before any gets its final name, so if the disk is full,
/// only the previous files remain. Pipes and devices are written to directly; links are followed.
///
/// # Errors
/// Returns an error about the first file that exists and must be kept, or that cannot be written.
pub fn put<T: AsRef<[u8]>>(
    documents: &[(PathBuf, T)],
    existing: Existing,
) -> Result<(), Unwritten> {
    let mut made = Folders::default();
    let mut drafts = Vec::new();
    let mut streams = Vec::new();
    for (path, text) in documents {
        let failed = |error| Unwritten::Failed(path.clone(), error);
        match state(path).map_err(failed)? {
            PathState::Stream => streams.push((path, text)),
            PathState::There if existing == Existing::Stay => {
                return Err(Unwritten::There(path.clone()));
            }
            PathState::There | PathState::Free => {
                // A user who names a link means its target.
                let place = fs::canonicalize(path).unwrap_or_else(|_| path.clone());
                let folder = folder(&place);
                made.make(folder)?;
                drafts.push((
                    UnplacedFile::write(folder, text, false).map_err(failed)?,
                    place,
                ));
            }
        }
    }
    for (path, text) in streams {
        let opened = OpenOptions::new().write(true).open(path);
        let written = opened.and_then(|mut stream| stream.write_all(text.as_ref()));
        written.map_err(|error| Unwritten::Failed(path.clone(), error))?;
    }
    for (draft, place) in drafts {
        let placed = match existing {
            Existing::Stay => draft.place(&place),
            Existing::Go => draft.replace(&place).map(|()| true),
        };
        match placed {
            Ok(true) => made.keep(),
            Ok(false) => return Err(Unwritten::There(place)),
            Err(error) => return Err(Unwritten::Failed(place, error)),
        }
    }
    Ok(())
}

/// What exists at the path of a document.
enum PathState {
    /// Nothing exists there.
    Free,
    /// A file that would have to be replaced.
    There,
    /// A pipe or a device, which is written to directly.
    Stream,
}

fn state(path: &Path) -> io::Result<PathState> {
    match fs::metadata(path) {
        Ok(about) if about.is_dir() => Err(io::Error::other("expected a file, found a folder")),
        Ok(about) if about.is_file() => Ok(PathState::There),
        Ok(_) => Ok(PathState::Stream),
        Err(_) if is_there(path) => Ok(PathState::There),
        Err(_) => Ok(PathState::Free),
    }
}

fn folder(path: &Path) -> &Path {
    let folder = path.parent().filter(|it| !it.as_os_str().is_empty());
    folder.unwrap_or(Path::new("."))
}

/// New folders, which are removed again if no document is put in place.
#[derive(Default)]
struct Folders(Vec<PathBuf>);

impl Folders {
    fn make(&mut self, folder: &Path) -> Result<(), Unwritten> {
        let failed = |at: &Path, error| Err(Unwritten::Failed(at.to_owned(), error));
        let mut missing = Vec::new();
        for above in folder.ancestors() {
            match fs::metadata(above) {
                Ok(about) if about.is_dir() => break,
                _ if above.as_os_str().is_empty() => break,
                Ok(_) => {
                    let what = io::Error::other("expected a folder, found a file");
                    return failed(above, what);
                }
                Err(_) => missing.push(above.to_owned()),
            }
        }
        fs::create_dir_all(folder).or_else(|error| failed(folder, error))?;
        self.0.extend(missing.into_iter().rev());
        Ok(())
    }

    /// Keeps the new folders.
    fn keep(&mut self) {
        self.0.clear();
    }
}

impl Drop for Folders {
    fn drop(&mut self) {
        for folder in self.0.iter().rev() {
            // A folder is kept if another program has put files in it.
            let _ = fs::remove_dir(folder);
        }
    }
}
