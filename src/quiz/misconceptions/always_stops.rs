//! Head-on, the striker stops, whatever the masses.

use super::{Misconception, Prediction};
use crate::quiz::question::{Ray, Rays};

/// What equal masses do head-on is taken to hold for all.
pub static ALWAYS_STOPS: Misconception = Misconception {
    id: "always-stops",
    name: "the striker always stops",
    advice: "In the lab, hit head-on with a heavier striker and then with a lighter one.",
    predicts: |hit| {
        hit.head_on().then(|| Prediction {
            rays: Rays {
                striker: None,
                ..hit.truth()
            },
            telltale: Some(Ray::Striker),
        })
    },
    says: |_| "You stopped the striker. Without loss that takes equal masses.".into(),
};
