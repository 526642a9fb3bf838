//! The explanation after an answer: first what was wrong with it, then why the right answer is
//! right.

use crate::numbers::{degrees, tenths};
use crate::quiz::question::{Answer, Form, Passage, Question, Ray, Rays, RaysGrade, Response};

/// An explanation, shown as a title with a text below it.
#[derive(Debug, Clone, PartialEq)]
pub struct Explanation {
    /// The name of the misconception, or a verdict on the answer: "right", "one is off".
    pub title: &'static str,
    /// The text, which has two to six short sentences.
    pub text: String,
    /// The page to read after a wrong answer: the page that corrects the misconception, or
    /// otherwise the page that teaches the topic.
    pub(crate) passage: Option<Passage>,
}

/// Explains the right answer to a player who gave `answer`.
pub fn explain(question: &Question, answer: &Answer) -> Explanation {
    let taught = question.topic.taught_for(&question.figures);
    let (title, opening, passage) = match question.belief_of(answer) {
        Some((belief, _)) => {
            let it = belief.misconception;
            (
                it.name(),
                belief.says.clone(),
                Some(it.settled_in(&question.topic, &question.figures)),
            )
        }
        None if question.form.is_right(&answer.said) => {
            ("right", "Right, and this is why.".into(), None)
        }
        None => {
            let (title, opening) = undiagnosed(question, answer);
            (title, opening, taught)
        }
    };
    Explanation {
        title,
        text: format!("{opening} {}", question.why).trim().to_owned(),
        passage,
    }
}

/// The title and the opening for a wrong answer that fits no misconception.
fn undiagnosed(question: &Question, answer: &Answer) -> (&'static str, String) {
    let form = &question.form;
    match (form, &answer.said) {
        (Form::Rays { truth, target, .. }, Response::Rays(said)) => rays_off(said, truth, target),
        (Form::Shot(aim), Response::Shot(offset)) => {
            let disc = match aim.ray {
                Ray::Striker => "striker",
                Ray::Target => "coin",
            };
            let way = match aim.error(*offset) {
                Some(error) => format!("The {disc} misses the mark by {}.", degrees(error)),
                None if aim.rays(*offset).is_some() => format!("The {disc} does not move."),
                None => "The striker misses: the offset is larger than r₁ + r₂.".into(),
            };
            ("off the mark", way)
        }
        (Form::Choice { .. }, Response::Choice(choice)) => {
            let reply = question.replies.get(choice).cloned();
            ("not that one", reply.unwrap_or_default())
        }
        (Form::Number { .. }, Response::Number(said))
            if form.is_right(&Response::Number(-said)) =>
        {
            let says = "The size is right, but the sign is not.";
            ("mind the sign", says.into())
        }
        _ => (
            "off",
            format!(
                "You said {}. The answer is {}.",
                form.words(&answer.said),
                form.words(&form.truth())
            ),
        ),
    }
}

/// Describes the errors in two rays that fit no misconception.
fn rays_off(said: &Rays, truth: &Rays, target: &str) -> (&'static str, String) {
    let [striker_off, target_off] = Ray::BOTH.map(|ray| off(said, truth, ray));
    let grade = RaysGrade::new(said, truth);
    match (grade.striker.is_right(), grade.target.is_right()) {
        (true, _) => (
            "one is off",
            format!("The striker is right; the {target} {target_off}."),
        ),
        (_, true) => (
            "one is off",
            format!("The {target} is right; the striker {striker_off}."),
        ),
        _ => {
            let sides = [&striker_off, &target_off].map(|off| off.strip_suffix(WRONG_SIDE));
            let how = match sides {
                [Some(striker), Some(other)] => {
                    format!("The striker {striker}, the {target} {other}, both{WRONG_SIDE}.")
                }
                _ => format!("The striker {striker_off}; the {target} {target_off}."),
            };
            ("both are off", how)
        }
    }
}

/// The remark about a ray on the wrong side of the striker's original direction.
const WRONG_SIDE: &str = " on the wrong side";

/// Describes the error in a ray: "is 12.0° too wide", "does move".
fn off(said: &Rays, truth: &Rays, ray: Ray) -> String {
    match (said.get(ray), truth.get(ray), said.apart(truth, ray)) {
        (Some(said), Some(true_angle), Some(error)) => {
            // A ray straight ahead or straight back is on neither side of the original direction.
            let has_side = tenths(true_angle.abs()) % 1800 != 0;
            let error = degrees(error);
            if has_side && said * true_angle < 0.0 {
                format!("is {error} off{WRONG_SIDE}")
            } else if said.abs() > true_angle.abs() {
                format!("is {error} too wide")
            } else {
                format!("is {error} too narrow")
            }
        }
        (_, None, _) => "should be at rest".into(),
        (None, ..) | (.., None) => "does move".into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::ImpactPoint;
    use crate::quiz::question::{Confidence, Hit, Pieces};

    fn explained(pieces: Pieces, alpha_deg: f64, striker: Option<f64>, target: f64) -> String {
        let question = Question::from(&Hit {
            pieces,
            given: ImpactPoint::Angle { alpha_deg },
            restitution: 1.0,
            speed: 3.0,
            direction_deg: 0.0,
        });
        let rays = Rays {
            striker: striker.map(f64::to_radians),
            target: Some(target.to_radians()),
        };
        let answer = Answer::new(Response::Rays(rays), Confidence::Sure);
        let explanation = explain(&question, &answer);
        format!("[{}] {}", explanation.title, explanation.text)
    }

    #[test]
    fn explanations_contain_the_figures_of_the_worked_examples() {
        // 15 g on 15 g at 30°: the striker leaves at 60°. 20 g on 40 g at 3 m/s and 45°: v₁ is the
        // sum of 3/√2 m/s along t and 1/√2 m/s backwards along n, so θ₁ = atan 2; the paths are
        // 108.4° apart.
        let equal = explained(Pieces::Equal, 30.0, Some(60.0), 30.0);
        assert_eq!(
            equal,
            "[right] Right, and this is why. The coin leaves along n, at α = 30.0°. \
             Along n the striker stops; it keeps its component along t, at 90° − 30.0° = 60.0°."
        );
        let marbles = explained(Pieces::Marbles, 45.0, Some(63.4), 45.0);
        assert_eq!(
            marbles,
            "[right] Right, and this is why. The marble leaves along n. The striker has 2.12 m/s \
             along t and −0.707 m/s along n: tan φ = 2.12/(−0.707), φ = 108.4° to n, θ₁ = 108.4° − \
             45.0° = 63.4°."
        );
    }

    #[test]
    fn an_answer_that_fits_no_misconception_gets_its_errors_described() {
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
                "[one is off] The striker is right; the coin is 50.0° off on the wrong side.",
            ),
            (
                Pieces::Equal,
                30.0,
                None,
                20.0,
                "[both are off] The striker does move; the coin is 10.0° too narrow.",
            ),
            (
                Pieces::Equal,
                0.0,
                Some(20.0),
                0.0,
                "[one is off] The coin is right; the striker should be at rest.",
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
