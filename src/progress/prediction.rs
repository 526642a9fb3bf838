//! Predictions, made outside the quiz, of where two discs go after a collision: calls at the table,
//! predictions in levels, and rays at the checkpoints of chapters.

use glam::DVec2;
use serde_json::{Value, json};

use super::Attempt;
use crate::physics::units::deg_from_rad;
use crate::physics::{Collision, Meeting};
use crate::quiz::{
    Answer, Confidence, Figures, Hit, Question, Ray, RayGrade, Rays, RaysGrade, Response, figures,
};

/// The family to which all calls at the table belong.
pub const TABLE: &str = "table";

/// The family to which all predictions in levels belong.
pub const LEVEL: &str = "level";

/// Where a collision was predicted, and by whom.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Predicted<'a> {
    pub(crate) player: &'a str,
    /// The family, which is [`TABLE`] or [`LEVEL`].
    pub(crate) family: &'static str,
    pub(crate) seed: u64,
    /// The number of the move or of the level, from 1.
    pub(crate) number: u32,
    /// The ray that was predicted, if only one was.
    pub(crate) only: Option<Ray>,
}

impl Attempt {
    /// Grades the prediction of a collision as in the quiz; `None` if the quiz never asks for both
    /// rays of such a collision, because the target moves or the discs miss or only graze each
    /// other.
    pub(crate) fn of_prediction(
        predicted: &Predicted,
        collision: &Collision,
        said: &Rays,
    ) -> Option<Self> {
        let question = question_about(collision)?;
        let hit = Hit::from(collision);
        let truth = hit.truth();
        let mut attempt = Self {
            player: predicted.player.to_owned(),
            family: predicted.family.to_owned(),
            topic: hit.reviewed_as().id().to_owned(),
            seed: predicted.seed,
            number: predicted.number,
            question: question.figures,
            ..Self::default()
        };
        let Some(ray) = predicted.only else {
            let grade = RaysGrade::new(said, &truth);
            [attempt.answer, attempt.truth] = [said, &truth].map(|rays| figures(rays.json()));
            attempt.error_deg = grade.error().map(deg_from_rad);
            (attempt.credit, attempt.right) = (grade.credit(), grade.is_right());
            return Some(attempt.with_evidence_of_rays(collision, said));
        };
        let error = said.apart(&truth, ray);
        let grade = RayGrade { error };
        let angles = [said, &truth].map(|rays| rays.get(ray));
        [attempt.answer, attempt.truth] = one_ray(ray, angles);
        attempt.error_deg = error.map(deg_from_rad);
        (attempt.credit, attempt.right) = (grade.credit(), grade.is_right());
        let name = match ray {
            Ray::Striker => "striker",
            Ray::Target => "target",
        };
        attempt.question.insert("ray".into(), name.into());
        Some(attempt)
    }

    /// This attempt with the evidence for misconceptions from both predicted rays, if the quiz
    /// could have a question about the collision.
    pub(crate) fn with_evidence_of_rays(self, collision: &Collision, said: &Rays) -> Self {
        match question_about(collision).filter(Question::is_clear) {
            Some(question) => {
                // The evidence does not depend on the confidence.
                let answer = Answer::new(Response::Rays(*said), Confidence::ThinkSo);
                self.with_evidence(&question, &answer)
            }
            None => self,
        }
    }
}

/// The quiz's question about both rays of a collision; the quiz asks for both rays only after hits
/// on a target at rest.
fn question_about(collision: &Collision) -> Option<Question> {
    let is_hit = collision.u2 == DVec2::ZERO && collision.outcome().meeting == Meeting::Hit;
    is_hit.then(|| Question::from(&Hit::from(collision)))
}

/// The predicted and the true direction of one disc: two angles, or both in words if the disc is at
/// rest in the prediction or in reality and so has no angle there.
fn one_ray(ray: Ray, said_and_true: [Option<f64>; 2]) -> [Figures; 2] {
    let kept: [Value; 2] = match said_and_true {
        [Some(said), Some(truth)] => {
            [said, truth].map(|angle| json!({"angle_deg": deg_from_rad(angle)}))
        }
        angles => angles.map(|angle| json!({"choice": ray.words(angle)})),
    };
    kept.map(figures)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::Disc;
    use crate::physics::units::rad_from_deg;
    use crate::progress::beliefs;
    use crate::quiz::Misconception;

    /// A tournament striker hits a coin at rest, 18 mm off-centre.
    fn collision() -> Collision {
        let (striker, target) = (Disc::from_g_mm(15.0, 20.65), Disc::from_g_mm(5.5, 15.9));
        Collision::at_offset(striker, target, 3.0 * DVec2::X, 0.018)
    }

    fn predicted(number: u32, only: Option<Ray>) -> Predicted<'static> {
        Predicted {
            player: "Ada",
            family: TABLE,
            seed: 7,
            number,
            only,
        }
    }

    #[test]
    fn a_call_is_an_answer_to_the_quizs_question_about_such_a_hit() {
        let collision = collision();
        let truth = Rays::from(&collision.outcome());
        let right = Attempt::of_prediction(&predicted(1, None), &collision, &truth).unwrap();
        assert_eq!(right.fault(), None);
        assert_eq!(right.topic, "heavier-striker-by-offset");
        assert!(right.right && right.credit > 0.999 && right.error_deg.unwrap() < 1e-3);
        assert_eq!(right.question["m1_g"].as_f64(), Some(15.0));
        let side = collision.side() * rad_from_deg(45.0);
        let wrong = |number, only| {
            let rays = Rays::new(side, side);
            Attempt::of_prediction(&predicted(number, only), &collision, &rays).unwrap()
        };
        let named: Vec<_> = beliefs(&[wrong(1, None), wrong(2, None)])
            .iter()
            .map(|it| it.misconception)
            .collect();
        assert_eq!(named, [Misconception::HalfAndHalf]);
        // A single predicted ray is not counted as evidence for a misconception.
        assert!(beliefs(&[wrong(1, Some(Ray::Target)), wrong(2, Some(Ray::Target))]).is_empty());
    }

    #[test]
    fn one_predicted_ray_is_graded_alone() {
        let collision = collision();
        let truth = Rays::from(&collision.outcome());
        let said = Rays {
            striker: None,
            target: truth.target,
        };
        let only = |ray| Attempt::of_prediction(&predicted(1, Some(ray)), &collision, &said);
        let target = only(Ray::Target).unwrap();
        assert!(target.right && target.fault().is_none());
        assert!(target.answer.contains_key("angle_deg"));
        let striker = only(Ray::Striker).unwrap();
        assert!(!striker.right && striker.error_deg.is_none() && striker.fault().is_none());
        assert_eq!(striker.answer["choice"], "stays still");
        assert!(striker.truth["choice"].as_str().unwrap().contains('°'));
    }

    #[test]
    fn the_quiz_has_no_questions_about_two_moving_discs_or_a_miss() {
        let moving = Collision {
            u2: 0.1 * DVec2::Y,
            ..collision()
        };
        let miss = Collision {
            offset: 0.1,
            ..collision()
        };
        for collision in [moving, miss] {
            let said = Rays::new(0.1, 0.1);
            let attempt = Attempt::of_prediction(&predicted(1, None), &collision, &said);
            assert_eq!(attempt, None);
        }
    }
}
