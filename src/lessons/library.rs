//! All available chapters: the built-in chapters and a teacher's own.

use std::path::Path;
use std::sync::LazyLock;

use include_dir::{Dir, include_dir};

use super::Chapter;
use crate::files::{self, FileError, FileLibrary};

static EMBEDDED: Dir = include_dir!("$CARGO_MANIFEST_DIR/assets/lessons");

/// The chapters in the order in which their files are read: the built-in ones, then a teacher's
/// own.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ChapterLibrary {
    /// The chapters; no two have the same id.
    pub chapters: Vec<Chapter>,
    /// The errors in the files that were left out.
    pub problems: Vec<FileError>,
}

impl ChapterLibrary {
    /// The built-in chapters. They never change, so they are read only once per process.
    pub fn embedded_once() -> &'static Self {
        static READ: LazyLock<ChapterLibrary> = LazyLock::new(ChapterLibrary::embedded);
        &READ
    }

    /// The index of the chapter whose id or number is `name`.
    pub fn find(&self, name: &str) -> Option<usize> {
        let by_id = self.chapters.iter().position(|it| it.id == name);
        let number: Option<u32> = name.parse().ok();
        let is_it = |it: &Chapter| Some(it.number) == number;
        by_id.or_else(|| self.chapters.iter().position(is_it))
    }
}

impl FileLibrary for ChapterLibrary {
    const ENDING: &'static str = "md";
    const MOST_FILES: usize = 200;

    fn embedded() -> Self {
        let mut library = Self::default();
        for file in files::embedded(&EMBEDDED, Self::ENDING) {
            library.add_bytes(file.path(), file.contents());
        }
        library
    }

    fn problems_mut(&mut self) -> &mut Vec<FileError> {
        &mut self.problems
    }

    fn add_bytes(&mut self, path: &Path, bytes: &[u8]) {
        let file = path.display().to_string();
        let chapter = match Chapter::read(&file, bytes) {
            Ok(chapter) => chapter,
            Err(errors) => return self.problems.extend(errors),
        };
        match self.chapters.iter().find(|known| known.id == chapter.id) {
            None => self.chapters.push(chapter),
            Some(known) => {
                let message = format!("expected a unique id; {} already has it", known.file);
                self.problems.push(FileError::of_file(&file, message));
            }
        }
    }
}
