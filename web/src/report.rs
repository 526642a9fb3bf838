//! The report of a round to a learning platform.

use std::sync::Arc;

use carrom::progress::Attempt;
use carrom::quiz::concepts::Library;
use carrom::quiz::{Answer, Code, Form, Grade, Question, Response, Round, letter};
use carrom::screens::Route;
use serde::Serialize;

/// The longest text that SCORM allows as an answer, in characters.
const LONGEST: usize = 255;

/// The answers given in a round so far.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RoundReport {
    /// Whether all questions are answered.
    pub done: bool,
    /// The points for accuracy, as a percentage of the maximum for the whole round, to two decimal
    /// places.
    pub score: f64,
    /// The answers, in the order of the questions.
    pub answers: Vec<AnswerReport>,
}

/// An answer, in the forms that SCORM 1.2 defines.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AnswerReport {
    /// The code of the round and the number of the question: "quick-7.2".
    pub id: String,
    /// "choice", "numeric", or "fill-in" for two directions.
    pub kind: &'static str,
    /// The answer: the letter of a choice, a number, or text.
    pub said: String,
    /// The correct answer, in the same form.
    pub truth: String,
    /// Whether the answer counts as right.
    pub right: bool,
}

/// The report of the round with this code, for answers written as in a link; `None` if there is no
/// such round or the answers do not fit it.
pub(crate) fn of_round(code: &str, said: &str, own: &Arc<Library>) -> Option<RoundReport> {
    let code = Code::parse(code)?.with_own(own).ok()?;
    let round = Round::of(code.clone());
    let questions = round.questions();
    let route = Route::Quiz(Some(code.clone()));
    let Ok(Route::OpenRound { answers, .. }) = route.with_answers(&said.replace('+', " ")) else {
        return None;
    };
    let pairs: Vec<(&Question, &Answer)> = questions.iter().zip(&answers).collect();
    let fit = |(question, answer): &(&Question, &Answer)| question.form.accepts(&answer.said);
    if questions.is_empty() || answers.len() > questions.len() || !pairs.iter().all(fit) {
        return None;
    }
    let mut points = 0.0;
    let reports = (1..).zip(&pairs).map(|(number, (question, answer))| {
        let attempt = Attempt::of_quiz("", &code, number, question, answer);
        points += attempt.points();
        let form = &question.form;
        AnswerReport {
            id: format!("{code}.{number}"),
            kind: match form {
                Form::Choice { .. } => "choice",
                Form::Number { .. } | Form::Shot(_) => "numeric",
                Form::Rays { .. } => "fill-in",
            },
            said: in_form(form, &answer.said),
            truth: in_form(form, &form.truth()),
            right: attempt.right,
        }
    });
    let answers: Vec<AnswerReport> = reports.collect();
    let most = Grade::MOST * questions.len() as f64;
    Some(RoundReport {
        done: answers.len() == questions.len(),
        score: (1e4 * points / most).round() / 1e2,
        answers,
    })
}

/// An answer in the form that SCORM requires.
fn in_form(form: &Form, said: &Response) -> String {
    let thousandths = |x: f64| (x * 1e3).round() / 1e3;
    match said {
        Response::Choice(choice) => letter(*choice).to_ascii_lowercase().into(),
        Response::Number(x) => thousandths(*x).to_string(),
        // In millimetres.
        Response::Shot(offset) => thousandths(1e3 * offset).to_string(),
        Response::Rays(_) => form.words(said).chars().take(LONGEST).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Correct answers to the first questions of a round.
    fn correct(code: &str, count: usize) -> String {
        let round = Round::of(Code::parse(code).unwrap());
        let answers = round.questions().iter().take(count);
        let answers = answers.map(|it| format!("{} sure", it.form.truth().to_text()));
        answers.collect::<Vec<_>>().join(";").replace(' ', "+")
    }

    #[test]
    fn correct_answers_to_all_questions_score_a_hundred() {
        for code in ["quick-7", "mixed-3", "7", "exam-2"] {
            let own = Arc::default();
            let count = Round::of(Code::parse(code).unwrap()).questions().len();
            let report = of_round(code, &correct(code, count), &own).unwrap();
            assert!(report.done && report.score == 100.0, "{report:?}");
            assert!(
                report
                    .answers
                    .iter()
                    .all(|it| it.right && it.said == it.truth)
            );
            // While the last answer is being explained, the link ends with a semicolon.
            let explained = format!("{};", correct(code, 1));
            let first = of_round(code, &explained, &own).unwrap();
            assert!(!first.done && first.answers == report.answers[..1]);
            assert!((first.score - 100.0 / count as f64).abs() < 0.006);
        }
    }

    #[test]
    fn answers_that_do_not_fit_the_round_give_no_report() {
        let own = Arc::default();
        let too_many = format!("{};number+1+sure", correct("quick-7", 60));
        for said in [
            "x",
            "choice+99+sure",
            "number+1e999+sure",
            "rays+1",
            &too_many,
        ] {
            assert_eq!(of_round("quick-7", said, &own), None, "{said}");
        }
        assert_eq!(
            of_round("find-out-7", "", &own).map(|it| it.done),
            Some(false)
        );
        for code in ["", "own-7", "quick", "review-7"] {
            assert_eq!(of_round(code, "", &own), None, "{code}");
        }
    }
}
