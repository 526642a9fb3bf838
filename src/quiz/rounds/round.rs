//! A round: questions fixed by a code.

use super::{Code, Course, CourseKind, review};
use crate::numbers::{FNV_START, fnv1a};
use crate::quiz::concepts::Concept;
use crate::quiz::families::{concept, where_to};
use crate::quiz::question::{Dice, Difficulty, Family, Question};

/// The questions of a round.
///
/// They follow from its [`Code`] alone, which players give each other: the dice, the
/// lists of this file, the figures each family draws from and the order of the written
/// questions are all part of the format, and a test pins the text of several rounds. A
/// family that is added later must not change what a code of today brings: it goes into
/// a new kind of course, or into a topic of its own.
#[derive(Debug, Clone, PartialEq)]
pub struct Round {
    code: Code,
    questions: Vec<Question>,
}

/// The families of mixed rounds: all of the first version of codes but the first, which has
/// a course of its own. A family that is added later stands behind them.
const MIXED: &[Family] = Family::ALL.split_at(17).0.split_at(1).1;

/// How often a question that has been asked before is drawn anew before it is asked
/// again.
const REDRAWS: usize = 50;

impl Round {
    /// The round of a course and a seed.
    pub fn new(course: Course, seed: u64) -> Self {
        let questions = match &course.kind {
            CourseKind::Hits => where_to::hits(seed)
                .iter()
                .map(|(difficulty, hit)| Question {
                    difficulty: *difficulty,
                    ..Question::from(hit)
                })
                .collect(),
            CourseKind::Quick | CourseKind::Mixed | CourseKind::Exam => {
                rising(MIXED, &course, seed)
            }
            CourseKind::Topic(family) => rising(&[*family], &course, seed),
            CourseKind::Read(chapters) => {
                let salt = salted(&format!("{}-{chapters}", course.kind.id()), seed);
                chapters.questions(course.count, &mut Dice::new(salt))
            }
            CourseKind::Own(library) => own(&library.concepts, &course, seed),
            CourseKind::Review(due) => {
                let topics = &due[..due.len().min(course.count)];
                review::questions(topics, &mut Dice::new(salted(course.kind.id(), seed)))
            }
        };
        Self {
            code: Code { course, seed },
            questions,
        }
    }

    /// The ten hits of a seed.
    pub fn hits(seed: u64) -> Self {
        Self::new(Course::new(CourseKind::Hits), seed)
    }

    /// The round of a code.
    pub fn of(code: Code) -> Self {
        Self::new(code.course, code.seed)
    }

    /// The code that fixes it; that of a review cannot be read back, for it is its
    /// player's alone.
    pub fn code(&self) -> &Code {
        &self.code
    }

    /// What it is made of.
    pub fn course(&self) -> &Course {
        &self.code.course
    }

    /// Its questions in order.
    pub fn questions(&self) -> &[Question] {
        &self.questions
    }
}

/// Questions of these families in any order, rising in difficulty. No family comes
/// again before all have come.
fn rising(families: &[Family], course: &Course, seed: u64) -> Vec<Question> {
    let mut dice = Dice::new(salted(course.kind.id(), seed));
    let mut order: Vec<Family> = Vec::new();
    while order.len() < course.count && !families.is_empty() {
        let mut all = families.to_vec();
        dice.shuffle(&mut all);
        order.extend(all);
    }
    let mut questions: Vec<Question> = Vec::with_capacity(course.count);
    for (i, family) in order.into_iter().take(course.count).enumerate() {
        let difficulty = Difficulty::rising(i, course.count);
        let mut fresh = None;
        for _ in 0..REDRAWS {
            fresh = family.ask(difficulty, &mut dice).map(|(asked, _)| asked);
            let old = |it: &Question| Some(&it.text) == fresh.as_ref().map(|it| &it.text);
            if !questions.iter().any(old) {
                break;
            }
        }
        questions.extend(fresh);
    }
    questions
}

/// Written questions, each once, rising in difficulty and otherwise in any order.
fn own(concepts: &[Concept], course: &Course, seed: u64) -> Vec<Question> {
    let mut dice = Dice::new(salted(course.kind.id(), seed));
    let mut concepts: Vec<&Concept> = concepts.iter().collect();
    dice.shuffle(&mut concepts);
    concepts.truncate(course.count);
    concepts.sort_by_key(|concept| concept.difficulty);
    let questions = concepts.into_iter();
    questions
        .filter_map(|it| concept::question(it, &mut dice))
        .collect()
}

/// A seed of each kind of course's own, so that the quick five of a seed are not the
/// first half of its mixed ten: the seed and the FNV-1a hash of the name.
fn salted(id: &str, seed: u64) -> u64 {
    seed ^ fnv1a(FNV_START, id.as_bytes())
}
