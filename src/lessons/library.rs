//! The chapters there are: those in the program, and a teacher's own.

use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use include_dir::{Dir, include_dir};

use super::Chapter;
use crate::files::{self, FileError};

static EMBEDDED: Dir = include_dir!("$CARGO_MANIFEST_DIR/assets/lessons");

/// How the names of chapters end.
const ENDING: &str = "md";
/// The most chapters that are read from one folder.
const MOST_FILES: usize = 200;

/// All chapters there are to read, in the order of their numbers; the program's own
/// first.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ChapterLibrary {
    /// The chapters; no two have the same id.
    pub chapters: Vec<Chapter>,
    /// What was wrong with files that are left out.
    pub problems: Vec<FileError>,
}

impl ChapterLibrary {
    /// The chapters that come with the program, read once for the whole process, as
    /// they never change.
    pub fn embedded_once() -> &'static Self {
        static READ: LazyLock<ChapterLibrary> = LazyLock::new(ChapterLibrary::embedded);
        &READ
    }

    /// The chapters that come with the program.
    pub fn embedded() -> Self {
        let mut library = Self::default();
        for file in files::embedded(&EMBEDDED, ENDING) {
            library.add(&file.path().display().to_string(), file.contents());
        }
        library
    }

    /// Adds the chapters of a folder. A file that is no good is left out and reported
    /// in [`ChapterLibrary::problems`].
    pub fn add_dir(&mut self, dir: &Path) {
        match files::list(dir, ENDING, MOST_FILES) {
            Ok(list) => {
                list.files.iter().for_each(|file| self.add_file(file));
                self.problems.extend(list.odd);
                let named = |path: &&PathBuf| path.extension().is_some_and(|it| it == ENDING);
                let folders = list.folders.iter().filter(named);
                self.problems
                    .extend(folders.map(|path| files::not_a_file(path)));
            }
            Err(fault) => self.problems.push(fault),
        }
    }

    /// Adds one chapter.
    pub fn add_file(&mut self, path: &Path) {
        match files::read(path, files::LARGEST) {
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

    /// Adds the chapter in the bytes of a file.
    pub fn add(&mut self, file: &str, bytes: &[u8]) {
        let chapter = match Chapter::read(file, bytes) {
            Ok(chapter) => chapter,
            Err(errors) => return self.problems.extend(errors),
        };
        match self.chapters.iter().find(|known| known.id == chapter.id) {
            None => self.chapters.push(chapter),
            Some(known) => {
                let message = format!("expected an id of its own; {} has it already", known.file);
                self.problems.push(FileError::of_file(file, message));
            }
        }
    }
}
