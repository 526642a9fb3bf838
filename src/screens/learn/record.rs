//! The record of an answer at a checkpoint.

use serde_json::json;

use crate::lessons::{AFTER_HINT, Chapter, answer_json};
use crate::physics::units::deg_from_rad;
use crate::progress::{Attempt, LESSON, REVIEWED_BY};
use crate::quiz::{Form, Response, Topic, figures};

/// The marked answer to the checkpoint of page `at` (counted from 0), a question of this `form`.
/// After a hint, an answer earns half the credit.
pub fn attempt(
    player: &str,
    chapter: &Chapter,
    at: usize,
    form: &Form,
    (answer, after_hint): (&Response, bool),
) -> Attempt {
    let mut truth = answer_json(&form.truth());
    let asked = match form {
        Form::Rays { .. } => "rays",
        Form::Number { quantity, .. } => {
            truth["unit"] = quantity.unit().into();
            "number"
        }
        _ => "choice",
    };
    let number = u32::try_from(at + 1).unwrap_or(u32::MAX);
    let mut question = json!({"chapter": chapter.id, "page": number, "asked": asked});
    if after_hint {
        question["try"] = 2.into();
    }
    let page = chapter.pages.get(at).map_or("", |page| &page.title);
    if let Some(topic) = Topic::of_checkpoint(&chapter.id, page) {
        question[REVIEWED_BY] = topic.id().into();
    }
    let share = if after_hint { AFTER_HINT } else { 1.0 };
    Attempt {
        time_s: None,
        player: player.to_owned(),
        family: LESSON.to_owned(),
        topic: chapter.title.clone(),
        seed: 0,
        number,
        question: figures(question),
        answer: figures(answer_json(answer)),
        truth: figures(truth),
        error_deg: form.angle_error(answer).map(deg_from_rad),
        credit: share * form.credit(answer),
        right: form.is_right(answer),
        confidence: None,
        misconception: None,
    }
}
