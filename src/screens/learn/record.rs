//! The record of an answer at a checkpoint.

use serde_json::json;

use crate::lessons::{AFTER_HINT, Chapter, answer_json};
use crate::physics::Collision;
use crate::physics::units::deg_from_rad;
use crate::progress::{Attempt, LESSON, REVIEWED_BY};
use crate::quiz::{Form, Response, Topic, figures};

/// The marked answer to the checkpoint of page `at` (counted from 0), a question of this `form`
/// about the collision in the page's `figure`. After a hint, an answer earns half the credit.
pub fn attempt(
    player: &str,
    chapter: &Chapter,
    at: usize,
    (form, figure): (&Form, Option<&Collision>),
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
    let attempt = Attempt {
        player: player.to_owned(),
        family: LESSON.to_owned(),
        topic: chapter.title.clone(),
        number,
        question: figures(question),
        answer: figures(answer_json(answer)),
        truth: figures(truth),
        error_deg: form.angle_error(answer).map(deg_from_rad),
        credit: share * form.credit(answer),
        right: form.is_right(answer),
        ..Attempt::default()
    };
    match (figure.filter(|_| !after_hint), answer) {
        (Some(collision), Response::Rays(rays)) => attempt.with_evidence_of_rays(collision, rays),
        _ => attempt,
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;
    use crate::lessons::ChapterLibrary;
    use crate::physics::Disc;
    use crate::physics::units::rad_from_deg;
    use crate::progress::beliefs;
    use crate::quiz::{Misconception, Rays};

    /// The answer of 45° and 45° to a question of chapter 6 about unequal masses.
    fn half_and_half(u2: DVec2, after_hint: bool) -> Attempt {
        let (striker, target) = (Disc::from_g_mm(15.0, 20.65), Disc::from_g_mm(5.5, 15.9));
        let collision = Collision {
            u2,
            ..Collision::at_offset(striker, target, DVec2::X, 0.018)
        };
        let form = Form::Rays {
            truth: Rays::from(&collision.outcome()),
            side: collision.side(),
            target: "coin",
        };
        let side = collision.side() * rad_from_deg(45.0);
        let answer = Response::Rays(Rays::new(side, side));
        let library = ChapterLibrary::embedded_once();
        let chapter = library
            .chapters
            .iter()
            .find(|it| it.id == "marbles")
            .unwrap();
        let at = (&form, Some(&collision));
        attempt("Ada", chapter, 0, at, (&answer, after_hint))
    }

    #[test]
    fn two_wrong_rays_in_chapters_are_evidence_for_a_misconception() {
        let first = half_and_half(DVec2::ZERO, false);
        assert_eq!(first.shows(), Some(Misconception::HalfAndHalf));
        let second = Attempt {
            number: 2,
            ..first.clone()
        };
        let named: Vec<_> = beliefs(&[first, second])
            .iter()
            .map(|it| it.misconception)
            .collect();
        assert_eq!(named, [Misconception::HalfAndHalf]);
    }

    #[test]
    fn rays_after_a_hint_or_for_two_moving_discs_are_no_evidence() {
        assert_eq!(half_and_half(DVec2::ZERO, true).shows(), None);
        assert_eq!(half_and_half(0.1 * DVec2::Y, false).shows(), None);
    }
}
