//! What a student answers at a checkpoint, and how good that is.

use serde_json::{Value, json};

use super::checkpoint::{Checkpoint, CheckpointKind};
use crate::physics::Collision;
use crate::quiz::{Ray, RayGrade, Rays};

/// An answer at a checkpoint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CheckpointAnswer {
    /// Where both will go.
    Rays(Rays),
    /// A number.
    Number(f64),
    /// A line of a choice, from 0.
    Choice(usize),
}

impl CheckpointAnswer {
    /// Credit from 0 to 1. `figure` is the collision as the page's figure has it.
    ///
    /// Rays are marked as in the quiz. A number earns full credit within the
    /// tolerance, and then less in a straight line, down to none at four times it.
    pub fn credit(&self, checkpoint: &Checkpoint, figure: Option<&Collision>) -> f64 {
        match (self, &checkpoint.asked) {
            (Self::Rays(rays), CheckpointKind::Rays) => {
                let [striker, target] = grades(rays, figure).map(|grade| grade.credit());
                f64::midpoint(striker, target)
            }
            (
                Self::Number(number),
                CheckpointKind::Number {
                    expected,
                    tolerance,
                },
            ) => {
                let truth = expected.value(figure).unwrap_or(f64::INFINITY);
                let beyond = (number - truth).abs() / tolerance - 1.0;
                (1.0 - (beyond - ROUNDING).max(0.0) / 3.0).max(0.0)
            }
            (Self::Choice(chosen), CheckpointKind::Choice(choices)) => {
                let right = choices.get(*chosen).is_some_and(|choice| choice.right);
                f64::from(u8::from(right))
            }
            _ => 0.0,
        }
    }

    /// Whether it counts as right.
    pub fn is_right(&self, checkpoint: &Checkpoint, figure: Option<&Collision>) -> bool {
        match self {
            Self::Rays(rays) => grades(rays, figure).iter().all(RayGrade::is_right),
            _ => self.credit(checkpoint, figure) >= 1.0,
        }
    }

    /// It as it is kept: angles in degrees, a line of a choice counted from 1.
    pub fn json(&self) -> Value {
        match self {
            Self::Rays(rays) => rays.json(),
            Self::Number(number) => json!({"number": number}),
            Self::Choice(line) => json!({"choice": line + 1}),
        }
    }

    /// An answer as [`CheckpointAnswer::json`] writes it; `None` if it is none.
    pub fn of_json(value: &Value) -> Option<Self> {
        if let Some(number) = value.get("number") {
            return number
                .as_f64()
                .filter(|it| it.is_finite())
                .map(Self::Number);
        }
        if let Some(line) = value.get("choice") {
            let line = usize::try_from(line.as_u64()?).ok()?;
            return line.checked_sub(1).map(Self::Choice);
        }
        Rays::of_json(value).map(Self::Rays)
    }
}

/// A number on the very edge of the tolerance is right, whatever rounding left of it.
const ROUNDING: f64 = 1e-9;

fn grades(rays: &Rays, figure: Option<&Collision>) -> [RayGrade; 2] {
    let truth = figure.map(|collision| Rays::from(&collision.outcome()));
    Ray::BOTH.map(|ray| RayGrade {
        error: truth.and_then(|truth| rays.apart(&truth, ray)),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_answer_is_read_as_it_is_written() {
        let still = Rays {
            striker: None,
            target: Some(0.5),
        };
        for answer in [
            CheckpointAnswer::Number(-0.1),
            CheckpointAnswer::Choice(0),
            CheckpointAnswer::Choice(4),
            CheckpointAnswer::Rays(Rays::new(0.0, -1.0)),
            CheckpointAnswer::Rays(still),
        ] {
            let text = answer.json().to_string();
            let read: Value = serde_json::from_str(&text).unwrap();
            match (CheckpointAnswer::of_json(&read), answer) {
                (Some(CheckpointAnswer::Rays(read)), CheckpointAnswer::Rays(said)) => {
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
            assert_eq!(CheckpointAnswer::of_json(&read), None, "{nonsense}");
        }
    }
}
