//! How good an answer at a checkpoint is, and how it is kept.

use serde_json::{Value, json};

use super::{Checkpoint, CheckpointKind, GivenAnswer};
use crate::physics::Collision;
use crate::quiz::{Rays, RaysGrade, Response};

impl Checkpoint {
    /// Credit from 0 to 1 for an answer. `figure` is the collision as the page's figure
    /// has it.
    ///
    /// Rays are marked as in the quiz. A number earns full credit within the
    /// tolerance, and then less in a straight line, down to none at four times it.
    pub fn credit(&self, said: &Response, figure: Option<&Collision>) -> f64 {
        match (said, &self.asked) {
            (Response::Rays(rays), CheckpointKind::Rays) => {
                grade(rays, figure).map_or(0.0, |grade| grade.credit())
            }
            (
                Response::Number(number),
                CheckpointKind::Number {
                    expected,
                    tolerance,
                },
            ) => {
                let truth = expected.value(figure).unwrap_or(f64::INFINITY);
                let beyond = (number - truth).abs() / tolerance - 1.0;
                (1.0 - (beyond - ROUNDING).max(0.0) / 3.0).max(0.0)
            }
            (Response::Choice(chosen), CheckpointKind::Choice(choices)) => {
                let right = choices.get(*chosen).is_some_and(|choice| choice.right);
                f64::from(u8::from(right))
            }
            _ => 0.0,
        }
    }

    /// Whether it can be answered so: of the kind that is asked for, with rays in their range and a
    /// choice that is there. What a file or a database holds is checked here before it is used.
    pub fn accepts(&self, said: &Response) -> bool {
        match (&self.asked, said) {
            (CheckpointKind::Rays, Response::Rays(rays)) => rays.are_in_range(),
            (CheckpointKind::Number { .. }, Response::Number(number)) => number.is_finite(),
            (CheckpointKind::Choice(choices), Response::Choice(line)) => *line < choices.len(),
            _ => false,
        }
    }

    /// Whether a first answer gets a hint and a second try: it is wrong, there is something
    /// to say, and more than one answer is left.
    pub fn offers_second_try(&self, said: &Response, figure: Option<&Collision>) -> bool {
        !self.is_right(said, figure)
            && match &self.asked {
                CheckpointKind::Choice(choices) => choices.len() > 2,
                _ => !self.hint.is_empty(),
            }
    }

    /// Whether an answer counts as right.
    pub fn is_right(&self, said: &Response, figure: Option<&Collision>) -> bool {
        match said {
            Response::Rays(rays) => grade(rays, figure).is_some_and(|grade| grade.is_right()),
            _ => self.credit(said, figure) >= 1.0,
        }
    }
}

/// Share of the credit that an answer after a hint earns.
pub const AFTER_HINT: f64 = 0.5;

/// An answer as it is kept: angles in degrees, a line of a choice counted from 1.
pub fn answer_json(said: &Response) -> Value {
    match said {
        Response::Rays(rays) => rays.json(),
        Response::Number(number) => json!({"number": number}),
        Response::Choice(line) => json!({"choice": line + 1}),
        // No checkpoint asks for one.
        Response::Shot(_) => Value::Null,
    }
}

/// An answer at a checkpoint as it is kept, with the first try where there was one.
pub(crate) fn given_json(given: &GivenAnswer) -> Value {
    let mut value = answer_json(&given.answer);
    if let (Some(first), Some(object)) = (&given.first, value.as_object_mut()) {
        object.insert("first".into(), answer_json(first));
    }
    value
}

/// Both tries as [`given_json`] writes them.
pub(crate) fn tries_of_json(value: &Value) -> Option<(Response, Option<Response>)> {
    let first = value.get("first").and_then(answer_of_json);
    Some((answer_of_json(value)?, first))
}

/// An answer as [`answer_json`] writes it; `None` if it is none.
pub fn answer_of_json(value: &Value) -> Option<Response> {
    if let Some(number) = value.get("number") {
        let number = number.as_f64().filter(|it| it.is_finite());
        return number.map(Response::Number);
    }
    if let Some(line) = value.get("choice") {
        let line = usize::try_from(line.as_u64()?).ok()?;
        return line.checked_sub(1).map(Response::Choice);
    }
    Rays::of_json(value).map(Response::Rays)
}

/// A number on the very edge of the tolerance is right, whatever rounding left of it.
const ROUNDING: f64 = 1e-9;

fn grade(rays: &Rays, figure: Option<&Collision>) -> Option<RaysGrade> {
    let truth = Rays::from(&figure?.outcome());
    Some(RaysGrade::new(rays, &truth))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quiz::Ray;

    #[test]
    fn both_tries_are_read_as_they_are_written_and_one_alone_as_ever() {
        for first in [None, Some(Response::Choice(2))] {
            let given = GivenAnswer {
                asked: "Which?".into(),
                answer: Response::Choice(1),
                right: true,
                first,
            };
            let read = tries_of_json(&given_json(&given));
            assert_eq!(read, Some((given.answer, first)));
        }
        // As it was written before there were second tries.
        let before = serde_json::from_str("{\"choice\":2}").unwrap();
        assert_eq!(tries_of_json(&before), Some((Response::Choice(1), None)));
    }

    #[test]
    fn an_answer_is_read_as_it_is_written() {
        let still = Rays {
            striker: None,
            target: Some(0.5),
        };
        for answer in [
            Response::Number(-0.1),
            Response::Choice(0),
            Response::Choice(4),
            Response::Rays(Rays::new(0.0, -1.0)),
            Response::Rays(still),
        ] {
            let text = answer_json(&answer).to_string();
            let read: Value = serde_json::from_str(&text).unwrap();
            match (answer_of_json(&read), answer) {
                (Some(Response::Rays(read)), Response::Rays(said)) => {
                    for ray in Ray::BOTH {
                        let apart = read.apart(&said, ray).unwrap();
                        assert!(apart < 1e-12, "{text}");
                    }
                }
                (read, said) => assert_eq!(read, Some(said)),
            }
        }
        for nonsense in [
            "{}",
            "3",
            "{\"choice\":0}",
            "{\"choice\":-1}",
            "{\"number\":\"x\"}",
            "{\"theta1_deg\":1e300,\"theta2_deg\":0}",
            "{\"theta1_deg\":1}",
        ] {
            let read: Value = serde_json::from_str(nonsense).unwrap();
            assert_eq!(answer_of_json(&read), None, "{nonsense}");
        }
    }
}
