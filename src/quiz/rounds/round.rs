//! A round: questions fixed by a code.

use std::mem::discriminant;

use super::{Code, Course, CourseKind, even, find_out, forms, review};
use crate::numbers::{FNV_START, fnv1a};
use crate::quiz::concepts::{self, Concept};
use crate::quiz::families::{concept, where_to};
use crate::quiz::misconceptions::Clue;
use crate::quiz::question::{Answer, Dice, Difficulty, Family, Misconception, Question, Topic};

/// The questions of a round.
///
/// They depend only on the round's [`Code`], which players share, and in some rounds on the answers
/// so far. So the dice, the lists in this file, the numbers that each family draws from and the
/// order of the questions in words must not change; a test pins the text of several rounds. A
/// family that is added later must not change the questions of an existing code: add the family to
/// a new kind of course, or give it a separate topic.
#[derive(Debug, Clone, PartialEq)]
pub struct Round {
    code: Code,
    questions: Vec<Question>,
}

/// The families of mixed rounds: all families in the first version of codes except the first
/// family, which has a separate course. Families that are added later come after these in
/// [`Family::ALL`].
const MIXED: &[Family] = Family::ALL.split_at(17).0.split_at(1).1;

/// The maximum number of draws for a question; the last one is accepted even if it repeats an
/// earlier question.
const REDRAWS: usize = 50;

/// How many questions from the families of mixed rounds are drawn in search of one that can show a
/// misconception. After that the search continues among the questions in words, which together can
/// show every misconception.
const SHOWING_DRAWS: usize = 400;

/// How many questions are drawn in search of a question for another version.
const VERSION_DRAWS: usize = 400;

impl Round {
    /// Creates the round with this code.
    pub fn of(code: Code) -> Self {
        let (course, seed) = (&code.course, code.seed);
        let count = course.count;
        let mut dice = Dice::new(salted(course.kind.id(), seed));
        let questions = match &course.kind {
            CourseKind::Hits => where_to::hits(seed)
                .iter()
                .map(|(difficulty, hit)| Question {
                    difficulty: *difficulty,
                    ..Question::from(hit)
                })
                .collect(),
            CourseKind::Quick | CourseKind::Mixed | CourseKind::Exam => {
                rising(MIXED, count, &mut dice)
            }
            CourseKind::Topic(family) => rising(&[*family], count, &mut dice),
            CourseKind::Read(chapters) => {
                let salt = salted(&format!("{}-{chapters}", course.kind.id()), seed);
                chapters.questions(count, &mut Dice::new(salt))
            }
            CourseKind::Even => even::questions(MIXED, count, &mut dice),
            CourseKind::Before | CourseKind::After => {
                let mut dice = Dice::new(salted(CourseKind::Before.id(), seed));
                let [before, after] = forms::pairs(MIXED, count, &mut dice);
                let is_before = course.kind == CourseKind::Before;
                if is_before { before } else { after }
            }
            CourseKind::FindOut | CourseKind::FindOutFromAny => Vec::new(),
            CourseKind::Check(misconception) => showing(*misconception, count, &mut dice),
            CourseKind::Own(library) => own(&library.concepts, count, &mut dice),
            CourseKind::Set(set) => {
                let chosen = set.questions.iter();
                chosen.map(|it| it.question.clone()).collect()
            }
            CourseKind::Met(topics) => {
                let topics = dice.in_turn(topics, count);
                let asked = review::questions(&topics, Topic::families, &mut dice);
                let mut questions: Vec<Question> = Vec::with_capacity(asked.len());
                for question in asked {
                    if !questions.iter().any(|it| is_same(it, &question)) {
                        questions.push(question);
                    }
                }
                questions
            }
            CourseKind::Review(due) => {
                let topics = &due[..due.len().min(count)];
                review::questions(topics, Topic::families, &mut dice)
            }
        };
        let mut round = Self { code, questions };
        round.go_on(&[]);
        round
    }

    /// Adds the next question after these answers, in a round whose questions depend on the
    /// answers; adds nothing if the answers settle the result.
    pub fn go_on(&mut self, answers: &[Answer]) {
        let Code { course, seed } = &self.code;
        let asked = self.questions.len();
        if !course.follows_answers() || answers.len() < asked || asked >= course.count {
            return;
        }
        let answered = self.questions.iter().zip(answers);
        let [clues, in_codes] = [Clue::new, Clue::in_codes].map(|clue: fn(&_, &_) -> Clue| {
            let clues = answered
                .clone()
                .map(|(question, answer)| clue(question, answer));
            clues.collect::<Vec<_>>()
        });
        if !find_out::is_settled(&clues, &in_codes) {
            // The seed does not depend on how many random numbers were used for the earlier
            // questions.
            let seed = salted(course.kind.id(), *seed).wrapping_add(asked as u64);
            let dice = &mut Dice::new(seed);
            let candidates = match course.kind {
                CourseKind::FindOut if asked == 0 => &find_out::FIRST_CANDIDATES[..],
                _ => &find_out::CANDIDATES,
            };
            let next = find_out::ask(candidates, &self.questions, &in_codes, dice);
            self.questions.extend(next);
        }
    }

    /// Another version of the round, for pupils who sit side by side. As far as possible, each
    /// question has the same topic, difficulty and form, but different numbers; a question in words
    /// is replaced by another question about the same subject, or its choices are in a different
    /// order. Versions are numbered from 1, which is the round itself; the same number always gives
    /// the same version.
    pub fn version(&self, number: u64) -> Self {
        let Code { course, seed } = &self.code;
        if number < 2 {
            return self.clone();
        }
        let name = format!("{}, version {number}", course.kind.id());
        let mut dice = Dice::new(salted(&name, *seed));
        let mut questions: Vec<Question> = Vec::with_capacity(self.questions.len());
        for asked in &self.questions {
            let mut draws = (0..VERSION_DRAWS).filter_map(|draw| self.like(asked, draw, &mut dice));
            let fresh = draws.find(|it| {
                let mut old = self.questions.iter().chain(&questions);
                it.topic == asked.topic
                    && discriminant(&it.form) == discriminant(&asked.form)
                    && !old.any(|other| is_same(it, other))
            });
            questions.push(fresh.unwrap_or_else(|| asked.clone()));
        }
        Self {
            code: self.code.clone(),
            questions,
        }
    }

    /// A question of the same kind as `asked`, which is a question of the round.
    fn like(&self, asked: &Question, draw: usize, dice: &mut Dice) -> Option<Question> {
        if let CourseKind::Own(library) = &self.code.course.kind {
            let id = asked.figures.get("id")?.as_str()?;
            let concept = library.concepts.iter().find(|it| it.id == id)?;
            return concept::question(concept, dice);
        }
        if let CourseKind::Set(set) = &self.code.course.kind {
            let chosen = set.questions.iter().find(|it| it.question == *asked)?;
            if let Some(concept) = &chosen.concept {
                return concept::question(concept, dice);
            }
        }
        // Later draws may have any difficulty, in case no other question of this difficulty fits.
        let difficulty = match draw < VERSION_DRAWS / 2 {
            true => asked.difficulty,
            false => *dice.pick(&Difficulty::ALL)?,
        };
        let (question, _) = asked.family.ask(difficulty, dice)?;
        Some(Question {
            difficulty: asked.difficulty,
            ..question
        })
    }

    /// The code that fixes the round. The code of a review cannot be opened, because a review
    /// belongs to one player.
    pub fn code(&self) -> &Code {
        &self.code
    }

    /// The course of the round.
    pub fn course(&self) -> &Course {
        &self.code.course
    }

    /// The questions of the round, in order.
    pub fn questions(&self) -> &[Question] {
        &self.questions
    }
}

/// Whether two questions have the same text and the same answer.
fn is_same(one: &Question, other: &Question) -> bool {
    (&one.text, &one.form) == (&other.text, &other.form)
}

/// Questions from these families, in random order but with easy questions first. No family is
/// repeated before all families have been used.
fn rising(families: &[Family], count: usize, dice: &mut Dice) -> Vec<Question> {
    let mut questions: Vec<Question> = Vec::with_capacity(count);
    for (i, family) in dice.in_turn(families, count).into_iter().enumerate() {
        let difficulty = Difficulty::rising(i, count);
        let mut fresh = None;
        for _ in 0..REDRAWS {
            fresh = family.ask(difficulty, dice).map(|(asked, _)| asked);
            let old = |it: &Question| Some(&it.text) == fresh.as_ref().map(|it| &it.text);
            if !questions.iter().any(old) {
                break;
            }
        }
        questions.extend(fresh);
    }
    questions
}

/// Questions that can show this misconception, with easy questions first as far as possible.
fn showing(misconception: Misconception, count: usize, dice: &mut Dice) -> Vec<Question> {
    // The code of a misconception still gives the same questions even if the misconception was
    // split later.
    let shows = |question: &Question| {
        let mut beliefs = question.beliefs.iter();
        beliefs.any(|it| it.misconception == misconception || it.in_codes() == Some(misconception))
    };
    let mut questions: Vec<Question> = Vec::with_capacity(count);
    for i in 0..count {
        let first = Difficulty::rising(i, count);
        let is_new = |it: &Question| shows(it) && !questions.iter().any(|old| old.text == it.text);
        let fresh = (0..SHOWING_DRAWS).find_map(|draw| {
            // Later draws may have any difficulty.
            let difficulty = match draw < SHOWING_DRAWS / 2 {
                true => first,
                false => *dice.pick(&Difficulty::ALL)?,
            };
            let (question, _) = dice.pick(MIXED)?.ask(difficulty, dice)?;
            is_new(&question).then_some(question)
        });
        let fresh = fresh.or_else(|| {
            let mut written = concepts::of(Family::Concept);
            dice.shuffle(&mut written);
            // Questions that were written later come last, so that older codes do not change.
            written.extend(concepts::of(Family::Ideas));
            let written = written.into_iter();
            let mut asked = written.filter_map(|it| concept::question(it, dice));
            asked.find(is_new)
        });
        questions.extend(fresh);
    }
    questions
}

/// Questions in words, each of them once, in random order but with easy questions first.
fn own(concepts: &[Concept], count: usize, dice: &mut Dice) -> Vec<Question> {
    let mut concepts: Vec<&Concept> = concepts.iter().collect();
    dice.shuffle(&mut concepts);
    concepts.truncate(count);
    concepts.sort_by_key(|concept| concept.difficulty);
    let questions = concepts.into_iter();
    questions
        .filter_map(|it| concept::question(it, dice))
        .collect()
}

/// Combines the seed with the FNV-1a hash of the name to give each kind of course a separate seed,
/// so that the five questions of a quick round are not the first half of the mixed round with the
/// same seed.
fn salted(id: &str, seed: u64) -> u64 {
    seed ^ fnv1a(FNV_START, id.as_bytes())
}
