//! Questions from files outside the program: a teacher's own questions.

use std::path::Path;
use std::sync::Arc;

use super::{Concept, QuestionSet, read, with_id};
use crate::files::{FileError, FileErrors, FileLibrary, escape_control};

/// The maximum number of characters in a subject, which is the name of a file.
const LONGEST_SUBJECT: usize = 40;

/// Questions read from files, in the order of the files and, within each file, in the order of its
/// questions.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Library {
    /// The questions; no two have the same id, and none that was [added](Self::add) has the id of a
    /// built-in question.
    pub concepts: Vec<Concept>,
    /// The errors in the files that were left out.
    pub problems: Vec<FileError>,
    /// The sets of questions that were opened.
    pub sets: Vec<Arc<QuestionSet>>,
}

impl FileLibrary for Library {
    const ENDING: &'static str = "toml";
    const MOST_FILES: usize = 200;

    fn embedded() -> Self {
        let mut library = Self::default();
        match super::embedded() {
            Ok(concepts) => library.concepts = concepts,
            Err(errors) => library.problems.extend(errors),
        }
        library
    }

    fn problems_mut(&mut self) -> &mut Vec<FileError> {
        &mut self.problems
    }

    fn add_bytes(&mut self, path: &Path, bytes: &[u8]) {
        let subject = path.file_stem().unwrap_or_default().to_string_lossy();
        self.add(&subject, &path.display().to_string(), bytes);
    }
}

impl Library {
    /// Adds the questions in the file `name`, which is about `subject` and contains `bytes`.
    pub fn add(&mut self, subject: &str, name: &str, bytes: &[u8]) {
        let subject = escape_control(subject, LONGEST_SUBJECT);
        let added = self.add_all(&subject, name, bytes);
        self.problems.extend(added.err().into_iter().flatten());
    }

    /// Adds the questions in a file, if all of them are valid.
    fn add_all(&mut self, subject: &str, name: &str, bytes: &[u8]) -> Result<(), FileErrors> {
        let mut fresh = Vec::new();
        read::file(subject, name, bytes, &mut fresh)?;
        for concept in &fresh {
            let known = self.concepts.iter().find(|known| known.id == concept.id);
            if let Some(known) = known.or_else(|| with_id(&concept.id)) {
                let message = format!("expected a unique id; {} already has it", known.file);
                return Err(concept.fault("id", message).into());
            }
        }
        self.concepts.extend(fresh);
        Ok(())
    }
}
