//! The form in which answers are stored in files and databases.

use serde_json::{Value, json};

use super::{Figures, Form, Measure, Rays, Response, figures};
use crate::physics::units::mm_from_m;

/// The field that stores the text of a choice, because the position of a choice depends on the
/// round.
const CHOICE: &str = "choice";
const OFFSET: &str = "offset_mm";
/// The maximum number of characters in a choice. At present a choice can have at most 90; the rest
/// is room for future questions.
const LONGEST_CHOICE: usize = 400;

impl Form {
    /// The stored form of an answer to a question with this form.
    pub fn kept(&self, said: &Response) -> Figures {
        figures(match (self, said) {
            (_, Response::Rays(rays)) => rays.json(),
            (Self::Number { quantity, .. }, Response::Number(x)) => json!({ quantity.id(): x }),
            (_, Response::Shot(offset)) => json!({ OFFSET: mm_from_m(*offset) }),
            _ => json!({ CHOICE: self.words(said) }),
        })
    }

    /// Whether a stored answer is possible in the quiz: it must be of a known kind and in the
    /// widest range for that kind.
    pub fn could_be_kept(answer: &Figures) -> bool {
        if let Some(rays) = Rays::of_figures(answer) {
            return answer.len() == 2 && rays.are_in_range();
        }
        let mut fields = answer.iter();
        let (Some((name, value)), None) = (fields.next(), fields.next()) else {
            return false;
        };
        match (value, value.as_f64()) {
            (Value::String(words), _) => {
                name == CHOICE && (1..=LONGEST_CHOICE).contains(&words.chars().count())
            }
            (_, Some(x)) => match Measure::with_id(name) {
                Some(measure) => measure.allows(x),
                None => name == OFFSET && x.abs() <= Measure::Length.largest(),
            },
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn could_be(text: &str) -> bool {
        serde_json::from_str(text).is_ok_and(|answer| Form::could_be_kept(&answer))
    }

    #[test]
    fn answers_in_range_can_be_kept_and_others_cannot() {
        for answer in [
            r#"{"theta1_deg": 60.0, "theta2_deg": null}"#,
            r#"{"theta1_deg": -180, "theta2_deg": 180.00000000000003}"#,
            r#"{"choice": "less than 90°"}"#,
            r#"{"angle_deg": -12}"#,
            r#"{"share_percent": 100}"#,
            r#"{"offset_mm": -21.5}"#,
        ] {
            assert!(could_be(answer), "{answer}");
        }
        let long = format!(r#"{{"choice": "{}"}}"#, "x".repeat(500));
        for answer in [
            "{}",
            r#"{"theta1_deg": 200, "theta2_deg": 0}"#,
            r#"{"theta1_deg": 20}"#,
            r#"{"theta1_deg": 20, "theta2_deg": 0, "choice": "a"}"#,
            r#"{"theta1_deg": "=1", "theta2_deg": 0}"#,
            r#"{"choice": 99}"#,
            r#"{"choice": ""}"#,
            &long,
            r#"{"angle_deg": 1e999}"#,
            r#"{"angle_deg": NaN}"#,
            r#"{"angle_deg": 181}"#,
            r#"{"share_percent": -1}"#,
            r#"{"speed": 1e300}"#,
            r#"{"offset_mm": 1e300}"#,
            r#"{"offset_mm": true}"#,
            r#"{"unheard_of": 1}"#,
            r#"{"unheard_of": "x"}"#,
        ] {
            assert!(!could_be(answer), "{answer}");
        }
    }
}
