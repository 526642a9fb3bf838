//! Concept questions: one idea of glancing collisions each, in words, with choices that
//! somebody is known to believe.
//!
//! They are data: the files of `assets/concepts/`, one a subject, and a teacher's own in a
//! [`Library`]. `docs/concepts.md` describes the format. No figure that physics gives is typed there: a text says
//! `{theta1_deg}`, and the engine fills it in from the question's own hit while the
//! file is read.

mod check;
mod figures;
mod library;
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
pub(crate) use read::read_hit;

static FILES: Dir = include_dir!("$CARGO_MANIFEST_DIR/assets/concepts");

/// The file that says in which order the questions stand.
const ORDER: &str = "order.txt";

/// A concept question, with every figure filled in.
#[derive(Debug, Clone, PartialEq)]
pub struct Concept {
    /// Name that stays the same for good: lower-case letters, digits and hyphens.
    pub id: String,
    /// Which family asks it: see [`of`].
    pub family: Family,
    /// What it is about: the name of its file, as "right-angle".
    pub subject: String,
    /// How hard it is.
    pub difficulty: Difficulty,
    /// The question, one to three short sentences.
    pub ask: String,
    /// The right choice.
    pub right: String,
    /// The wrong choices, two or three; of an ordered question in their order.
    pub wrongs: Vec<Wrong>,
    /// Why it is so, said after any answer.
    pub why: String,
    /// Whether the choices stand in an order of their own, as less, the same, more do,
    /// and are not to be shuffled.
    pub ordered: bool,
    /// A hit that is shown beside the question, and watched after it.
    pub hit: Option<Collision>,
    /// The file it is from.
    pub file: String,
    /// The line it begins at there.
    pub line: usize,
    /// How many of the wrong choices stand before the right one when not shuffled.
    before_right: usize,
}

/// A wrong choice.
#[derive(Debug, Clone, PartialEq)]
pub struct Wrong {
    /// The choice.
    pub choice: String,
    /// The misconception that leads to it, if there is one.
    pub misconception: Option<Misconception>,
    /// The feedback for this choice; begins from what the choice says.
    pub says: String,
}

impl Concept {
    /// What it is about, in words: "right angle".
    pub fn topic(&self) -> Topic {
        Topic::of_subject(&self.subject)
    }

    /// What is wrong with a field of it, with its place.
    fn fault(&self, field: &str, message: impl Into<String>) -> FileError {
        FileError {
            file: self.file.clone(),
            line: Some(self.line),
            field: Some(format!("{}.{field}", self.id)),
            message: message.into(),
        }
    }

    /// Whether a fault is one of this question.
    pub(crate) fn is_at(&self, fault: &FileError) -> bool {
        fault.file == self.file && fault.line == Some(self.line)
    }

    /// All choices, each with what makes it a wrong one. Those of an
    /// [ordered](Self::ordered) question stand as they are to be shown; of any other the
    /// right one is first, and they have to be shuffled.
    pub fn choices(&self) -> Vec<(&str, Option<&Wrong>)> {
        let wrongs = self.wrongs.iter();
        let mut choices: Vec<_> = wrongs.map(|it| (it.choice.as_str(), Some(it))).collect();
        let place = self.before_right.min(choices.len());
        choices.insert(place, (&self.right, None));
        choices
    }
}

impl Topic {
    /// The families that ask about it; none where nothing in the program does.
    pub fn families(&self) -> Vec<Family> {
        let mut families = self.families_of_figures();
        let written = [Family::Concept, Family::Ideas];
        let asks = |family: &Family| of(*family).iter().any(|it| it.topic() == *self);
        families.extend(written.iter().filter(|family| asks(family)));
        families
    }

    /// Those that codes such as `read-abd-7` draw from.
    pub(in crate::quiz) fn families_in_codes(&self) -> Vec<Family> {
        let mut families = self.families();
        families.retain(|family| *family != Family::Ideas);
        families
    }
}

/// All concept questions, read once for the whole process.
///
/// Their order is fixed, for it is part of what the code of a round stands for: new
/// questions go to the end, into a family that no older code draws from.
pub fn all() -> &'static [Concept] {
    // A test holds that nothing is wrong with the files in the program.
    static READ: LazyLock<Vec<Concept>> = LazyLock::new(|| embedded().unwrap_or_default());
    &READ
}

/// The questions that a family asks, in their order: those before the empty line of
/// `order.txt` are [`Family::Concept`], those behind it [`Family::Ideas`].
pub fn of(family: Family) -> Vec<&'static Concept> {
    let all = all().iter();
    all.filter(|concept| concept.family == family).collect()
}

/// The question of an `id`.
pub fn with_id(id: &str) -> Option<&'static Concept> {
    all().iter().find(|concept| concept.id == id)
}

/// Reads the files in the program.
///
/// # Errors
/// All that is wrong with the first file with which anything is.
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

/// The questions as `order` lists their ids, one a line.
///
/// # Errors
/// If it names one that is not there, or leaves one out.
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
                format!("expected the id of a question, once, found {id}"),
            )
        };
        let at = concepts.iter().position(|concept| concept.id == id);
        let concept = concepts.remove(at.ok_or_else(fault)?);
        ordered.push(Concept { family, ..concept });
    }
    match concepts.first() {
        None => Ok(ordered),
        Some(left) => {
            let message = format!("expected every id, {} is missing at the end", left.id);
            Err(FileError::of_file(ORDER, message))
        }
    }
}
