//! The loss forgotten.

use crate::physics::Collision;

use super::{Misconception, Prediction};
use crate::numbers;
use crate::quiz::question::Rays;

/// e < 1 is taken for e = 1. With equal masses that is "always 90°".
pub static LOSSLESS: Misconception = Misconception {
    id: "lossless",
    name: "the loss was forgotten",
    advice: "In the lab, turn e down from 1 and watch the striker's ray alone.",
    predicts: |hit| {
        let unequal = (hit.mass_ratio() - 1.0).abs() > 0.0;
        let lossless = Collision {
            restitution: 1.0,
            ..hit.collision()
        };
        unequal.then(|| Prediction {
            rays: Rays::from(&lossless.outcome()),
            telltale: None,
        })
    },
    says: |hit| {
        format!(
            "Your angles are those without loss. With e = {} the two part more slowly along \
             the line of impact.",
            numbers::significant(hit.restitution)
        )
    },
};
