//! The one explanation after an answer: first what was wrong with it, then why the
//! two go where they go.

use crate::physics::Outcome;

use super::words::{bare_degrees, bare_millimetres, degrees, significant, tenths};
use super::{Answer, Diagnosis, Given, Grade, Question, Ray, RayGrade, diagnose};

/// An explanation, to be shown as a title over a text.
#[derive(Debug, Clone, PartialEq)]
pub struct Explanation {
    /// The name of the misconception, or how the answer was: "right", "one is off".
    pub title: &'static str,
    /// The text, two to five short sentences.
    pub text: String,
    /// The misconception it begins with.
    pub diagnosis: Option<Diagnosis>,
}

/// Explains a question to a player who gave this answer.
pub fn explain(question: &Question, answer: &Answer) -> Explanation {
    let grade = Grade::new(question, answer);
    let diagnosis = diagnose(question, answer);
    let (title, opening) = match diagnosis {
        Some(Diagnosis { misconception, .. }) => (
            misconception.name,
            misconception.say(question, &answer.rays),
        ),
        None if grade.is_right() => ("right", "Right, and this is why.".into()),
        None => undiagnosed(question, answer, &grade),
    };
    Explanation {
        title,
        text: format!("{opening} {}", reasoning(question)),
        diagnosis,
    }
}

/// What to say of an answer that is off in its own way.
fn undiagnosed(question: &Question, answer: &Answer, grade: &Grade) -> (&'static str, String) {
    let name = question.pieces.target_name();
    let striker = off(question, answer, Ray::Striker, &grade.striker);
    let target = off(question, answer, Ray::Target, &grade.target);
    match (grade.striker.is_right(), grade.target.is_right()) {
        (true, _) => (
            "one is off",
            format!("The striker is right; the {name} {target}."),
        ),
        (_, true) => (
            "one is off",
            format!("The {name} is right; the striker {striker}."),
        ),
        _ => (
            "both are off",
            format!("The striker {striker}; the {name} {target}."),
        ),
    }
}

/// How a ray is off: "is 12.0° too wide", "does not stay still".
fn off(question: &Question, answer: &Answer, ray: Ray, grade: &RayGrade) -> String {
    let truth = question.truth();
    match (answer.rays.get(ray), truth.get(ray), grade.error) {
        (Some(said), Some(true_angle), Some(error)) => {
            // Straight ahead and straight back have no side.
            let has_side = tenths(true_angle.abs()) % 1800 != 0;
            let how = if has_side && said * true_angle < 0.0 {
                "off, on the wrong side"
            } else if said.abs() > true_angle.abs() {
                "too wide"
            } else {
                "too narrow"
            };
            format!("is {} {how}", degrees(error))
        }
        (_, None, _) => "stays still".into(),
        (None, ..) | (.., None) => "does not stay still".into(),
    }
}

/// Why the two go where they go, on the question's own figures.
pub fn reasoning(question: &Question) -> String {
    let outcome = question.outcome();
    if question.head_on() {
        return head_on(question, &outcome);
    }
    let name = question.pieces.target_name();
    let alpha = degrees(question.alpha().abs());
    let target = match question.given {
        Given::Angle { .. } => format!("The {name} leaves along the line of impact: {alpha}."),
        Given::Offset { offset_mm } => format!(
            "{} / {} = sin {alpha}: there lies the line of impact, and the {name} leaves along it.",
            bare_millimetres(offset_mm.abs()),
            bare_millimetres(question.reach_mm())
        ),
    };
    format!("{target} {}", striker(question, &outcome))
}

/// The striker's part, by its velocity along the line of impact and across it.
fn striker(question: &Question, outcome: &Outcome) -> String {
    let (Some(normal), Some(tangent), Some(theta1), Some(separation)) = (
        outcome.normal,
        outcome.tangent,
        outcome.theta1,
        outcome.separation,
    ) else {
        return String::new();
    };
    let alpha = bare_degrees(question.alpha().abs());
    let theta1 = degrees(theta1.abs());
    let along = outcome.v1.dot(normal);
    let across = significant(outcome.v1.dot(tangent).abs());
    // Rounding noise against the speed of the striker.
    if along.abs() <= 1e-9 * question.speed {
        return format!(
            "Along it the striker gives up all it had. It keeps its part across, square to \
             the line: 90 - {alpha} = {theta1}."
        );
    }
    let rest = significant(along.abs());
    let rest = if along > 0.0 {
        format!("along it {rest} m/s is left")
    } else {
        format!("along it, it bounces at {rest} m/s")
    };
    format!(
        "Across the line the striker keeps {across} m/s; {rest}. So the two part by \
         {separation}: {bare} - {alpha} = {theta1}.",
        separation = degrees(separation),
        bare = bare_degrees(separation),
    )
}

fn head_on(question: &Question, outcome: &Outcome) -> String {
    let name = question.pieces.target_name();
    let before = question.collision().u1;
    let v1 = significant(outcome.v1.length());
    let v2 = significant(outcome.v2.length());
    let striker = match outcome.theta1 {
        None => "With equal masses and no loss they exchange velocities: the striker stops".into(),
        Some(_) if outcome.v1.dot(before) > 0.0 => {
            format!("The heavier striker is slowed but goes on, at {v1} m/s")
        }
        Some(_) => format!("The lighter striker is thrown straight back, at {v1} m/s"),
    };
    format!("Head-on, all stays on one line. {striker}, and the {name} leaves at {v2} m/s.")
}

#[cfg(test)]
mod tests {
    use super::super::{Confidence, Pieces, Rays};
    use super::*;

    fn explained(pieces: Pieces, alpha_deg: f64, striker: Option<f64>, target: f64) -> String {
        let question = Question {
            pieces,
            given: Given::Angle { alpha_deg },
            restitution: 1.0,
            speed: 3.0,
            direction_deg: 0.0,
        };
        let answer = Answer {
            rays: Rays {
                striker: striker.map(f64::to_radians),
                target: Some(target.to_radians()),
            },
            confidence: Confidence::Sure,
        };
        let explanation = explain(&question, &answer);
        format!("[{}] {}", explanation.title, explanation.text)
    }

    #[test]
    fn the_figures_of_the_worked_examples() {
        // 15 g on 15 g, 30°: striker at 60°. 20 g on 40 g, 3 m/s, 45°: v1 is the sum of
        // 3/√2 m/s across and 1/√2 m/s back along the line, at atan 2; 108.4° apart.
        let equal = explained(Pieces::Equal, 30.0, Some(60.0), 30.0);
        assert_eq!(
            equal,
            "[right] Right, and this is why. The coin leaves along the line of impact: 30.0°. \
             Along it the striker gives up all it had. It keeps its part across, square to the \
             line: 90 - 30.0 = 60.0°."
        );
        let marbles = explained(Pieces::Marbles, 45.0, Some(63.4), 45.0);
        assert_eq!(
            marbles,
            "[right] Right, and this is why. The marble leaves along the line of impact: 45.0°. \
             Across the line the striker keeps 2.12 m/s; along it, it bounces at 0.707 m/s. So \
             the two part by 108.4°: 108.4 - 45.0 = 63.4°."
        );
    }

    #[test]
    fn an_answer_off_in_its_own_way() {
        for (pieces, alpha_deg, striker, target, start) in [
            (
                Pieces::Equal,
                30.0,
                Some(80.0),
                30.0,
                "[one is off] The coin is right; the striker is 20.0° too wide.",
            ),
            (
                Pieces::Equal,
                30.0,
                Some(60.0),
                -20.0,
                "[one is off] The striker is right; the coin is 50.0° off, on the wrong side.",
            ),
            (
                Pieces::Equal,
                30.0,
                None,
                20.0,
                "[both are off] The striker does not stay still; the coin is 10.0° too narrow.",
            ),
            (
                Pieces::Equal,
                0.0,
                Some(20.0),
                0.0,
                "[one is off] The coin is right; the striker stays still.",
            ),
            (
                Pieces::Marbles,
                0.0,
                Some(-170.0),
                0.0,
                "[one is off] The marble is right; the striker is 10.0° too narrow.",
            ),
        ] {
            let text = explained(pieces, alpha_deg, striker, target);
            assert!(text.starts_with(start), "{text}");
        }
    }
}
