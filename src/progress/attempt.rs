//! One answer, with all that is known of it.

use serde_json::{Value, json};

use crate::physics::units::{deg_from_rad, g_from_kg, mm_from_m};
use crate::quiz::{Answer, Confidence, Given, Grade, Question, Rays, diagnose};

/// The family of all questions that chapters ask.
pub const LESSON: &str = "lesson";

/// One answer, with all that is known of it. Nothing of it is particular to the quiz:
/// whatever asks a question can note what was answered.
#[derive(Debug, Clone, PartialEq)]
pub struct Attempt {
    /// When, in seconds since 1970 began (UTC). Noted by whoever keeps it; `None`
    /// before that, and where nobody knows the time.
    pub time_s: Option<i64>,
    /// Who.
    pub player: String,
    /// The family of the question, by its name in files: "where-to", or [`LESSON`].
    pub family: String,
    /// What it was about: "equal masses, by offset", or the title of the chapter.
    pub topic: String,
    /// The code of the round; 0 where there is none.
    pub seed: u64,
    /// Its place in the round, or the page of the chapter, from 1.
    pub number: u32,
    /// The figures of the question: a JSON object, with the units in the names.
    pub question: String,
    /// What was answered, likewise.
    pub answer: String,
    /// What is true, likewise.
    pub truth: String,
    /// How far off the angle was, in degrees, or of several the one furthest off;
    /// `None` where there was no angle to be off.
    pub error_deg: Option<f64>,
    /// Credit from 0 to 1.
    pub credit: f64,
    /// Whether it counts as right.
    pub right: bool,
    /// How sure the player was; `None` where that is not asked.
    pub confidence: Option<Confidence>,
    /// The misconception it fits, by its name in files.
    pub misconception: Option<String>,
}

impl Attempt {
    /// An answer to question `number` (from 1) of the quiz's round `seed`.
    pub fn of_quiz(
        player: &str,
        seed: u64,
        number: u32,
        question: &Question,
        answer: &Answer,
    ) -> Self {
        let grade = Grade::new(question, answer);
        let errors = [grade.striker.error, grade.target.error];
        Self {
            time_s: None,
            player: player.to_owned(),
            family: question.family().id().to_owned(),
            topic: question.topic(),
            seed,
            number,
            question: figures(question),
            answer: angles(&answer.rays).to_string(),
            truth: angles(&question.truth()).to_string(),
            error_deg: errors
                .into_iter()
                .flatten()
                .reduce(f64::max)
                .map(deg_from_rad),
            credit: grade.credit(),
            right: grade.is_right(),
            confidence: Some(answer.confidence),
            misconception: diagnose(question, answer)
                .map(|diagnosis| diagnosis.misconception.id.to_owned()),
        }
    }

    /// Whether the player was sure, and wrong: what is worth most attention.
    pub fn is_surely_wrong(&self) -> bool {
        self.confidence == Some(Confidence::Sure) && !self.right
    }
}

/// All that fixes a question of the quiz.
fn figures(question: &Question) -> String {
    let (striker, target) = (question.pieces.striker(), question.pieces.target());
    let mut figures = json!({
        "m1_g": g_from_kg(striker.mass),
        "m2_g": g_from_kg(target.mass),
        "r1_mm": mm_from_m(striker.radius),
        "r2_mm": mm_from_m(target.radius),
        "restitution": question.restitution,
        "speed": question.speed,
        "direction_deg": question.direction_deg,
    });
    match question.given {
        Given::Angle { alpha_deg } => figures["alpha_deg"] = alpha_deg.into(),
        Given::Offset { offset_mm } => figures["offset_mm"] = offset_mm.into(),
    }
    figures.to_string()
}

/// Both angles in degrees, with names and signs as `carrom solve` gives them.
pub fn angles(rays: &Rays) -> Value {
    json!({
        "theta1_deg": rays.striker.map(deg_from_rad),
        "theta2_deg": rays.target.map(deg_from_rad),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quiz::{Pieces, Ray};

    const QUESTION: Question = Question {
        pieces: Pieces::Equal,
        given: Given::Angle { alpha_deg: 30.0 },
        restitution: 1.0,
        speed: 4.0,
        direction_deg: 90.0,
    };

    fn attempt(theta1_deg: f64, theta2_deg: f64) -> Attempt {
        let answer = Answer {
            rays: Rays::new(theta1_deg.to_radians(), theta2_deg.to_radians()),
            confidence: Confidence::Sure,
        };
        Attempt::of_quiz("Ada", 7, 3, &QUESTION, &answer)
    }

    #[test]
    fn all_that_is_known_is_noted() {
        let right = attempt(60.0, 30.0);
        assert!(right.right && !right.is_surely_wrong());
        assert!((right.credit - 1.0).abs() < 1e-12);
        assert!(right.error_deg.unwrap() < 1e-9);
        assert_eq!(right.misconception, None);
        // Equal masses without loss part at a right angle: 60° and 30°.
        let truth: Value = serde_json::from_str(&right.truth).unwrap();
        assert!((truth["theta1_deg"].as_f64().unwrap() - 60.0).abs() < 1e-9);
        assert!((truth["theta2_deg"].as_f64().unwrap() - 30.0).abs() < 1e-9);
        let figures: Value = serde_json::from_str(&right.question).unwrap();
        assert_eq!(figures["alpha_deg"].as_f64(), Some(30.0));
        assert_eq!(figures["direction_deg"].as_f64(), Some(90.0));
    }

    #[test]
    fn the_error_is_that_of_the_ray_furthest_off() {
        let copied = attempt(30.0, 30.0);
        assert!(copied.is_surely_wrong());
        assert!((copied.error_deg.unwrap() - 30.0).abs() < 1e-9);
        assert_eq!(copied.misconception.as_deref(), Some("copied-angle"));
        let rays = Rays {
            striker: None,
            ..QUESTION.truth()
        };
        let still = Answer {
            rays,
            confidence: Confidence::Guess,
        };
        let still = Attempt::of_quiz("Ada", 7, 3, &QUESTION, &still);
        // The striker has no angle to be off, but its answer is none the less wrong.
        assert!(rays.apart(&QUESTION.truth(), Ray::Striker).is_none());
        assert!(still.error_deg.unwrap() < 1e-9 && !still.right);
    }
}
