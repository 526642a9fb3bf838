//! The offset read as a share of 90°.

use std::f64::consts::FRAC_PI_2;

use super::{Misconception, Prediction};
use crate::numbers;
use crate::physics::ImpactPoint;
use crate::quiz::question::Rays;

/// α is taken to be 90° · b / (r₁ + r₂), where it is the sine that is b / (r₁ + r₂).
pub static OFFSET_AS_ANGLE: Misconception = Misconception {
    id: "offset-as-angle",
    name: "the offset read as an angle",
    advice: "In the lab, set half the largest offset and read the impact angle: 30°, not 45°.",
    predicts: |hit| match hit.given {
        ImpactPoint::Angle { .. } => None,
        ImpactPoint::Offset { offset_mm } => {
            let alpha = FRAC_PI_2 * offset_mm / hit.reach_mm();
            let outcome = hit.collision().with_alpha(alpha).outcome();
            Some(Prediction {
                rays: Rays::from(&outcome),
                telltale: None,
            })
        }
    },
    says: |hit| {
        let alpha = FRAC_PI_2 * hit.alpha().sin().abs();
        format!(
            "You took the offset as a share of 90° and found {}. It gives the sine of the \
             angle.",
            numbers::degrees(alpha)
        )
    },
};
