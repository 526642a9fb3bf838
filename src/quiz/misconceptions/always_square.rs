//! 90° between the two, whatever the masses and the loss.

use std::f64::consts::FRAC_PI_2;

use super::{Misconception, Prediction, on_usual_sides};
use crate::numbers;

/// The right angle of equal masses is taken to hold for all.
pub static ALWAYS_SQUARE: Misconception = Misconception {
    id: "always-square",
    name: "always 90°",
    advice: "In the lab, set a right angle with equal masses, then change one mass or e and \
             watch it open or close.",
    predicts: |hit| {
        let alpha = hit.alpha().abs();
        (!hit.head_on()).then(|| Prediction {
            rays: on_usual_sides(hit, FRAC_PI_2 - alpha, alpha),
            telltale: None,
        })
    },
    says: |hit| {
        let reason = if hit.restitution < 1.0 {
            "with energy lost"
        } else {
            "with unequal masses"
        };
        let alpha = hit.alpha().abs();
        format!(
            "You opened a right angle, {} + {}. That is not so {reason}.",
            numbers::bare_degrees(FRAC_PI_2 - alpha),
            numbers::degrees(alpha),
        )
    },
};
