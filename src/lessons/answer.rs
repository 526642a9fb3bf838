//! Stored answers to checkpoints.

use serde_json::{Value, json};

use super::GivenAnswer;
use crate::quiz::{Rays, Response};

/// The fraction of the credit that an answer earns after a hint.
pub(crate) const AFTER_HINT: f64 = 0.5;

/// The stored form of an answer: angles are in degrees, and choices are counted from 1.
pub(crate) fn answer_json(said: &Response) -> Value {
    match said {
        Response::Rays(rays) => rays.json(),
        Response::Number(number) => json!({"number": number}),
        Response::Choice(line) => json!({"choice": line + 1}),
        // No checkpoint requires a shot.
        Response::Shot(_) => Value::Null,
    }
}

/// The stored form of an answer to a checkpoint, including the first try if there was one.
pub(crate) fn given_json(given: &GivenAnswer) -> Value {
    let mut value = answer_json(&given.answer);
    if let (Some(first), Some(object)) = (&given.first, value.as_object_mut()) {
        object.insert("first".into(), answer_json(first));
    }
    value
}

/// Reads the answer and the first try as written by [`given_json`].
pub(crate) fn tries_of_json(value: &Value) -> Option<(Response, Option<Response>)> {
    let first = value.get("first").and_then(answer_of_json);
    Some((answer_of_json(value)?, first))
}

/// Reads an answer as written by [`answer_json`]; `None` for anything else.
pub(crate) fn answer_of_json(value: &Value) -> Option<Response> {
    if let Some(number) = value.get("number") {
        let number = number.as_f64().filter(|it| it.is_finite());
        return number.map(Response::Number);
    }
    if let Some(line) = value.get("choice") {
        let line = usize::try_from(line.as_u64()?).ok()?;
        return line.checked_sub(1).map(Response::Choice);
    }
    Rays::of_figures(value.as_object()?).map(Response::Rays)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quiz::Ray;

    #[test]
    fn one_try_or_both_are_read_back_as_they_were_written() {
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
        // This is the format of answers that were stored before second tries existed.
        let before = serde_json::from_str("{\"choice\":2}").unwrap();
        assert_eq!(tries_of_json(&before), Some((Response::Choice(1), None)));
    }

    #[test]
    fn an_answer_is_read_back_as_it_was_written() {
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
