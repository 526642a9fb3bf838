//! What stands on sheet and key, whatever they are written in.

use crate::numbers;
use crate::quiz::{
    Code, Confidence, Difficulty, Form, Illustration, Measure, Question, RIGHT_DEG, letter,
};

/// What a student is to know before the first question.
pub(super) const ADVICE: &str = "Predict first, then check: answer every question before you look \
                                 anything up, and tick how sure you are. A good guess is worth \
                                 something, and an honest \"guess\" costs nothing. Pictures are \
                                 seen from above and true to scale; left and right are seen along \
                                 the striker's path. Rims are smooth unless a question says \
                                 otherwise.";

/// What a key is for.
pub(super) const KEY_ADVICE: &str = "For the teacher. Each question with its true answer, why it \
                                     is true, and the wrong answers to listen for: a pupil who \
                                     gives one of these answers probably reasoned this way.";

/// What opens the same round on a screen.
pub(super) fn command(code: &Code, concepts: &[String]) -> String {
    let folders = concepts
        .iter()
        .map(|folder| format!(" --concepts {folder}"));
    format!("carrom quiz --code {code}{}", folders.collect::<String>())
}

/// Points that a question is worth on paper: one for an easy one, up to three.
const fn worth_of(question: &Question) -> usize {
    match question.difficulty {
        Difficulty::Easy => 1,
        Difficulty::Middle => 2,
        Difficulty::Hard => 3,
    }
}

/// What stands behind the room for the points of a question: " / 2".
pub(super) fn of_points(question: &Question) -> String {
    format!(
        "\u{a0}/\u{a0}{}",
        numbers::counted(worth_of(question), "point")
    )
}

/// How many points there are in all.
pub(super) fn worth(questions: &[Question]) -> String {
    let all: usize = questions.iter().map(worth_of).sum();
    format!("In all there are {}.", numbers::counted(all, "point"))
}

/// What counts as right.
pub(super) fn tolerance() -> String {
    format!(
        "Counts as right: both directions within {RIGHT_DEG}°, where paths are drawn; {}; an \
         offset that sends the disc within {RIGHT_DEG}° of the required direction.",
        Measure::RIGHT
    )
}

/// What the boxes for being sure bring.
pub(super) fn points() -> String {
    let each = Confidence::ALL.map(|sure| {
        let [right, wrong] = [1.0, 0.0].map(|credit| sure.points(credit));
        format!("{} {right} or {wrong}", sure.name())
    });
    let each = each.join(", ").replace('-', "\u{2212}");
    format!("Points, if you want to give any (right or wrong): {each}.")
}

/// The heads of the table of wrong answers.
pub(super) const WRONG_ANSWERS: [&str; 2] = ["Answer", "Possible reasoning, and a reply"];

/// What is to be done where an answer cannot just be written down.
pub(super) fn task(question: &Question) -> Option<&'static str> {
    match (&question.form, &question.picture) {
        (Form::Rays { .. }, Illustration::Before { .. }) => {
            Some("Draw both paths from the middle of the protractor, then read off:")
        }
        (Form::Shot(_), _) => Some("Mark the target's centre on the scale, and write its offset:"),
        (Form::Choice { .. }, _) => Some("Tick one:"),
        _ => None,
    }
}

/// The true answer in words, a choice with its letter.
pub(super) fn truth(question: &Question) -> String {
    said(question, &question.form.truth())
}

/// An answer in words, a choice with its letter.
pub(super) fn said(question: &Question, said: &crate::quiz::Response) -> String {
    let words = question.form.words(said);
    match said {
        crate::quiz::Response::Choice(choice) => format!("{}: {words}", letter(*choice)),
        _ => words,
    }
}
