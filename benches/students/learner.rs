//! Learners who follow the path from an empty record. Pages and explanations teach them; their
//! answers and stars are kept in the program's own types.

use std::collections::{BTreeMap, BTreeSet};

use carrom::lessons::{Book, Bookmark, GivenAnswer};
use carrom::levels::{Shelf, Starred};
use carrom::path::{NextStep, PathDone, PathSoFar, Step};
use carrom::progress::{Attempt, Calendar};
use carrom::quiz::{Code, Course, Grade, Response, Round};
use carrom::screens::learn;
use rand::RngExt;

use crate::students::{Belief, Student};

const DAY_S: i64 = 86_400;
/// The time at which learners begin, in seconds since the start of 1970.
const START_S: i64 = 1_800_000_000;
/// The duration of a step, in seconds.
const STEP_S: i64 = 900;
/// How many steps learners take per day.
const STEPS_A_DAY: usize = 6;
/// The probability that the page about a misconception corrects it.
const CONVINCED: f64 = 0.7;
/// The probability that an explanation teaches its topic.
const EXPLAINED: f64 = 0.5;
/// The probability that a learner knows something that was not taught.
const KNOWN: f64 = 0.4;
/// The probability that a learner answers a question of a chapter correctly.
const ANSWERED: f64 = 0.8;
/// The probability that a learner reads a chapter to its end without a break.
const READ_AT_ONCE: f64 = 0.7;

/// How a learner uses the path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Habit {
    /// Follows every step.
    Follows,
    /// Follows every step, but pauses for a week after ten steps.
    Pauses,
    /// Plays levels, whatever the next step is.
    OnlyPlays,
}

pub(crate) struct Learner {
    student: Student,
    habit: Habit,
    attempts: Vec<Attempt>,
    book: Book,
    shelf: Shelf,
    /// The topics that were explained, the chapters that were read, and "convinced" once a
    /// misconception has been corrected.
    taught: BTreeSet<String>,
    time_s: i64,
    /// All steps so far.
    pub(crate) steps: Vec<Step>,
}

impl Learner {
    pub(crate) fn new(belief: Belief, habit: Habit, seed: u64) -> Self {
        Self {
            student: Student::new(belief, false, seed),
            habit,
            attempts: Vec::new(),
            book: Book::default(),
            shelf: Shelf::default(),
            taught: BTreeSet::new(),
            time_s: START_S,
            steps: Vec::new(),
        }
    }

    fn so_far<T>(&self, ask: impl Fn(&PathSoFar) -> T) -> T {
        let calendar = Calendar::utc(Some(self.time_s));
        ask(&PathSoFar {
            attempts: &self.attempts,
            calendar: &calendar,
            book: &self.book,
            shelf: &self.shelf,
        })
    }

    pub(crate) fn next(&self) -> NextStep {
        self.so_far(|it| it.next_step())
    }

    pub(crate) fn done(&self) -> PathDone {
        self.so_far(|it| it.done())
    }

    /// The number of questions answered, in the quiz and in chapters.
    pub(crate) fn answered(&self) -> usize {
        self.attempts.len()
    }

    /// The number of days that have passed.
    pub(crate) fn days(&self) -> i64 {
        (self.time_s - START_S) / DAY_S
    }

    /// Whether all chapters are done or known, and no misconception is left.
    pub(crate) fn has_arrived(&self) -> bool {
        let PathDone {
            chapters, beliefs, ..
        } = self.done();
        chapters.0 == chapters.1 && beliefs.0 == beliefs.1
    }

    fn chance(&mut self, p: f64) -> bool {
        self.student.dice.random::<f64>() < p
    }

    pub(crate) fn take_step(&mut self) {
        let step = match self.habit {
            Habit::OnlyPlays => self.shelf.next().map_or(Step::Table, Step::Level),
            _ => self.next().step,
        };
        self.steps.push(step.clone());
        match &step {
            Step::ReadPage { chapter, page } => {
                self.read(*chapter, *page..page + 1, false);
                self.is_convinced();
            }
            Step::Read { chapter, page } => {
                let pages = page.unwrap_or(0)..self.book.library().chapters[*chapter].pages.len();
                self.read(*chapter, pages, true);
            }
            Step::Level(number) => self.win(*number),
            Step::Table => {}
            _ => {
                let course = step.round().map(Course::new);
                let seed = self.steps.len() as u64;
                if let Some(course) = course {
                    let is_right = self.play(Code { course, seed });
                    // The summary of a failed check names the page about the misconception again.
                    if matches!(step, Step::Check(_)) && !is_right {
                        self.is_convinced();
                    }
                }
            }
        }
        self.time_s += STEP_S;
        if self.steps.len().is_multiple_of(STEPS_A_DAY) {
            self.time_s += DAY_S - STEPS_A_DAY as i64 * STEP_S;
        }
        if self.habit == Habit::Pauses && self.steps.len() == 10 {
            self.time_s += 7 * DAY_S;
        }
    }

    fn is_convinced(&mut self) {
        if self.student.belief.right().is_some() && self.chance(CONVINCED) {
            // From now on, the learner knows what was taught, and other things only with the
            // probability `KNOWN`.
            self.student.belief = Belief::Knows;
            self.taught.insert("convinced".into());
        }
    }

    /// Whether the learner has known everything from the start.
    fn knows_all(&self) -> bool {
        self.student.belief == Belief::Knows && !self.taught.contains("convinced")
    }

    /// Plays a round, and returns whether all answers were right.
    fn play(&mut self, code: Code) -> bool {
        let mut is_right = true;
        let mut round = Round::of(code);
        let mut answers = Vec::new();
        while let Some(question) = round.questions().get(answers.len()).cloned() {
            let topic = question.topic.id().to_owned();
            let chapter = question.topic.taught_on().map_or("", |it| it.chapter);
            let is_taught = self.taught.contains(&topic) || self.taught.contains(chapter);
            let known = self.knows_all() || is_taught || self.chance(KNOWN);
            let belief = self.student.belief;
            if belief == Belief::Knows && !known {
                self.student.belief = Belief::Guesses;
            }
            self.student.knows_elsewhere = known;
            let answer = self.student.answer(&question);
            self.student.belief = belief;
            if !Grade::new(&question, &answer).right {
                is_right = false;
                if self.chance(EXPLAINED) {
                    self.taught.insert(topic);
                }
            }
            answers.push(answer);
            let number = answers.len() as u32;
            let mut attempt = Attempt::of_quiz("Ada", round.code(), number, &question, &answer);
            attempt.time_s = Some(self.time_s);
            self.attempts.push(attempt);
            round.go_on(&answers);
        }
        is_right
    }

    /// Reads pages of a chapter, and answers their questions.
    fn read(&mut self, chapter: usize, pages: std::ops::Range<usize>, in_order: bool) {
        let of_it = self.book.library().chapters[chapter].clone();
        let end = match self.chance(READ_AT_ONCE) {
            true => pages.end,
            false => (pages.start + 3).min(pages.end),
        };
        for at in pages.start..end {
            let page = &of_it.pages[at];
            let mut given = None;
            if let Some(checkpoint) = &page.checkpoint {
                let form = checkpoint.form(None);
                let knows = self.knows_all()
                    || self.student.belief != Belief::Guesses && self.chance(ANSWERED);
                let answer = match form.truth() {
                    Response::Number(x) if !x.is_finite() => Response::Number(1.0),
                    Response::Choice(right) if !knows => Response::Choice(usize::from(right == 0)),
                    truth => truth,
                };
                let tried = (&answer, false);
                let attempt = learn::attempt("Ada", &of_it, at, (&form, None), tried);
                self.attempts.push(Attempt {
                    right: knows,
                    time_s: Some(self.time_s),
                    ..attempt
                });
                given = Some(GivenAnswer {
                    asked: checkpoint.written.clone(),
                    answer,
                    right: knows,
                    first: None,
                });
            }
            let mark = Bookmark {
                place: in_order.then(|| page.title.clone()),
                alpha_deg: None,
                pages: BTreeMap::from([(page.title.clone(), given)]),
            };
            self.book.merge(&of_it.id, mark);
        }
        if self.book.is_done(&of_it) {
            self.taught.insert(of_it.id);
        }
    }

    fn win(&mut self, number: usize) {
        if let Some((pack, level)) = self.shelf.get(number) {
            let starred = Starred {
                pack: pack.name.clone(),
                level: level.id.clone(),
                stars: 1,
            };
            self.shelf.recall(&starred);
        }
    }
}
