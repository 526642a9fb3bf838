//! Concept questions: each question asks in words about one idea in glancing collisions, and most
//! wrong choices follow from misconceptions that students are known to have.
//!
//! The questions are data: they are in the files of `assets/concepts/`, one for each subject; a
//! teacher's own questions are in a [`Library`]. `docs/concepts.md` describes the format. Figures
//! that can be calculated are not typed in these files: a text contains, for example,
//! `{theta1_deg}`, and the figure is calculated from the question's own hit while the file is read.

mod check;
mod figures;
mod library;
mod question_set;
mod read;
#[cfg(test)]
mod tests;

use std::sync::LazyLock;

use include_dir::{Dir, include_dir};

use crate::files::{FileError, FileErrors};
use crate::physics::Collision;
use crate::quiz::question::{Difficulty, Family, Misconception, Topic};

pub use check::check;
pub use library::Library;
pub use question_set::{ChosenQuestion, QuestionSet};
pub(crate) use read::read_hit;

static FILES: Dir = include_dir!("$CARGO_MANIFEST_DIR/assets/concepts");

/// The file that fixes the order of the questions.
const ORDER: &str = "order.txt";

/// A concept question, with every figure filled in.
#[derive(Debug, Clone, PartialEq)]
pub struct Concept {
    /// A permanent name: lower-case letters, digits and hyphens.
    pub id: String,
    /// The family that the question belongs to: see [`of`].
    pub family: Family,
    /// The subject, which is the name of the question's file, such as "right-angle".
    pub subject: String,
    /// How hard the question is.
    pub difficulty: Difficulty,
    /// The question, one to three short sentences.
    pub ask: String,
    /// The right choice.
    pub right: String,
    /// The two or three wrong choices; if the question is ordered, they are in their natural order.
    pub wrongs: Vec<Wrong>,
    /// The explanation of the right choice, which is shown after every answer.
    pub why: String,
    /// Whether the choices have a natural order (such as less, the same, more) and so must not be
    /// shuffled.
    pub ordered: bool,
    /// The hit that is shown beside the question and can be watched after the question has been
    /// answered.
    pub hit: Option<Collision>,
    /// The file that contains the question.
    pub file: String,
    /// The first line of the question in that file.
    pub line: usize,
    /// The number of wrong choices that come before the right choice if the choices are not
    /// shuffled.
    before_right: usize,
}

/// A wrong choice.
#[derive(Debug, Clone, PartialEq)]
pub struct Wrong {
    /// The text of the choice.
    pub choice: String,
    /// The misconception that leads to this choice, if there is one.
    pub misconception: Option<Misconception>,
    /// The feedback for this choice, which starts from the idea behind it.
    pub says: String,
}

impl Concept {
    /// The topic of the question, such as "right angle".
    pub fn topic(&self) -> Topic {
        Topic::with_id(self.subject.replace(' ', "-"))
    }

    /// An error in one of the question's fields, with the file and line of the question.
    fn fault(&self, field: &str, message: impl Into<String>) -> FileError {
        FileError {
            file: self.file.clone(),
            line: Some(self.line),
            field: Some(format!("{}.{field}", self.id)),
            message: message.into(),
        }
    }

    /// Whether the error is in this question.
    pub(crate) fn is_at(&self, fault: &FileError) -> bool {
        fault.file == self.file && fault.line == Some(self.line)
    }

    /// All choices; each wrong choice comes with its [`Wrong`]. The choices of an
    /// [ordered](Self::ordered) question are in the order in which they are shown; for any other
    /// question the right choice comes first, and the caller has to shuffle the choices.
    pub fn choices(&self) -> Vec<(&str, Option<&Wrong>)> {
        let wrongs = self.wrongs.iter();
        let mut choices: Vec<_> = wrongs.map(|it| (it.choice.as_str(), Some(it))).collect();
        let place = self.before_right.min(choices.len());
        choices.insert(place, (&self.right, None));
        choices
    }
}

impl Topic {
    /// The families with questions about this topic; none if no built-in question is about it.
    pub fn families(&self) -> Vec<Family> {
        let mut families = self.families_of_figures();
        let written = [Family::Concept, Family::Ideas];
        let asks = |family: &Family| of(*family).iter().any(|it| it.topic() == *self);
        families.extend(written.iter().filter(|family| asks(family)));
        families
    }

    /// The families from which codes such as `read-abd-7` draw questions.
    pub(in crate::quiz) fn families_in_codes(&self) -> Vec<Family> {
        let mut families = self.families();
        // A topic whose only family is `Ideas` keeps it: no older code is about such a topic.
        if families != [Family::Ideas] {
            families.retain(|family| *family != Family::Ideas);
        }
        families
    }
}

/// All concept questions, read once per process.
///
/// Their order is fixed, because the codes of rounds depend on it: new questions are added at the
/// end, in a family that no older code draws from.
pub fn all() -> &'static [Concept] {
    // A test checks that the embedded files have no errors.
    static READ: LazyLock<Vec<Concept>> = LazyLock::new(|| embedded().unwrap_or_default());
    &READ
}

/// The questions in this family, in order: those above the blank line in `order.txt` belong to
/// [`Family::Concept`], those below it to [`Family::Ideas`].
pub fn of(family: Family) -> Vec<&'static Concept> {
    let all = all().iter();
    all.filter(|concept| concept.family == family).collect()
}

/// The question with this `id`.
pub fn with_id(id: &str) -> Option<&'static Concept> {
    all().iter().find(|concept| concept.id == id)
}

/// Reads the embedded files.
///
/// # Errors
/// Returns all errors in the first file that has any.
fn embedded() -> Result<Vec<Concept>, FileErrors> {
    let mut files: Vec<_> = FILES.files().collect();
    files.sort_by_key(|file| file.path());
    let mut concepts: Vec<Concept> = Vec::new();
    let mut order = String::new();
    for file in files {
        let name = file.path().display().to_string();
        match name.strip_suffix(".toml") {
            Some(subject) => read::file(subject, &name, file.contents(), &mut concepts)?,
            None if name == ORDER => order = String::from_utf8_lossy(file.contents()).into(),
            None => return Err(FileError::of_file(&name, "expected a file NAME.toml").into()),
        }
    }
    Ok(in_order(concepts, &order)?)
}

/// The questions in the order in which `order` lists their ids, one per line.
///
/// # Errors
/// Returns an error if `order` lists an unknown id or omits a known one.
fn in_order(mut concepts: Vec<Concept>, order: &str) -> Result<Vec<Concept>, FileError> {
    let mut ordered = Vec::with_capacity(concepts.len());
    let mut family = Family::Concept;
    for (line, id) in (1..).zip(order.lines()) {
        if id.is_empty() {
            family = Family::Ideas;
            continue;
        }
        let fault = || FileError {
            line: Some(line),
            ..FileError::of_file(
                ORDER,
                format!("expected the id of a question not yet listed, found {id}"),
            )
        };
        let at = concepts.iter().position(|concept| concept.id == id);
        let concept = concepts.remove(at.ok_or_else(fault)?);
        ordered.push(Concept { family, ..concept });
    }
    match concepts.first() {
        None => Ok(ordered),
        Some(left) => {
            let message = format!("expected every id; {} is missing at the end", left.id);
            Err(FileError::of_file(ORDER, message))
        }
    }
}
