//! What is drawn beside a question, and beside its answer.

use crate::paper::{After, Shown, Svg, aim_picture, hit_picture, seen_picture, tracks_picture};
use crate::quiz::{self, Form, Question, Round};

/// A picture with the name of its file.
#[derive(Debug)]
pub struct Picture {
    /// What the file is called, without what follows the dot: "question-01".
    pub name: String,
    /// The picture.
    pub svg: Svg,
}

impl Picture {
    /// Whether a file of this name is a picture of some worksheet: `answer-07.svg`.
    #[must_use]
    pub fn is_file_name(name: &str) -> bool {
        let name = name.strip_suffix(".svg");
        let number = name.and_then(|it| it.strip_prefix(QUESTION).or(it.strip_prefix(ANSWER)));
        number.is_some_and(|it| it.len() >= 2 && it.bytes().all(|byte| byte.is_ascii_digit()))
    }
}

const QUESTION: &str = "question-";
const ANSWER: &str = "answer-";

/// The name of the picture of the question of this number, counted from 1.
pub(super) fn question_name(number: usize) -> String {
    format!("{QUESTION}{number:02}")
}

/// The name of the picture of an answer.
pub(super) fn answer_name(number: usize) -> String {
    format!("{ANSWER}{number:02}")
}

pub(super) fn all(round: &Round) -> Vec<Picture> {
    let mut all = Vec::new();
    for (number, question) in (1..).zip(round.questions()) {
        let picture = |name, svg| Picture { name, svg };
        all.extend(of_question(question).map(|svg| picture(question_name(number), svg)));
        all.extend(of_answer(question).map(|svg| picture(answer_name(number), svg)));
    }
    all
}

/// What is seen beside a question, and no more than that; a protractor to draw in where
/// both ways are asked for, a scale where an offset is.
pub(super) fn of_question(question: &Question) -> Option<Svg> {
    match (&question.picture, &question.form) {
        (quiz::Illustration::Before { .. }, Form::Shot(aim)) => Some(aim_picture(aim)),
        (quiz::Illustration::Before { collision, shown }, form) => {
            let after = match form {
                Form::Rays { .. } => After::Space,
                _ => After::Nothing,
            };
            let shown = Shown {
                offset: shown.offset,
                angle: shown.angle,
                line_of_impact: false,
                masses: false,
                numbers: shown.figures,
                speeds: shown.figures,
                after,
            };
            Some(hit_picture(collision, &shown))
        }
        (quiz::Illustration::After { collision }, _) => Some(seen_picture(collision)),
        (quiz::Illustration::Tracks { rutherford, angles }, _) => {
            Some(tracks_picture(rutherford, *angles))
        }
        (quiz::Illustration::Nothing, _) => None,
    }
}

/// The hit of a question as it really goes, with all its figures.
pub(super) fn of_answer(question: &Question) -> Option<Svg> {
    let collision = match &question.form {
        Form::Shot(aim) => aim.with(aim.offset),
        _ => *question.picture.collision()?,
    };
    let shown = Shown {
        // It is given in the question, or said in the answer.
        offset: false,
        angle: true,
        line_of_impact: false,
        masses: true,
        numbers: true,
        speeds: true,
        after: After::Departures,
    };
    Some(hit_picture(&collision, &shown))
}
