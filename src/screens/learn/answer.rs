//! What a student answers at a checkpoint, and how good that is.

use crate::lessons::{Asked, Checkpoint, Expected};
use crate::physics::Collision;
use crate::quiz::{Ray, RayGrade, Rays};

/// An answer at a checkpoint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Answer {
    /// Where both will go.
    Rays(Rays),
    /// A number.
    Number(f64),
    /// A line of a choice, from 0.
    Choice(usize),
}

impl Answer {
    /// Credit from 0 to 1. `figure` is the collision as the page's figure has it.
    ///
    /// Rays are marked as in the quiz. A number earns full credit within the
    /// tolerance, and then less in a straight line, down to none at four times it.
    pub fn credit(&self, checkpoint: &Checkpoint, figure: Option<&Collision>) -> f64 {
        match (self, &checkpoint.asked) {
            (Self::Rays(rays), Asked::Rays) => {
                let [striker, target] = grades(rays, figure).map(|grade| grade.credit());
                f64::midpoint(striker, target)
            }
            (
                Self::Number(number),
                Asked::Number {
                    expected,
                    tolerance,
                },
            ) => {
                let truth = truth(expected, figure).unwrap_or(f64::INFINITY);
                let beyond = (number - truth).abs() / tolerance - 1.0;
                (1.0 - (beyond - ROUNDING).max(0.0) / 3.0).max(0.0)
            }
            (Self::Choice(chosen), Asked::Choice(choices)) => {
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
}

/// A number on the very edge of the tolerance is right, whatever rounding left of it.
const ROUNDING: f64 = 1e-9;

fn grades(rays: &Rays, figure: Option<&Collision>) -> [RayGrade; 2] {
    let truth = figure.map(|collision| Rays::from(&collision.outcome()));
    Ray::BOTH.map(|ray| RayGrade {
        error: truth.and_then(|truth| rays.apart(&truth, ray)),
    })
}

/// The right number.
pub(super) fn truth(expected: &Expected, figure: Option<&Collision>) -> Option<f64> {
    match expected {
        Expected::Of(quantity, shot) => quantity.of(&shot.collision()),
        Expected::Figure(quantity) => quantity.of(figure?),
        Expected::Fixed(value, _) => Some(*value),
    }
}

/// Its sign and its unit.
pub(super) fn sign_and_unit(expected: &Expected) -> (&str, &str) {
    match expected {
        Expected::Of(quantity, _) | Expected::Figure(quantity) => (quantity.symbol, quantity.unit),
        Expected::Fixed(_, unit) => ("your answer", unit),
    }
}
