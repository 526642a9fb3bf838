//! What is kept of an answer at a checkpoint.

use serde_json::{Value, json};

use crate::lessons::{Chapter, Checkpoint, CheckpointAnswer, CheckpointKind};
use crate::physics::Collision;
use crate::physics::units::deg_from_rad;
use crate::progress::{Attempt, LESSON};
use crate::quiz::{Ray, Rays};

/// An answer to the checkpoint of page `at` (from 0), marked; `figure` is the collision
/// as the page's figure has it.
pub fn attempt(
    player: &str,
    chapter: &Chapter,
    at: usize,
    answer: &CheckpointAnswer,
    checkpoint: &Checkpoint,
    figure: Option<&Collision>,
) -> Attempt {
    let (asked, truth) = truly(&checkpoint.asked, figure);
    let number = u32::try_from(at + 1).unwrap_or(u32::MAX);
    let question = json!({"chapter": chapter.id, "page": number, "asked": asked});
    Attempt {
        time_s: None,
        player: player.to_owned(),
        family: LESSON.to_owned(),
        topic: chapter.title.clone(),
        seed: 0,
        number,
        question: question.to_string(),
        answer: answer.json().to_string(),
        truth: truth.to_string(),
        error_deg: error_deg(answer, &checkpoint.asked, figure),
        credit: answer.credit(checkpoint, figure),
        right: answer.is_right(checkpoint, figure),
        confidence: None,
        misconception: None,
    }
}

/// How the answer is given, and the right one.
fn truly(asked: &CheckpointKind, figure: Option<&Collision>) -> (&'static str, Value) {
    match asked {
        CheckpointKind::Rays => (
            "rays",
            true_rays(figure).map_or(Value::Null, |rays| rays.json()),
        ),
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

fn true_rays(figure: Option<&Collision>) -> Option<Rays> {
    figure.map(|collision| Rays::from(&collision.outcome()))
}

/// How far off the angle was, or of both rays the one furthest off.
fn error_deg(
    answer: &CheckpointAnswer,
    asked: &CheckpointKind,
    figure: Option<&Collision>,
) -> Option<f64> {
    match (answer, asked) {
        (CheckpointAnswer::Rays(rays), CheckpointKind::Rays) => {
            let truth = true_rays(figure)?;
            let errors = Ray::BOTH.map(|ray| rays.apart(&truth, ray));
            errors
                .into_iter()
                .flatten()
                .reduce(f64::max)
                .map(deg_from_rad)
        }
        (CheckpointAnswer::Number(number), CheckpointKind::Number { expected, .. }) => {
            let (_, unit) = expected.sign_and_unit();
            let error = (number - expected.value(figure)?).abs();
            (unit == "°").then_some(error)
        }
        _ => None,
    }
}
