//! The next step: tests the order of the steps, and that learners who follow the steps reach the
//! end.

use std::collections::BTreeMap;

use carrom::lessons::{Book, Bookmark};
use carrom::levels::{Shelf, Starred};
use carrom::path::{PathSoFar, Step};
use carrom::progress::{Attempt, Calendar};
use carrom::quiz::{
    Answer, Code, Confidence, Course, CourseKind, Form, Illustration, Misconception, Response,
    Round,
};

#[path = "../../benches/students/learner.rs"]
mod learner;

use crate::students::Belief;
use learner::{Habit, Learner};

const DAY_S: i64 = 86_400;
const NOW_S: i64 = 1_800_000_000;

/// The record of a player.
#[derive(Default)]
struct Somebody {
    attempts: Vec<Attempt>,
    book: Book,
    shelf: Shelf,
    days: i64,
}

impl Somebody {
    /// Answers the round of a code like a student who holds this misconception, if one is given.
    /// The other questions are all answered right or all answered wrong.
    fn answers(&mut self, code: &str, holding: Option<Misconception>, right: bool) {
        let round = Round::of(Code::parse(code).unwrap());
        for (number, question) in (1..).zip(round.questions()) {
            let held = question.beliefs.iter();
            let held = held.filter(|it| Some(it.misconception) == holding);
            let truth = question.form.truth();
            let wrong = match (&question.form, &truth) {
                (Form::Choice { options, right }, _) => {
                    Response::Choice((right + 1) % options.len())
                }
                (_, Response::Number(x)) => Response::Number(37.7 * x + 11.3),
                (_, it) => *it,
            };
            let said = match held.map(|it| it.said).next() {
                Some(said) => said,
                None if right => truth,
                None => wrong,
            };
            let answer = Answer::new(said, Confidence::ThinkSo);
            let attempt = Attempt::of_quiz("Ada", round.code(), number, question, &answer);
            self.attempts.push(Attempt {
                time_s: Some(NOW_S + self.days * DAY_S),
                ..attempt
            });
        }
    }

    fn so_far<T>(&self, ask: impl Fn(&PathSoFar) -> T) -> T {
        let calendar = Calendar::utc(Some(NOW_S + self.days * DAY_S));
        ask(&PathSoFar {
            attempts: &self.attempts,
            calendar: &calendar,
            book: &self.book,
            shelf: &self.shelf,
        })
    }

    fn next(&self) -> Step {
        self.so_far(|it| it.next_step().step)
    }

    /// Records that the player saw a page, without moving the bookmark there.
    fn sees(&mut self, chapter: usize, page: usize) {
        let of_it = self.book.library().chapters[chapter].clone();
        let mark = Bookmark {
            pages: BTreeMap::from([(of_it.pages[page].title.clone(), None)]),
            ..Bookmark::default()
        };
        self.book.merge(&of_it.id, mark);
    }

    fn wins_all(&mut self) {
        let starred = self.shelf.levels().map(|(pack, level)| Starred {
            pack: pack.name.clone(),
            level: level.id.clone(),
            stars: 1,
        });
        for starred in starred.collect::<Vec<_>>() {
            self.shelf.recall(&starred);
        }
    }
}

const COPIED: Misconception = Misconception::CopiedAngle;

#[test]
fn a_new_player_is_sent_to_find_out_until_three_questions_are_answered() {
    let mut ada = Somebody::default();
    assert_eq!(ada.next(), Step::FindOut);
    ada.answers("from-angle1-7", None, true);
    assert_eq!(ada.next(), Step::FindOut);
    ada.answers("from-angle2-7", None, true);
    assert_ne!(ada.next(), Step::FindOut);
}

#[test]
fn a_misconception_leads_to_its_page_then_to_a_check_that_waits_a_day_if_it_fails() {
    let mut ada = Somebody::default();
    ada.answers("from-angle3-7", Some(COPIED), true);
    let Step::ReadPage { chapter, page } = ada.next() else {
        panic!("{:?}", ada.next());
    };
    let why = ada.so_far(|it| it.next_step().why);
    assert!(why.contains("3 of your answers showed this"), "{why}");
    assert_eq!(ada.so_far(|it| it.done().beliefs), (0, 1));
    ada.sees(chapter, page);
    assert_eq!(ada.next(), Step::Check(COPIED));
    ada.answers("copied-angle-1", Some(COPIED), true);
    assert_ne!(
        ada.next(),
        Step::Check(COPIED),
        "the check waits until tomorrow"
    );
    ada.days = 1;
    assert_eq!(ada.next(), Step::Check(COPIED));
    ada.answers("copied-angle-2", None, true);
    assert_ne!(ada.next(), Step::Check(COPIED));
    assert_eq!(ada.so_far(|it| it.done().beliefs), (1, 1));
}

#[test]
fn a_begun_chapter_comes_before_missed_topics_and_those_come_before_reviews() {
    let mut ada = Somebody::default();
    ada.answers("speeds6-7", None, false);
    let read = |chapter, page| Step::Read { chapter, page };
    // Speeds are taught in chapter 4, which builds on chapter 1.
    assert_eq!(ada.next(), read(0, None));
    let begun = ada.book.library().chapters[2].clone();
    ada.book.merge(&begun.id, Bookmark::at(&begun.pages[1]));
    assert_eq!(ada.next(), read(2, Some(1)));
}

#[test]
fn a_single_slip_by_a_player_who_knows_most_topics_is_reviewed_once_a_day() {
    let mut ada = Somebody::default();
    ada.answers("from-angle6-7", None, true);
    ada.answers("weigh1-7", None, false);
    let Step::Review(due) = ada.next() else {
        panic!("{:?}", ada.next());
    };
    assert_eq!(due.now.len(), 1);
    let kind = Step::Review(due).round().unwrap();
    let course = Course::new(kind);
    let round = Round::of(Code { course, seed: 7 });
    let question = &round.questions()[0];
    let answer = Answer::new(question.form.truth(), Confidence::Guess);
    let again = Attempt::of_quiz("Ada", round.code(), 1, question, &answer);
    ada.attempts.push(Attempt {
        time_s: Some(NOW_S),
        ..again
    });
    // After a right guess the topic is due at once, but there is only one review a day.
    assert!(!matches!(ada.next(), Step::Review(_)));
    ada.days = 1;
    assert!(matches!(ada.next(), Step::Review(_)));
}

#[test]
fn known_chapters_are_not_suggested_and_levels_come_before_the_table() {
    let mut ada = Somebody::default();
    let mut asked = 0;
    ada.answers("from-angle3-7", None, true);
    while let Some(kind) = ada.next().round() {
        assert!(matches!(kind, CourseKind::Read(_)), "{kind:?}");
        let course = Course::new(kind);
        let code = Code {
            course,
            seed: asked,
        };
        ada.answers(&code.to_string(), None, true);
        asked += 1;
        assert!(asked < 12);
    }
    assert_eq!(ada.next(), Step::Level(0));
    assert_eq!(ada.so_far(|it| it.done().chapters), (17, 17));
    ada.wins_all();
    assert_eq!(ada.next(), Step::Table);
    let packs = ada.so_far(|it| it.done().packs);
    assert_eq!(packs.0, packs.1);
}

#[test]
fn a_new_player_is_asked_about_equal_masses_in_pictures() {
    let topics = Somebody::default().so_far(|it| it.topics_met());
    for seed in 0..40 {
        let course = Course::of(CourseKind::Met(topics.clone()), 10);
        let round = Round::of(Code { course, seed });
        assert!(round.questions().len() >= 9, "{seed}");
        for question in round.questions() {
            let figure = |name: &str| question.figures.get(name).and_then(|it| it.as_f64());
            assert_eq!(figure("restitution"), Some(1.0), "{}", question.text);
            assert_eq!(figure("m1_g"), figure("m2_g"), "{}", question.text);
            assert_ne!(question.picture, Illustration::Nothing, "{}", question.text);
        }
    }
}

#[test]
fn rounds_ask_only_about_topics_that_were_read_or_answered() {
    let mut ada = Somebody::default();
    let new = ada.so_far(|it| it.topics_met());
    let marbles = ada.book.library().chapters[5].clone();
    for page in 0..marbles.pages.len() {
        ada.sees(5, page);
    }
    let read = ada.so_far(|it| it.topics_met());
    let added = read.iter().filter(|it| !new.contains(it));
    let chapters: Vec<_> = added.map(|it| it.taught_on().unwrap().chapter).collect();
    assert!(!chapters.is_empty() && chapters.iter().all(|it| *it == "marbles"));
    // After ten answers the player is no longer new, and the answered topics are included.
    let rutherford = "counts-at-two-angles";
    let has = |ada: &Somebody| {
        let met = ada.so_far(|it| it.topics_met());
        met.iter().any(|it| it.id() == rutherford)
    };
    ada.answers("rutherford6-7", None, true);
    assert!(!has(&ada));
    ada.answers("from-angle6-7", None, true);
    assert!(has(&ada));
}

#[test]
fn personal_rounds_have_no_code() {
    let met = Course::of(CourseKind::Met(vec!["equal-masses".into()]), 5);
    let code = Code {
        course: met,
        seed: 7,
    };
    assert!(code.course.kind.is_personal());
    assert_eq!(Code::parse(&code.to_string()), None);
}

#[test]
fn finding_out_begins_with_equal_masses() {
    for seed in 0..60 {
        let course = Course::new(CourseKind::FindOut);
        let round = Round::of(Code { course, seed });
        let question = &round.questions()[0];
        let figure = |name: &str| question.figures.get(name).and_then(|it| it.as_f64());
        assert_eq!(figure("m1_g"), figure("m2_g"), "{}", question.text);
        assert_eq!(figure("restitution"), Some(1.0), "{}", question.text);
    }
}

#[test]
fn every_learner_arrives_without_a_loop_and_one_who_knows_everything_reads_nothing() {
    const MOST_STEPS: usize = 60;
    for belief in Belief::ALL {
        let mut learner = Learner::new(belief, Habit::Follows, 1_000);
        while !learner.has_arrived() {
            learner.take_step();
            let name = belief.name();
            assert!(
                learner.steps.len() < MOST_STEPS,
                "{name}: {:?}",
                learner.next()
            );
        }
        let begins = |it: &&Step| matches!(it, Step::Read { page: None, .. });
        let chapters = learner.steps.iter().filter(begins).count();
        if belief == Belief::Knows {
            assert_eq!(chapters, 0, "{:?}", learner.steps);
            assert!(learner.steps.len() < 10 && learner.answered() < 60);
        }
        assert!(learner.days() < 30, "{}", belief.name());
    }
}

#[test]
fn a_learner_returns_after_a_week_and_one_who_plays_only_levels_is_still_asked_to_find_out() {
    let mut away = Learner::new(Belief::HalfAndHalf, Habit::Pauses, 1_000);
    while !(away.has_arrived() && matches!(away.steps.last(), Some(Step::Review(_)))) {
        away.take_step();
        assert!(away.steps.len() < 60, "{:?}", away.next());
    }
    assert!((7..30).contains(&away.days()));
    let mut plays = Learner::new(Belief::IgnoresMass, Habit::OnlyPlays, 1_000);
    while plays.steps.last() != Some(&Step::Table) {
        plays.take_step();
    }
    assert_eq!(plays.next().step, Step::FindOut);
    let packs = plays.done().packs;
    assert_eq!(packs.0, packs.1);
}
