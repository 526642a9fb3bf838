//! An answer as it is kept in files and databases.

use serde_json::{Value, json};

use super::{Figures, Form, Measure, Rays, Response, figures};
use crate::physics::units::mm_from_m;

/// Where the words of a choice are kept: its place among the others is the round's alone.
const CHOICE: &str = "choice";
const OFFSET: &str = "offset_mm";
/// Most letters of a choice. Those of questions have at most 90; this also holds those of years
/// to come.
const LONGEST_CHOICE: usize = 400;

impl Form {
    /// An answer to a question of this form as it is kept.
    pub fn kept(&self, said: &Response) -> Figures {
        figures(match (self, said) {
            (_, Response::Rays(rays)) => rays.json(),
            (Self::Number { quantity, .. }, Response::Number(x)) => json!({ quantity.id(): x }),
            (_, Response::Shot(offset)) => json!({ OFFSET: mm_from_m(*offset) }),
            _ => json!({ CHOICE: self.words(said) }),
        })
    }

    /// Whether an answer that was kept can have been given to a question of some form: it is of
    /// one kind and in the range of that kind, as for [`Form::accepts`].
    pub fn could_be_kept(answer: &Figures) -> bool {
        let number = |(name, value): (&String, &Value)| {
            let x = value.as_f64()?;
            match Measure::with_id(name) {
                Some(measure) => Some(measure.allows(x)),
                None => Some(name == OFFSET && x.abs() <= Measure::Length.largest()),
            }
        };
        if let Some(rays) = Rays::of_figures(answer) {
            return answer.len() == 2 && rays.are_in_range();
        }
        let mut fields = answer.iter();
        let (Some(field), None) = (fields.next(), fields.next()) else {
            return false;
        };
        match field {
            (name, Value::String(words)) => {
                name == CHOICE && (1..=LONGEST_CHOICE).contains(&words.chars().count())
            }
            field => number(field).unwrap_or(false),
        }
    }
}
