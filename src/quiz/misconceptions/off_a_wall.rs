//! The striker bounces as light does off a mirror.

use std::f64::consts::PI;

use super::{Misconception, Prediction, on_usual_sides};
use crate::numbers;
use crate::quiz::question::Ray;

/// The target is taken to throw the striker back as a wall would.
pub static OFF_A_WALL: Misconception = Misconception {
    id: "off-a-wall",
    name: "bounced as off a wall",
    advice: "In the lab, make the target heavier and heavier: only then does the striker bounce \
             as off a wall.",
    predicts: |hit| {
        let alpha = hit.alpha().abs();
        Some(Prediction {
            rays: on_usual_sides(hit, PI - 2.0 * alpha, alpha),
            telltale: Some(Ray::Striker),
        })
    },
    says: |hit| {
        format!(
            "You bounced the striker by {}, as off a wall. But the {} gives way.",
            numbers::degrees(PI - 2.0 * hit.alpha().abs()),
            hit.pieces.target_name()
        )
    },
};
