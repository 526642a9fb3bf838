//! The wording of the question sheet and the answer key, shared by the HTML and the Markdown
//! format.

use crate::numbers;
use crate::quiz::{
    Code, Confidence, CourseKind, Difficulty, Form, Grade, Illustration, Measure, Question,
    RIGHT_DEG, letter,
};

/// What a student should know before the first question.
pub(super) const ADVICE: &str = "Predict first, then check: answer every question before you look \
                                 anything up, and tick how sure you are. A good guess is worth \
                                 something, and an honest \"guess\" costs nothing. Pictures are \
                                 seen from above and true to scale; left and right are seen along \
                                 the striker's path. Rims are smooth unless a question says \
                                 otherwise.";

/// A sentence on the purpose of the answer key.
pub(super) const KEY_ADVICE: &str = "For the teacher: each question has its true answer, the \
                                     reason why it is true, and the wrong answers to listen for, \
                                     with the reasoning that probably led to them.";

/// The command that opens the same round on a screen.
pub(super) fn command(code: &Code, own: &str) -> String {
    match code.course.kind {
        CourseKind::Set(_) => format!("carrom quiz{own}"),
        _ => format!("carrom quiz --code {code}{own}"),
    }
}

/// The points for a question on paper: one if it is easy, three if it is hard.
pub(super) const fn worth_of(question: &Question) -> usize {
    match question.difficulty {
        Difficulty::Easy => 1,
        Difficulty::Middle => 2,
        Difficulty::Hard => 3,
    }
}

/// The text after the space for a question's points: " / 2 points".
pub(super) fn of_points(question: &Question) -> String {
    let points = numbers::counted(worth_of(question), "point");
    format!("\u{a0}/\u{a0}{points}")
}

/// The total number of points.
pub(super) fn worth(questions: &[Question]) -> String {
    let all: usize = questions.iter().map(worth_of).sum();
    format!("Total: {}.", numbers::counted(all, "point"))
}

/// The limits within which an answer is right.
pub(super) fn tolerance() -> String {
    format!(
        "Right answers: both directions within {RIGHT_DEG}° of the true ones; {}; an offset that \
         sends the disc within {RIGHT_DEG}° of the required direction.",
        Measure::RIGHT
    )
}

/// How each confidence level changes the points for a question.
pub(super) fn points() -> String {
    let each = Confidence::ALL.map(|sure| {
        let [right, wrong] = [1.0, 0.0].map(|credit| sure.points(credit) / Grade::MOST);
        format!("\"{}\" {right} / {wrong}", sure.name())
    });
    let each = each.join(", ").replace('-', "\u{2212}");
    format!(
        "Points: a right answer earns the points printed beside its question. If you also mark how \
         sure a student was, multiply the points by the first of these factors if the answer is \
         right, and by the second if it is wrong: {each}."
    )
}

/// The column headings of the table of wrong answers.
pub(super) const WRONG_ANSWERS: [&str; 2] = ["Answer", "Possible reasoning, and a reply"];

/// The instruction for an answer that is drawn or ticked.
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

/// The true answer in words; a choice includes its letter.
pub(super) fn truth(question: &Question) -> String {
    said(question, &question.form.truth())
}

/// An answer in words; a choice includes its letter.
pub(crate) fn said(question: &Question, said: &crate::quiz::Response) -> String {
    let words = question.form.words(said);
    match said {
        crate::quiz::Response::Choice(choice) => format!("{}: {words}", letter(*choice)),
        _ => words,
    }
}
