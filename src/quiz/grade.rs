//! How good an answer is, by how far off each ray is.

use std::f64::consts::FRAC_PI_2;

use crate::physics::units::{deg_from_rad, rad_from_deg};

use super::{Answer, Confidence, Question, Ray, Rays};

/// Up to this error a ray earns full credit, in degrees: about what can be read off
/// the picture.
pub const FULL_CREDIT_DEG: f64 = 2.0;

/// From this error on a ray earns nothing, in degrees.
pub const NO_CREDIT_DEG: f64 = 30.0;

/// Up to this error a ray counts as right, in degrees.
pub const RIGHT_DEG: f64 = 4.0;

/// How good one ray is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RayGrade {
    /// Error in radians, 0 to π; 0 if the disc rightly stays still, `None` if it
    /// moves in the answer alone or in truth alone.
    pub error: Option<f64>,
}

impl RayGrade {
    /// Credit from 0 to 1 for an error δ: 1 up to 2°, then cos²(90° · (δ − 2°)/28°),
    /// which has no corner at either end, and 0 from 30° on. A ray where there is
    /// none, or none where there is one, earns 0.
    pub fn credit(&self) -> f64 {
        let Some(error) = self.error else {
            return 0.0;
        };
        let share = (deg_from_rad(error) - FULL_CREDIT_DEG) / (NO_CREDIT_DEG - FULL_CREDIT_DEG);
        (FRAC_PI_2 * share.clamp(0.0, 1.0)).cos().powi(2)
    }

    /// Whether it counts as right.
    pub fn is_right(&self) -> bool {
        self.error
            .is_some_and(|error| error <= rad_from_deg(RIGHT_DEG))
    }
}

/// How good an answer is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grade {
    /// The striker's ray.
    pub striker: RayGrade,
    /// The target's ray.
    pub target: RayGrade,
    /// How sure the player was.
    pub confidence: Confidence,
}

impl Grade {
    /// Most points a question can bring.
    pub const MOST: f64 = 10.0;

    /// Grades an answer.
    pub fn new(question: &Question, answer: &Answer) -> Self {
        let truth = question.truth();
        let [striker, target] = Ray::BOTH.map(|ray| RayGrade {
            error: answer.rays.apart(&truth, ray),
        });
        Self {
            striker,
            target,
            confidence: answer.confidence,
        }
    }

    /// Credit from 0 to 1: the mean of both rays.
    pub fn credit(&self) -> f64 {
        f64::midpoint(self.striker.credit(), self.target.credit())
    }

    /// Points by [`Confidence::points`], −6 to 10.
    pub fn points(&self) -> f64 {
        self.confidence.points(self.credit())
    }

    /// Whether both rays count as right.
    pub fn is_right(&self) -> bool {
        self.striker.is_right() && self.target.is_right()
    }
}

/// Whether `rays` count as right for `question`.
pub(super) fn is_right(question: &Question, rays: &Rays) -> bool {
    rays.gap(&question.truth()) <= rad_from_deg(RIGHT_DEG)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn credit(error_deg: f64) -> f64 {
        let error = Some(rad_from_deg(error_deg));
        RayGrade { error }.credit()
    }

    #[test]
    fn credit_falls_smoothly_from_all_to_nothing() {
        assert!((credit(0.0) - 1.0).abs() < 1e-12);
        assert!((credit(2.0) - 1.0).abs() < 1e-12);
        assert!((credit(16.0) - 0.5).abs() < 1e-12);
        assert!(credit(30.0).abs() < 1e-12 && credit(180.0).abs() < 1e-12);
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
