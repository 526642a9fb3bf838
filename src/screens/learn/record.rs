//! What is kept of an answer at a checkpoint.

use serde_json::{Value, json};

use crate::lessons::{AFTER_HINT, Chapter, Checkpoint, CheckpointKind, answer_json};
use crate::physics::Collision;
use crate::physics::units::deg_from_rad;
use crate::progress::{Attempt, LESSON};
use crate::quiz::{Rays, RaysGrade, Response};

/// An answer to the checkpoint of page `at` (from 0), marked; `figure` is the collision
/// as the page's figure has it. After a hint it earns half the credit.
pub fn attempt(
    player: &str,
    chapter: &Chapter,
    at: usize,
    (answer, after_hint): (&Response, bool),
    checkpoint: &Checkpoint,
    figure: Option<&Collision>,
) -> Attempt {
    let (asked, truth) = truly(&checkpoint.asked, figure);
    let number = u32::try_from(at + 1).unwrap_or(u32::MAX);
    let mut question = json!({"chapter": chapter.id, "page": number, "asked": asked});
    if after_hint {
        question["try"] = 2.into();
    }
    let share = if after_hint { AFTER_HINT } else { 1.0 };
    Attempt {
        time_s: None,
        player: player.to_owned(),
        family: LESSON.to_owned(),
        topic: chapter.title.clone(),
        seed: 0,
        number,
        question: question.to_string(),
        answer: answer_json(answer).to_string(),
        truth: truth.to_string(),
        error_deg: error_deg(answer, &checkpoint.asked, figure),
        credit: share * checkpoint.credit(answer, figure),
        right: checkpoint.is_right(answer, figure),
        confidence: None,
        misconception: None,
    }
}

/// How the answer is given, and the right one.
fn truly(asked: &CheckpointKind, figure: Option<&Collision>) -> (&'static str, Value) {
    match asked {
        CheckpointKind::Rays => {
            let truth = figure.map(|collision| Rays::from(&collision.outcome()).json());
            ("rays", truth.unwrap_or_default())
        }
        CheckpointKind::Number { expected, .. } => {
            let (_, unit) = expected.sign_and_unit();
            let number = expected.value(figure);
            ("number", json!({"number": number, "unit": unit}))
        }
        CheckpointKind::Choice(choices) => {
            let right = choices.iter().position(|choice| choice.right);
            ("choice", json!({"choice": right.map(|line| line + 1)}))
        }
    }
}

/// How far off the angle was, or of both rays the one furthest off.
fn error_deg(answer: &Response, asked: &CheckpointKind, figure: Option<&Collision>) -> Option<f64> {
    match (answer, asked) {
        (Response::Rays(rays), CheckpointKind::Rays) => {
            let grade = RaysGrade::new(rays, &Rays::from(&figure?.outcome()));
            grade.error().map(deg_from_rad)
        }
        (Response::Number(number), CheckpointKind::Number { expected, .. }) => {
            let (_, unit) = expected.sign_and_unit();
            let error = (number - expected.value(figure)?).abs();
            (unit == "°").then_some(error)
        }
        _ => None,
    }
}
