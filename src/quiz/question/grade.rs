//! How good an answer is, which depends on its error.

use std::f64::consts::FRAC_PI_2;

use crate::numbers::points;
use crate::physics::units::{deg_from_rad, rad_from_deg};

use super::tolerance::{RIGHT_DEG, apart_deg};
use super::{Answer, Confidence, Form, Measure, Question, Ray, Rays, Response};

/// An answer earns full credit up to this fraction of the tolerance: 2° for a ray, which is about
/// the accuracy with which the picture can be read.
const FULL_CREDIT: f64 = 0.5;

/// An answer whose error is at least this multiple of the tolerance earns no credit: 30° for a
/// ray.
const NO_CREDIT: f64 = 7.5;

/// The credit, from 0 to 1, for an answer whose error is `distance` in units of the tolerance. The
/// credit is 1 up to a distance of 0.5, then decreases as cos² to 0 at a distance of 7.5, smoothly
/// at both ends. An infinite distance earns 0.
fn credit(distance: f64) -> f64 {
    let share = (distance - FULL_CREDIT) / (NO_CREDIT - FULL_CREDIT);
    let credit = (FRAC_PI_2 * share.clamp(0.0, 1.0)).cos().powi(2);
    // The cosine of π/2 is not exactly 0 in floating point.
    if credit < 1e-12 { 0.0 } else { credit }
}

/// How good the prediction of one ray is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RayGrade {
    /// The error in radians, from 0 to π; 0 if the disc stays still both in the answer and in
    /// reality, `None` if it moves in only one of them.
    pub error: Option<f64>,
}

impl RayGrade {
    /// The credit from 0 to 1: full credit up to 2°, none from 30° upwards. A ray for a disc that
    /// stays still earns 0, and so does a missing ray for a disc that moves.
    pub(crate) fn credit(&self) -> f64 {
        self.error
            .map_or(0.0, |error| credit(deg_from_rad(error) / RIGHT_DEG))
    }

    /// Whether the ray counts as right.
    pub(crate) fn is_right(&self) -> bool {
        self.error
            .is_some_and(|error| error <= rad_from_deg(RIGHT_DEG))
    }
}

/// How good the prediction of both rays is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RaysGrade {
    /// The striker's ray.
    pub striker: RayGrade,
    /// The grade of the target's ray.
    pub target: RayGrade,
}

impl RaysGrade {
    /// Grades both rays.
    pub(crate) fn new(said: &Rays, truth: &Rays) -> Self {
        let [striker, target] = Ray::BOTH.map(|ray| RayGrade {
            error: said.apart(truth, ray),
        });
        Self { striker, target }
    }

    /// The credit from 0 to 1, which is the mean of the two rays' credits.
    pub(crate) fn credit(&self) -> f64 {
        f64::midpoint(self.striker.credit(), self.target.credit())
    }

    /// The larger of the errors of the two rays, in radians; `None` if neither error is defined.
    pub(crate) fn error(&self) -> Option<f64> {
        let errors = [self.striker.error, self.target.error];
        errors.into_iter().flatten().reduce(f64::max)
    }

    /// Whether both rays count as right.
    pub(crate) fn is_right(&self) -> bool {
        self.striker.is_right() && self.target.is_right()
    }
}

/// How good an answer is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grade {
    /// The credit, from 0 to 1.
    pub credit: f64,
    /// Whether the answer counts as right.
    pub right: bool,
    /// The error of an angle in radians, or the larger error of two rays; `None` if the answer had
    /// no angle.
    pub angle_error: Option<f64>,
    /// How sure the player was.
    pub confidence: Confidence,
}

impl Form {
    /// The credit, from 0 to 1, for an answer. An answer of the wrong form earns no credit.
    ///
    /// In a chapter's question, a number earns full credit within its tolerance; beyond the
    /// tolerance the credit falls linearly to 0 at four times the tolerance.
    pub fn credit(&self, said: &Response) -> f64 {
        let distance = self.distance(said, &self.truth());
        match self {
            Self::Number {
                quantity: Measure::Own { .. },
                ..
            } => 1.0 - ((distance - 1.0) / 3.0).clamp(0.0, 1.0),
            _ => match self.rays_grade(said) {
                Some(rays) => rays.credit(),
                None => credit(distance),
            },
        }
    }

    /// Whether an answer counts as right.
    pub fn is_right(&self, said: &Response) -> bool {
        self.distance(said, &self.truth()) <= 1.0
    }

    /// The grades of the two rays, if the question asks for rays.
    pub(crate) fn rays_grade(&self, said: &Response) -> Option<RaysGrade> {
        match (self, said) {
            (Self::Rays { truth, .. }, Response::Rays(said)) => Some(RaysGrade::new(said, truth)),
            _ => None,
        }
    }

    /// The error of an angle in radians, or the larger error of two rays; `None` if the answer had
    /// no angle.
    pub fn angle_error(&self, said: &Response) -> Option<f64> {
        match (self, said) {
            (Self::Number { quantity, truth }, Response::Number(said)) => match quantity {
                Measure::Angle => Some(rad_from_deg(apart_deg(*said, *truth))),
                _ if quantity.unit() == "°" => Some(rad_from_deg((said - truth).abs())),
                _ => None,
            },
            (Self::Shot(aim), Response::Shot(offset)) => aim.error(*offset),
            _ => self.rays_grade(said)?.error(),
        }
    }
}

impl Grade {
    /// The maximum number of points for a question.
    pub const MOST: f64 = 10.0;

    /// Grades an answer.
    pub fn new(question: &Question, answer: &Answer) -> Self {
        let (form, said) = (&question.form, &answer.said);
        Self {
            credit: form.credit(said),
            right: form.is_right(said),
            angle_error: form.angle_error(said),
            confidence: answer.confidence,
        }
    }

    /// The points, from −6 to 10: see [`Confidence::points`].
    pub fn points(&self) -> f64 {
        self.confidence.points(self.credit)
    }

    /// The points as text: "8.5 of 10 points".
    pub fn score(&self) -> String {
        format!("{} of {:.0} points", points(self.points()), Self::MOST)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn credit(error_deg: f64) -> f64 {
        let error = Some(rad_from_deg(error_deg));
        RayGrade { error }.credit()
    }

    #[test]
    fn credit_falls_smoothly_from_full_to_none() {
        assert!((credit(0.0) - 1.0).abs() < 1e-12);
        assert!((credit(2.0) - 1.0).abs() < 1e-12);
        assert!((credit(16.0) - 0.5).abs() < 1e-12);
        for wrong in [30.0, 31.0, 180.0] {
            assert!(credit(wrong).abs() <= 0.0, "exactly 0");
        }
        for tenth in 0..1800 {
            let (here, next) = (
                credit(f64::from(tenth) / 10.0),
                credit(f64::from(tenth + 1) / 10.0),
            );
            assert!(next <= here && here - next < 0.006);
        }
        assert!(RayGrade { error: None }.credit().abs() < 1e-12);
    }
}
