//! The chapters there are: those in the program, and a teacher's own.

use std::fs;
use std::path::Path;
use std::sync::LazyLock;

use include_dir::{Dir, include_dir};

use super::chapter::Chapter;
use crate::levels::{Fault, read_file};

static EMBEDDED: Dir = include_dir!("$CARGO_MANIFEST_DIR/assets/lessons");

/// The most chapters that are read from one folder.
const MOST_FILES: usize = 200;

/// All chapters there are to read, in the order of their numbers; the program's own
/// first.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Library {
    /// The chapters; no two have the same id.
    pub chapters: Vec<Chapter>,
    /// What was wrong with files that are left out.
    pub problems: Vec<Fault>,
}

impl Library {
    /// The chapters that come with the program, read once for the whole process, as
    /// they never change.
    pub fn embedded_once() -> &'static Self {
        static READ: LazyLock<Library> = LazyLock::new(Library::embedded);
        &READ
    }

    /// The chapters that come with the program.
    pub fn embedded() -> Self {
        let mut files: Vec<_> = EMBEDDED.files().collect();
        files.sort_by_key(|file| file.path());
        let mut library = Self::default();
        for file in files
            .into_iter()
            .filter(|file| is_chapter_name(file.path()))
        {
            library.add(&file.path().display().to_string(), file.contents());
        }
        library
    }

    /// Adds the chapters of a folder. A file that is no good is left out and reported
    /// in [`Library::problems`].
    pub fn add_dir(&mut self, dir: &Path) {
        let unreadable = |error: std::io::Error| {
            let name = dir.display().to_string();
            Fault::of_file(&name, format!("cannot be read: {error}"))
        };
        let entries = match fs::read_dir(dir) {
            Ok(entries) => entries,
            Err(error) => return self.problems.push(unreadable(error)),
        };
        let mut paths = Vec::new();
        for entry in entries {
            match entry {
                Ok(entry) => paths.push(entry.path()),
                Err(error) => return self.problems.push(unreadable(error)),
            }
        }
        // Only plain files: opening a pipe would wait for whoever writes to it.
        paths.retain(|path| is_chapter_name(path) && path.is_file());
        paths.sort();
        if paths.len() > MOST_FILES {
            let name = dir.display().to_string();
            let message = format!(
                "expected at most {MOST_FILES} chapters, found {}",
                paths.len()
            );
            return self.problems.push(Fault::of_file(&name, message));
        }
        for path in paths {
            self.add_file(&path);
        }
    }

    /// Adds one chapter.
    pub fn add_file(&mut self, path: &Path) {
        match read_file(path) {
            Ok(bytes) => self.add(&path.display().to_string(), &bytes),
            Err(fault) => self.problems.push(fault),
        }
    }

    /// The place of the chapter called `name`: its id or its number.
    pub fn find(&self, name: &str) -> Option<usize> {
        let by_id = self.chapters.iter().position(|chapter| chapter.id == name);
        let by_number = || {
            let number: u32 = name.parse().ok()?;
            self.chapters
                .iter()
                .position(|chapter| chapter.number == number)
        };
        by_id.or_else(by_number)
    }

    fn add(&mut self, file: &str, bytes: &[u8]) {
        let chapter = match Chapter::read(file, bytes) {
            Ok(chapter) => chapter,
            Err(fault) => return self.problems.push(fault),
        };
        match self.chapters.iter().find(|known| known.id == chapter.id) {
            None => self.chapters.push(chapter),
            Some(known) => {
                let message = format!("expected an id of its own; {} has it already", known.file);
                self.problems.push(Fault::of_file(file, message));
            }
        }
    }
}

fn is_chapter_name(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension == "md")
}
