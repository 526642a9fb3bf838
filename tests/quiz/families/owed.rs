//! Checks that every family of questions must pass.

use std::collections::{BTreeMap, BTreeSet};

use carrom::quiz::{
    Answer, Confidence, Dice, Difficulty, Family, Fit, Form, Grade, MIN_SEPARATION, Question, Rays,
    Response, explain,
};
use carrom::widgets::Charset;
use carrom::widgets::text::wrap;

use crate::thorough::cases;

/// The number of seeds that are tried at each difficulty.
pub(crate) const SEEDS: u64 = 2_000;

/// The largest number of draws that a question may take; `Family::ask` gives up after twenty times
/// as many.
const DRAWS: usize = 1_000;

/// If a family has questions with choices, at least two positions must each hold the right choice
/// in at least this share of them. Each misconception must occur in at least this share of a
/// family's questions at one difficulty or more.
const NOW_AND_THEN: f64 = 0.02;

/// The widths, in columns, of the panel beside a picture, and of a choice after its letter.
const PANEL: usize = 28;
const CHOICE: usize = 24;

/// The question for a seed.
pub(crate) fn question(family: Family, difficulty: Difficulty, seed: u64) -> Question {
    let asked = family.ask(difficulty, &mut Dice::new(seed));
    let (question, draws) = asked.unwrap_or_else(|| panic!("{family:?} gives no question"));
    assert!(draws <= DRAWS, "{family:?} {seed}: {draws} draws");
    question
}

/// The questions of [`SEEDS`] seeds at a difficulty.
pub(crate) fn questions(family: Family, difficulty: Difficulty) -> impl Iterator<Item = Question> {
    (0..SEEDS).map(move |seed| question(family, difficulty, seed))
}

/// All questions of a family at all difficulties.
pub(crate) fn all(family: Family) -> impl Iterator<Item = Question> {
    Difficulty::ALL
        .into_iter()
        .flat_map(move |difficulty| questions(family, difficulty))
}

/// A numerical figure of a question.
pub(crate) fn figure(question: &Question, name: &str) -> f64 {
    let figure = question.figures.get(name).and_then(|it| it.as_f64());
    figure.unwrap_or_else(|| panic!("no number {name} among {:?}", question.figures))
}

/// A textual figure of a question.
pub(crate) fn word<'a>(question: &'a Question, name: &str) -> &'a str {
    let word = question.figures.get(name).and_then(|it| it.as_str());
    word.unwrap_or_else(|| panic!("no word {name} among {:?}", question.figures))
}

/// The true number of a question that asks for a number.
pub(crate) fn number(question: &Question) -> f64 {
    match question.form.truth() {
        Response::Number(truth) => truth,
        other => panic!("no number: {other:?}"),
    }
}

/// The true rays of a question that asks for rays.
pub(crate) fn rays(question: &Question) -> Rays {
    match question.form.truth() {
        Response::Rays(truth) => truth,
        other => panic!("no rays: {other:?}"),
    }
}

/// The text of the right choice.
pub(crate) fn right_choice(question: &Question) -> &str {
    match &question.form {
        Form::Choice { options, right } => &options[*right],
        other => panic!("no choices: {other:?}"),
    }
}

/// Fails unless two numbers are equal except for rounding.
#[track_caller]
pub(crate) fn assert_close(found: f64, expected: f64, question: &Question) {
    let scale = expected.abs().max(1.0);
    assert!(
        (found - expected).abs() <= 1e-9 * scale,
        "{found} is not {expected}: {question:#?}"
    );
}

/// Checks everything that every family must satisfy. The family's own test checks whether its
/// answers are right.
pub(crate) fn assert_family(family: Family) {
    assert_eq!(Family::with_id(family.id()), Some(family));
    let mut asked: Vec<BTreeSet<String>> = Vec::new();
    let mut met: BTreeMap<&str, f64> = BTreeMap::new();
    let mut letters: BTreeMap<usize, f64> = BTreeMap::new();
    // Of questions that differ mainly in their numbers, one in four is enough.
    let one_in = match family {
        Family::Concept | Family::Ideas => 1,
        _ => cases(4, 1),
    };
    for difficulty in Difficulty::ALL {
        let mut here: BTreeMap<&str, u32> = BTreeMap::new();
        let mut different = BTreeSet::new();
        for (number, question) in questions(family, difficulty).enumerate() {
            assert_eq!((question.family, question.difficulty), (family, difficulty));
            // A question that has been checked is not checked again.
            if different.insert(identity(&question)) && number % one_in == 0 {
                assert_question(&question);
            }
            for belief in &question.beliefs {
                *here.entry(belief.misconception.id()).or_default() += 1;
            }
            if let Form::Choice { right, .. } = question.form {
                *letters.entry(right).or_default() += 1.0;
            }
        }
        for (id, times) in here {
            let share = f64::from(times) / SEEDS as f64;
            let most = met.entry(id).or_default();
            *most = most.max(share);
        }
        asked.push(different);
    }
    assert!(met.len() >= 2, "{family:?} knows only {met:?}");
    for (id, share) in &met {
        assert!(
            *share >= NOW_AND_THEN,
            "{family:?}: {id} is too rare: {share}"
        );
    }
    let choices: f64 = letters.values().sum();
    let often = letters.values().filter(|n| **n >= NOW_AND_THEN * choices);
    assert!(letters.is_empty() || often.count() >= 2, "{letters:?}");
    assert_different(family, &asked);
    assert_repeats(family);
}

/// The data that identify a question.
fn identity(question: &Question) -> String {
    let figures = serde_json::to_string(&question.figures).unwrap();
    format!("{} {figures} {:?}", question.text, question.form)
}

/// Fails unless the difficulties ask different questions: at most half of the questions of a
/// difficulty are also asked at any one easier difficulty.
fn assert_different(family: Family, asked: &[BTreeSet<String>]) {
    for (i, one) in asked.iter().enumerate() {
        assert!(one.len() >= 3, "{family:?} asks {} at {i}", one.len());
        for easier in &asked[..i] {
            let old = one.intersection(easier).count();
            assert!(2 * old <= one.len(), "{family:?}: {i} asks {old} again");
        }
    }
}

/// Fails unless the same seed gives the same question.
fn assert_repeats(family: Family) {
    for difficulty in Difficulty::ALL {
        for seed in 0..20 {
            let again = || question(family, difficulty, seed);
            assert_eq!(again(), again());
        }
    }
}

/// Checks everything that every question must satisfy.
pub(crate) fn assert_question(question: &Question) {
    let form = &question.form;
    let truth = Answer::new(form.truth(), Confidence::Sure);
    let grade = Grade::new(question, &truth);
    assert!(
        grade.right && (grade.credit - 1.0).abs() < 1e-12,
        "{question:#?}"
    );
    assert!((grade.points() - Grade::MOST).abs() < 1e-12);
    assert_eq!(question.belief_of(&truth), None, "{question:#?}");

    // The last bit of a number, which may differ between machines, must not change the question.
    let clearance = question.clearance();
    assert!(
        clearance > MIN_SEPARATION + 1e-9,
        "{clearance}: {question:#?}"
    );
    let told = question.beliefs.len() + question.replies.len();
    assert!(told > 0, "{question:#?}");
    for belief in &question.beliefs {
        let answer = Answer::new(belief.said, Confidence::Sure);
        assert!(!Grade::new(question, &answer).right, "{question:#?}");
        let (found, fit) = question.belief_of(&answer).unwrap();
        assert_eq!(found.misconception, belief.misconception, "{question:#?}");
        assert_eq!(fit, Fit::Whole);
        assert_can_be_said(question, &belief.said);
    }
    assert_can_be_said(question, &form.truth());
    assert_figures(question);
    assert_words(question);
}

/// Fails unless an answer can be entered by hand.
fn assert_can_be_said(question: &Question, said: &Response) {
    match (&question.form, said) {
        (Form::Number { quantity, .. }, Response::Number(x)) => {
            let range = quantity.smallest()..=quantity.largest();
            assert!(range.contains(x), "{x}: {question:#?}");
            // The printed number has nearly the same value.
            let printed = quantity.print(*x);
            let bare = printed.strip_suffix(quantity.unit()).unwrap();
            let typed: f64 = bare.trim_end().parse().unwrap();
            let off = if *x == 0.0 {
                typed.abs()
            } else {
                quantity.distance(typed, *x)
            };
            assert!(off < 0.2, "{typed} for {x}: {question:#?}");
        }
        (Form::Choice { options, .. }, Response::Choice(i)) => assert!(*i < options.len()),
        (Form::Shot(aim), Response::Shot(offset)) => {
            assert!(
                offset.abs() <= aim.collision.contact_distance(),
                "{question:#?}"
            );
        }
        (Form::Rays { .. }, Response::Rays(rays)) => {
            let angles = [rays.striker, rays.target];
            assert!(angles.into_iter().flatten().all(f64::is_finite));
        }
        other => panic!("{other:?} answers {question:#?}"),
    }
}

/// Fails unless all figures to be stored are valid.
fn assert_figures(question: &Question) {
    assert!(!question.figures.is_empty());
    for (name, value) in &question.figures {
        assert!(!value.is_null(), "{name}: {question:#?}");
        if let Some(x) = value.as_f64() {
            assert!(x.is_finite(), "{name}: {question:#?}");
        }
    }
}

/// Fails unless every text fits in its space and the question does not contain the number that it
/// asks for.
fn assert_words(question: &Question) {
    assert_readable(&question.topic.name(), PANEL, 1);
    assert_readable(&question.text, PANEL, 10);
    assert!(
        question.text.ends_with(['?', '.', ':']),
        "{}",
        question.text
    );
    match &question.form {
        Form::Choice { options, right } => {
            assert!((2..=5).contains(&options.len()) && *right < options.len());
            for (i, option) in options.iter().enumerate() {
                assert_readable(option, CHOICE, 4);
                let same = |other: &String| other.eq_ignore_ascii_case(option);
                assert!(!options[..i].iter().any(same), "{options:?}");
            }
        }
        Form::Number { quantity, truth } => {
            let answer = quantity.print(*truth);
            assert!(
                !question.text.contains(&answer),
                "{answer}: {}",
                question.text
            );
        }
        Form::Rays { .. } | Form::Shot(_) => {}
    }
    // Questions in words, questions about the separation and questions about both directions have
    // longer explanations; a small panel scrolls.
    let longest = match question.family {
        Family::Concept | Family::Ideas => 14,
        Family::Separation => 13,
        _ if matches!(question.form, Form::Rays { .. }) => 13,
        _ => 12,
    };
    for said in answers(question) {
        let explanation = explain(question, &Answer::new(said, Confidence::Guess));
        assert_readable(&explanation.text, PANEL, longest);
        assert_readable(explanation.title, PANEL, 2);
        assert!(explanation.text.ends_with('.'), "{}", explanation.text);
    }
}

/// The true answer, the answers of misconceptions, and answers that fit no misconception.
fn answers(question: &Question) -> Vec<Response> {
    let mut answers: Vec<Response> = question.beliefs.iter().map(|belief| belief.said).collect();
    answers.push(question.form.truth());
    match &question.form {
        Form::Number { quantity, truth } => {
            let far = [0.0, 0.7 * truth, 1.9 * truth, quantity.largest()];
            answers.extend(far.map(|x| Response::Number(x.min(quantity.largest()))));
        }
        Form::Choice { options, .. } => answers.extend((0..options.len()).map(Response::Choice)),
        Form::Shot(aim) => {
            let far = [-1.1, -0.5, 0.0, 0.5, 1.1];
            answers
                .extend(far.map(|share| Response::Shot(share * aim.collision.contact_distance())));
        }
        Form::Rays { .. } => {
            let wild = [
                (None, Some(-0.4)),
                (Some(-3.0), None),
                (Some(0.0), Some(2.0)),
                (Some(2.0), Some(0.0)),
            ];
            answers.extend(wild.map(|(striker, target)| Response::Rays(Rays { striker, target })));
        }
    }
    answers
}

/// Fails if a text contains an unexpected character sequence, cannot be written in ASCII, or takes
/// more than `lines` lines of `columns` columns in ASCII.
#[track_caller]
pub(crate) fn assert_readable(text: &str, columns: usize, lines: usize) {
    for stranger in [
        "NaN", "inf", "-0.0", "−0.0", "  ", "{", "}", " .", " ,", "..",
    ] {
        assert!(!text.contains(stranger), "{stranger:?} in {text:?}");
    }
    assert!(!text.is_empty() && text.trim() == text, "{text:?}");
    let ascii = Charset::Ascii.text(text);
    let unknown = |text: &str| text.matches('?').count();
    assert_eq!(unknown(&ascii), unknown(text), "no ASCII for {text:?}");
    let taken = wrap(&ascii, columns).len();
    assert!(taken <= lines, "{taken} lines: {text}");
}
