//! Questions from files that are not in the program: a teacher's own.

use std::path::Path;

use super::{Concept, read, with_id};
use crate::files::{self, FileError, FileErrors, escape_control};

/// How the names of files of questions end.
const ENDING: &str = "toml";
/// The most files that are read from one folder.
const MOST_FILES: usize = 200;
/// Most letters of a subject, which is the name of a file.
const LONGEST_SUBJECT: usize = 40;

/// Questions read from files, in the order of the files and in them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Library {
    /// The questions; no two have the same id, nor that of one in the program.
    pub concepts: Vec<Concept>,
    /// What was wrong with files that are left out.
    pub problems: Vec<FileError>,
}

impl Library {
    /// The questions in the program.
    pub fn embedded() -> Self {
        let (concepts, problems) = match super::embedded() {
            Ok(concepts) => (concepts, Vec::new()),
            Err(errors) => (Vec::new(), errors.into_iter().collect()),
        };
        Self { concepts, problems }
    }

    /// Adds the questions of a folder. A file that is no good is left out and reported
    /// in [`Library::problems`].
    pub fn add_dir(&mut self, dir: &Path) {
        match files::list(dir, ENDING, MOST_FILES) {
            Ok(list) => list.files.iter().for_each(|file| self.add_file(file)),
            Err(fault) => self.problems.push(fault),
        }
    }

    /// Adds the questions of a file, whose name is their subject.
    pub fn add_file(&mut self, path: &Path) {
        let subject = path.file_stem().map(|stem| stem.to_string_lossy());
        match files::read(path, files::LARGEST) {
            Ok(bytes) => self.add(
                &subject.unwrap_or_default(),
                &path.display().to_string(),
                &bytes,
            ),
            Err(error) => self.problems.push(error),
        }
    }

    /// Adds the questions in the bytes of a file of that subject.
    pub fn add(&mut self, subject: &str, name: &str, bytes: &[u8]) {
        let subject = escape_control(subject, LONGEST_SUBJECT);
        let added = self.add_all(&subject, name, bytes);
        self.problems.extend(added.err().into_iter().flatten());
    }

    /// Adds the questions of a file if all of them are good.
    fn add_all(&mut self, subject: &str, name: &str, bytes: &[u8]) -> Result<(), FileErrors> {
        let mut fresh = Vec::new();
        read::file(subject, name, bytes, &mut fresh)?;
        for concept in &fresh {
            let known = self.concepts.iter().find(|known| known.id == concept.id);
            if let Some(known) = known.or_else(|| with_id(&concept.id)) {
                let message = format!("expected an id of its own; {} has it already", known.file);
                return Err(concept.fault("id", message).into());
            }
        }
        self.concepts.extend(fresh);
        Ok(())
    }
}
