//! Reads sets of questions.

use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;

use super::{Code, Course, CourseKind, Round};
use crate::files::{self, Fields, FileErrors, LARGEST, Source, all, one_line, quoted};
use crate::numbers::{FNV_START, fnv1a};
use crate::quiz::concepts::{self, ChosenQuestion, Library, QuestionSet};
use crate::quiz::families::concept;
use crate::quiz::question::{Dice, Question};

/// The version of the format that this program reads.
const FORMAT: u32 = 1;
/// The maximum number of characters in a title.
const TITLE: usize = 80;
/// The maximum number of characters in a reason.
const REASON: usize = 400;

/// The fields of a question.
const FIELDS: [&str; 4] = ["code", "number", "id", "reason"];

/// The questions of the rounds from which the set has taken questions so far, by the codes of the
/// rounds.
type Rounds = HashMap<String, Vec<Question>>;

impl QuestionSet {
    /// Reads a set from the bytes of its file; `own` are the teacher's own questions.
    ///
    /// # Errors
    /// Returns all errors in the file.
    pub fn read(name: &str, bytes: &[u8], own: &Library) -> Result<Self, FileErrors> {
        let source = Source::of_bytes(name, bytes, LARGEST)?;
        let known = ["format", "title", "question"];
        source.document("a set of questions", FORMAT..=FORMAT, &known, |fields| {
            let title = fields.text("title", TITLE);
            let mut rounds = Rounds::new();
            let mut questions: Vec<Option<ChosenQuestion>> = Vec::new();
            for item in fields.tables("question", 1..=Course::MOST, &FIELDS)? {
                let chosen = chosen(&item, own, &mut rounds).and_then(|chosen| {
                    let is_same = |it: &Question| {
                        (&it.text, &it.figures) == (&chosen.question.text, &chosen.question.figures)
                    };
                    let mut earlier = (1..).zip(questions.iter().flatten());
                    match earlier.find(|(_, it)| is_same(&it.question)) {
                        Some((number, _)) => item.refuse_table(format!(
                            "expected different questions; this is question {number} again"
                        )),
                        None => Some(chosen),
                    }
                });
                questions.push(chosen);
            }
            let (title, questions) = (one_line(title?), all(questions)?);
            let hash = questions.iter().fold(FNV_START, |hash, it| {
                fnv1a(hash, format!("{}\n", it.source).as_bytes())
            });
            Some(Self {
                title,
                questions,
                // The number has to be short enough to type.
                seed: hash & u64::from(u32::MAX),
            })
        })
    }
}

impl Library {
    /// Adds the set in this file. The questions in words that it names by id may come from this
    /// library.
    ///
    /// # Errors
    /// Returns all errors in the file.
    pub fn add_set(&mut self, path: &Path) -> Result<(), FileErrors> {
        let name = path.display().to_string();
        let set = QuestionSet::read(&name, &files::read(path, LARGEST)?, self)?;
        self.sets.push(Arc::new(set));
        Ok(())
    }
}

impl Code {
    /// The code of a set's round.
    pub fn of_set(set: &Arc<QuestionSet>) -> Self {
        Self {
            course: Course::new(CourseKind::Set(Arc::clone(set))),
            seed: set.seed,
        }
    }
}

fn chosen(fields: &Fields, own: &Library, rounds: &mut Rounds) -> Option<ChosenQuestion> {
    let reason = fields.or("reason", None, |name| {
        fields.text(name, REASON).map(|it| Some(one_line(it)))
    });
    let has_id = fields.has("id");
    if has_id && (fields.has("code") || fields.has("number")) {
        return fields.refuse_table("expected a code and a number, or an id; found both");
    }
    let chosen = match has_id {
        true => with_id(fields, own),
        false => with_code(fields, rounds),
    };
    let (question, source, concept) = chosen?;
    Some(ChosenQuestion {
        question,
        source,
        reason: reason?,
        concept,
    })
}

/// A question, its source, and, if it was chosen by an id, the question in words with that id.
type Found = (Question, String, Option<concepts::Concept>);

/// A question of a built-in round.
fn with_code(fields: &Fields, rounds: &mut Rounds) -> Option<Found> {
    let code = fields.text_as("code", |text| {
        let found = || format!("found {}", quoted(text));
        let code = Code::read(text).map_err(|error| format!("{error}; {}", found()))?;
        match code.course.kind {
            CourseKind::Own(_) | CourseKind::Set(_) => Err(format!(
                "expected the code of a built-in round (a question of your own has an id), {}",
                found()
            )),
            _ => code.same_for_all(),
        }
    });
    let Some(code) = code else {
        // Checks the number as far as possible, so that all errors are reported.
        let most = Course::MOST;
        fields.whole("number", &format!("a number from 1 to {most}"), 1..=most);
        return None;
    };
    let name = code.to_string();
    let questions = rounds
        .entry(name.clone())
        .or_insert_with(|| Round::of(code).questions().to_vec());
    let count = questions.len();
    let expected = format!("the number of a question of {name}, 1 to {count}");
    let number = fields.whole("number", &expected, 1..=count)?;
    let question = questions.get(number - 1)?.clone();
    Some((question, format!("{name}, question {number}"), None))
}

/// A question in words, built in or the teacher's own.
fn with_id(fields: &Fields, own: &Library) -> Option<Found> {
    let id = fields.id("id")?;
    let mine = own.concepts.iter().find(|it| it.id == id);
    let Some(concept) = mine.or_else(|| concepts::with_id(id)) else {
        return fields.refuse(
            "id",
            format!(
                "expected the id of a question in words, built in or in a folder given with \
                 --concepts, found {}",
                quoted(id)
            ),
        );
    };
    // The order of the choices does not depend on the other questions of the set.
    let mut dice = Dice::new(fnv1a(FNV_START, id.as_bytes()));
    let question = concept::question(concept, &mut dice)?;
    Some((question, id.to_owned(), Some(concept.clone())))
}
