//! The questions in words.

use std::collections::{BTreeMap, BTreeSet};

use carrom::quiz::{
    Answer, Code, Confidence, Course, CourseKind, Difficulty, Family, Form, Response, Round,
};
use carrom::quiz::{concepts, explain};

use super::owed::{all, assert_family, questions, right_choice, word};

/// Both families of questions in words.
const WRITTEN: [Family; 2] = [Family::Concept, Family::Ideas];

#[test]
fn passes_the_checks_for_all_families() {
    WRITTEN.into_iter().for_each(assert_family);
}

#[test]
fn each_question_is_asked_as_it_is_written_in_its_file() {
    for question in WRITTEN.into_iter().flat_map(all) {
        let written = concepts::with_id(word(&question, "id")).unwrap();
        assert_eq!(question.difficulty, written.difficulty);
        assert_eq!(question.text, written.ask);
        assert_eq!(right_choice(&question), written.right);
        let Form::Choice { options, right } = &question.form else {
            panic!("{question:#?}");
        };
        for wrong in &written.wrongs {
            let place = options.iter().position(|it| *it == wrong.choice).unwrap();
            assert_ne!(place, *right);
            let answer = Answer::new(Response::Choice(place), Confidence::Sure);
            let found = question.belief_of(&answer).map(|(it, _)| it.misconception);
            assert_eq!(found, wrong.misconception);
            let told = explain(&question, &answer).text;
            assert_eq!(told, format!("{} {}", wrong.says, written.why));
        }
        if written.ordered {
            let written: Vec<_> = written.choices().iter().map(|it| it.0).collect();
            assert_eq!(*options, written);
        }
    }
}

#[test]
fn every_question_is_asked_and_its_right_choice_has_every_letter_equally_often() {
    let mut asked = BTreeSet::new();
    // For each number of choices, how often the right choice has each letter.
    let mut letters: BTreeMap<usize, BTreeMap<usize, f64>> = BTreeMap::new();
    for question in WRITTEN.into_iter().flat_map(all) {
        let id = word(&question, "id").to_owned();
        if let Form::Choice { options, right } = &question.form
            && !concepts::with_id(&id).unwrap().ordered
        {
            let of_so_many = letters.entry(options.len()).or_default();
            *of_so_many.entry(*right).or_default() += 1.0;
        }
        asked.insert(id);
    }
    assert_eq!(asked.len(), concepts::all().len());
    for (choices, times) in letters {
        let all: f64 = times.values().sum();
        let expected = all / choices as f64;
        // The largest accepted difference is five standard deviations.
        let most = 5.0 * (expected * (1.0 - 1.0 / choices as f64)).sqrt();
        assert_eq!(times.len(), choices);
        for (letter, times) in times {
            assert!(
                (times - expected).abs() < most,
                "{letter} of {choices}: {times} instead of {expected}"
            );
        }
    }
}

/// Questions that were written later appear in no round of an earlier code, only in rounds of their
/// own codes.
#[test]
fn later_questions_are_asked_by_codes_of_their_own() {
    let later: BTreeSet<String> = all(Family::Ideas)
        .map(|it| word(&it, "id").to_owned())
        .collect();
    let first: BTreeSet<String> = all(Family::Concept)
        .map(|it| word(&it, "id").to_owned())
        .collect();
    assert!(first.is_disjoint(&later));
    let later: BTreeSet<&str> = later.iter().map(String::as_str).collect();
    let asks_later = |code: &str| {
        let round = Round::of(Code::parse(code).unwrap());
        let mut ids = round
            .questions()
            .iter()
            .filter_map(|it| it.figures.get("id"));
        ids.any(|id| later.contains(id.as_str().unwrap()))
    };
    for seed in 0..40 {
        for kind in [
            "mixed20",
            "even20",
            "exam20",
            "concept20",
            "upside-down",
            "read-abl",
        ] {
            assert!(!asks_later(&format!("{kind}-{seed}")), "{kind}-{seed}");
        }
        assert!(asks_later(&format!("ideas-{seed}")));
    }
    assert!((0..40).any(|seed| asks_later(&format!("sticking-hits-harder-{seed}"))));
}

#[test]
fn no_question_comes_twice_in_a_round() {
    let fewest = Difficulty::ALL.map(|difficulty| {
        let of_it = questions(Family::Concept, difficulty);
        of_it.map(|it| it.text).collect::<BTreeSet<_>>().len()
    });
    let third = Course::MOST / 3;
    assert!(fewest.iter().all(|n| *n >= third), "{fewest:?}");
    for count in [6, 30] {
        for seed in 0..300 {
            let course = Course::of(CourseKind::Topic(Family::Concept), count);
            let round = Round::of(Code { course, seed });
            let texts: BTreeSet<_> = round.questions().iter().map(|it| &it.text).collect();
            assert_eq!(texts.len(), count, "{seed}");
        }
    }
    for seed in 0..300 {
        let course = Course::new(CourseKind::Topic(Family::Ideas));
        let round = Round::of(Code { course, seed });
        let texts: BTreeSet<_> = round.questions().iter().map(|it| &it.text).collect();
        assert_eq!(texts.len(), round.questions().len(), "{seed}");
    }
}
