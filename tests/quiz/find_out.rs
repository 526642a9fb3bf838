//! The course that finds out what a student believes, and the mixed course that tests for every
//! common misconception. With the same code and answers, both ask the same questions on every
//! machine, and name the same misconception.

use carrom::progress::{Attempt, Summary};
use carrom::quiz::{Answer, Code, Confidence, Misconception, Question, Response, Round};

use crate::thorough::cases;

fn round(code: &str) -> Round {
    Round::of(Code::parse(code).unwrap())
}

/// Answers a round to its end.
fn play(mut round: Round, answer: impl Fn(&Question) -> Response) -> (Round, Vec<Answer>) {
    let mut answers = Vec::new();
    while let Some(question) = round.questions().get(answers.len()) {
        answers.push(Answer::new(answer(question), Confidence::ThinkSo));
        round.go_on(&answers);
    }
    (round, answers)
}

fn look_back((round, answers): &(Round, Vec<Answer>)) -> Summary<'static> {
    let answered = (1..).zip(round.questions().iter().zip(answers));
    let attempt = |(number, (question, answer)): (u32, (&Question, &Answer))| {
        Attempt::of_quiz("Ada", round.code(), number, question, answer)
    };
    Summary::new(Vec::leak(answered.map(attempt).collect()))
}

/// The answers of a student who holds this misconception and otherwise answers correctly.
fn holding(misconception: Misconception) -> impl Fn(&Question) -> Response {
    move |question| {
        let mut held = question.beliefs.iter();
        let held = held.find(|it| it.misconception == misconception);
        held.map_or(question.form.truth(), |it| it.said)
    }
}

fn right(question: &Question) -> Response {
    question.form.truth()
}

#[test]
fn the_same_answers_lead_to_the_same_questions() {
    for seed in [0, 7, 1234] {
        let code = format!("find-out-{seed}");
        let swapped = || play(round(&code), holding(Misconception::Swapped));
        assert_eq!(swapped(), swapped());
        let (first, other) = (swapped().0, play(round(&code), right).0);
        assert_eq!(first.questions()[0], other.questions()[0]);
        assert_ne!(first.questions()[1..], other.questions()[1..]);
        // Questions that were already answered are neither repeated nor changed.
        let (mut again, answers) = swapped();
        let before = again.clone();
        again.go_on(&answers);
        again.go_on(&answers[..1]);
        assert_eq!(again, before);
    }
}

#[test]
fn a_code_of_the_diagnosis_always_gives_the_same_questions() {
    let mut texts = Vec::new();
    for (name, round) in [
        (
            "swapped",
            play(round("find-out-7"), holding(Misconception::Swapped)).0,
        ),
        (
            "frames mixed",
            play(round("find-out-7"), holding(Misconception::FramesMixed)).0,
        ),
        ("right", play(round("find-out-7"), right).0),
        ("copied-angle-7", play(round("copied-angle-7"), right).0),
    ] {
        texts.push(format!("{name}:"));
        let each = round.questions().iter();
        texts.extend(
            each.map(|it| format!("  [{}, {}] {}", it.family.id(), it.difficulty.id(), it.text)),
        );
    }
    insta::assert_snapshot!("find_out", texts.join("\n"));
}

#[test]
fn consistent_wrong_answers_name_a_misconception_and_right_ones_none() {
    for seed in 0..20 {
        let round = round(&format!("find-out-{seed}"));
        for misconception in Misconception::COMMON {
            let played = play(round.clone(), holding(misconception));
            let summary = look_back(&played);
            assert_eq!(summary.most_held(), Some(misconception), "{seed}");
            assert!((3..=12).contains(&summary.attempts.len()));
            let finding = summary.finding();
            assert!(finding[0].contains(misconception.name()), "{finding:?}");
            // The finding lists the numbers of the questions that show it.
            let shows = |(_, it): &(usize, &Attempt)| it.shows() == Some(misconception);
            for (number, _) in (1..).zip(summary.attempts).filter(shows) {
                assert!(finding[1].contains(&number.to_string()), "{finding:?}");
            }
        }
        let summary = look_back(&play(round, right));
        assert_eq!(summary.named(), []);
        assert!(summary.finding()[0].starts_with("No misconception"));
    }
}

/// A slip in algebra is called a slip, because nobody believes it.
#[test]
fn a_slip_is_not_reported_as_a_belief() {
    let finding = |misconception| {
        let played = play(round("even20-7"), holding(misconception));
        let finding = look_back(&played).finding();
        assert!(finding[0].contains(misconception.name()), "{finding:?}");
        finding.join(" ")
    };
    let slip = finding(Misconception::SineCosine);
    assert!(slip.contains("slip") && !slip.contains("believe"), "{slip}");
    let belief = finding(Misconception::CopiedAngle);
    assert!(
        belief.contains("believe") && !belief.contains("slip"),
        "{belief}"
    );
}

#[test]
fn a_shorter_diagnosis_has_as_many_questions_as_its_code_says() {
    let (round, answers) = play(round("find-out4-7"), right);
    assert_eq!((round.questions().len(), answers.len()), (4, 4));
}

/// Twenty questions give enough answers to name each common misconception.
#[test]
fn a_mixed_round_tests_every_common_misconception_often_enough() {
    for seed in 0..cases(10, 40) {
        let round = round(&format!("even20-{seed}"));
        assert_eq!(round.questions().len(), 20);
        for pair in round.questions().windows(2) {
            assert_ne!(pair[0].family, pair[1].family);
        }
        for (i, question) in round.questions().iter().enumerate() {
            assert!(
                !round.questions()[..i]
                    .iter()
                    .any(|it| it.text == question.text)
            );
        }
        for misconception in Misconception::COMMON {
            let played = play(round.clone(), holding(misconception));
            let summary = look_back(&played);
            assert_eq!(summary.most_held(), Some(misconception), "{seed}");
        }
    }
}

#[test]
fn a_check_asks_questions_that_can_show_the_misconception() {
    for &misconception in Misconception::ALL {
        for seed in 0..3 {
            let code = format!("{}-{seed}", misconception.id());
            let round = round(&code);
            assert_eq!(round.code().to_string(), code);
            assert_eq!(round.questions().len(), 2, "{code}");
            assert_ne!(round.questions()[0].text, round.questions()[1].text);
            // The code of a misconception still tests for the misconceptions that were split from
            // it.
            let is_it =
                |it: Misconception| it == misconception || it.in_codes() == Some(misconception);
            for question in round.questions() {
                let mut beliefs = question.beliefs.iter();
                assert!(beliefs.any(|it| is_it(it.misconception)));
            }
            let holding = |question: &Question| {
                let held = question.beliefs.iter().find(|it| is_it(it.misconception));
                held.map_or(question.form.truth(), |it| it.said)
            };
            let held = look_back(&play(round.clone(), holding));
            assert!(held.checked(misconception).starts_with("It still shows"));
            let known = look_back(&play(round, right));
            assert!(known.checked(misconception).starts_with("Settled"));
        }
    }
}
