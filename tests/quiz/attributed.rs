//! Feedback attributes to students only numbers that they entered or were given. Other numbers, to
//! which a misconception leads, follow "close to": "close to 45.0° each".

use std::collections::BTreeMap;

use carrom::quiz::{Answer, Confidence, Family, Form, Question, Rays, Response, explain};

use crate::questions;

const SEEDS: u64 = 200;

/// The numbers in a text, as printed.
fn numbers(text: &str) -> Vec<(usize, &str)> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(start) = text[at..].find(|c: char| c.is_ascii_digit()) {
        let start = at + start;
        let rest = &text[start..];
        let length = rest
            .find(|c: char| !c.is_ascii_digit() && c != '.')
            .unwrap_or(rest.len());
        found.push((start, rest[..length].trim_end_matches('.')));
        at = start + length;
    }
    found
}

/// The sentences of a text. A point within a number does not end a sentence.
fn sentences(text: &str) -> impl Iterator<Item = &str> {
    text.split(". ").flat_map(|part| part.split_inclusive("? "))
}

fn is_about_the_student(sentence: &str) -> bool {
    let mut words = sentence.split(|c: char| !c.is_alphabetic());
    words.any(|word| word.eq_ignore_ascii_case("you") || word.eq_ignore_ascii_case("your"))
}

/// The first number that a sentence wrongly attributes to the student.
fn invented<'t>(sentence: &'t str, said: &str, given: &str) -> Option<&'t str> {
    let holds = |text: &str, number: f64| {
        let all = numbers(text);
        all.iter()
            .any(|(_, it)| it.parse::<f64>().is_ok_and(|it| (it - number).abs() < 1e-9))
    };
    let found = numbers(sentence).into_iter().find(|(at, number)| {
        let value: f64 = number.parse().unwrap();
        let is_close_to = sentence[..*at].contains("close to");
        !is_close_to && !holds(said, value) && !holds(given, value)
    });
    found.map(|(_, number)| number)
}

/// Answers near a misconception's answer.
fn near(form: &Form, held: &Response) -> Vec<Response> {
    let shifts = [0.0, 0.37, -0.37, 0.83, -0.83];
    match (form, *held) {
        (Form::Rays { .. }, Response::Rays(rays)) => shifts
            .iter()
            .flat_map(|a| shifts.map(|b| (3.9 * a, 3.9 * b)))
            .map(|(a, b)| {
                let turned = |angle: Option<f64>, deg: f64| angle.map(|it| it + deg.to_radians());
                Response::Rays(Rays {
                    striker: turned(rays.striker, a),
                    target: turned(rays.target, b),
                })
            })
            .collect(),
        (Form::Number { .. }, Response::Number(x)) => shifts
            .iter()
            .flat_map(|shift| [x + 4.0 * shift, x + 0.04 * shift, x * (1.0 + 0.05 * shift)])
            .map(Response::Number)
            .collect(),
        (_, Response::Shot(offset)) => shifts
            .map(|shift| Response::Shot(offset * (1.0 + 0.05 * shift)))
            .to_vec(),
        _ => vec![*held],
    }
}

/// The feedback on an answer, without the explanation of the right answer.
fn feedback(question: &Question, said: Response) -> String {
    let text = explain(question, &Answer::new(said, Confidence::Sure)).text;
    text.strip_suffix(question.why.as_str())
        .unwrap_or(&text)
        .trim()
        .to_owned()
}

/// The text of the question, with its choices.
fn given(question: &Question) -> String {
    let mut given = question.text.clone();
    if let Form::Choice { options, .. } = &question.form {
        given += &format!(" {}", options.join(" "));
    }
    given
}

#[test]
fn feedback_attributes_to_the_student_only_what_was_said_or_given() {
    let mut checked: BTreeMap<&str, usize> = BTreeMap::new();
    let mut wrong = Vec::new();
    for (family, _, question) in questions(SEEDS) {
        let given = given(&question);
        let mut answers: Vec<Response> = question
            .beliefs
            .iter()
            .flat_map(|it| near(&question.form, &it.said))
            .collect();
        answers.extend(question.replies.keys().map(|it| Response::Choice(*it)));
        // Answers that fit no misconception get feedback, too.
        answers.extend(near(&question.form, &question.form.truth()));
        for said in answers.into_iter().filter(|it| question.form.accepts(it)) {
            let text = feedback(&question, said);
            let words = question.form.words(&said);
            for sentence in sentences(&text).filter(|it| is_about_the_student(it)) {
                *checked.entry(family.id()).or_default() += 1;
                if let Some(number) = invented(sentence, &words, &given) {
                    wrong.push(format!("{} {number} ({words}): {sentence}", family.id()));
                }
            }
            // The explanation of the right answer is not about the student.
            assert!(!is_about_the_student(&question.why), "{}", question.why);
        }
    }
    wrong.sort();
    wrong.dedup_by_key(|it| it.rsplit_once("): ").map(|it| it.1.to_owned()));
    let first: Vec<&String> = wrong.iter().take(40).collect();
    assert!(wrong.is_empty(), "{}: {first:#?}", wrong.len());
    for family in Family::ALL {
        let found = checked.get(family.id()).copied().unwrap_or(0);
        assert!(found >= 10, "{}: only {found} sentences", family.id());
    }
}

#[test]
fn a_number_that_the_student_did_not_enter_is_found() {
    let invented =
        |sentence| invented(sentence, "striker 48.2° left, coin 41.8° right", "e = 1.00");
    assert_eq!(invented("You gave each of them 45.0°"), Some("45.0"));
    assert_eq!(
        invented("The angles you gave are close to 45.0° each"),
        None
    );
    assert_eq!(
        invented("You sent the striker off at 48.2° with e = 1"),
        None
    );
    assert!(is_about_the_student("For the striker you used α"));
    assert!(!is_about_the_student("The young coin stops"));
}
