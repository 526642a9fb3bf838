//! The families that ask for two rays: where will both discs go?

use std::thread;

use carrom::quiz::{Difficulty, Family, Illustration, Question};

use super::hit::Hit;
use super::owed::{all, assert_family, figure, questions, rays};

const FAMILIES: [Family; 5] = [
    Family::WhereTo,
    Family::FromAngle,
    Family::FromOffset,
    Family::FromPicture,
    Family::UnequalMasses,
];

#[test]
fn pass_the_checks_for_all_families() {
    thread::scope(|scope| {
        for family in FAMILIES {
            scope.spawn(move || assert_family(family));
        }
    });
}

#[test]
fn the_true_rays_follow_from_an_impulse_along_the_line_of_centres() {
    for family in FAMILIES {
        for question in all(family) {
            let gap = rays(&question).gap(&Hit::of(&question).rays());
            assert!(gap < 1e-9, "off by {gap}: {question:#?}");
        }
    }
}

/// Whether a question gives the impact angle, rather than the offset.
fn by_angle(question: &Question) -> bool {
    question.figures.contains_key("alpha_deg")
}

#[test]
fn each_family_asks_the_questions_that_its_name_promises() {
    let equal = |question: &Question| figure(question, "m1_g") == figure(question, "m2_g");
    for question in all(Family::FromAngle) {
        assert!(by_angle(&question) && equal(&question), "{question:#?}");
        let lossy = figure(&question, "restitution") < 1.0;
        assert_eq!(lossy, question.difficulty == Difficulty::Hard);
    }
    for question in all(Family::FromOffset) {
        assert!(!by_angle(&question));
        assert_eq!(equal(&question), question.difficulty != Difficulty::Hard);
    }
    for question in all(Family::UnequalMasses) {
        let head_on = figure(&question, "alpha_deg") == 0.0;
        assert!(!equal(&question) || head_on, "{question:#?}");
    }
}

#[test]
fn a_question_from_the_picture_alone_gives_no_numbers() {
    for difficulty in Difficulty::ALL {
        for question in questions(Family::FromPicture, difficulty) {
            let Illustration::Before { shown, .. } = question.picture else {
                panic!("no collision to watch: {question:#?}");
            };
            assert!(!shown.figures && !shown.offset);
            assert_eq!(shown.angle, difficulty == Difficulty::Easy);
            assert!(!question.text.contains(|c: char| c.is_ascii_digit()));
        }
    }
}
