//! The target goes the way the striker came.

use super::{Misconception, Prediction};
use crate::quiz::question::{Ray, Rays};

/// The target is taken to be pushed along the striker's path, not along the line of
/// impact.
pub static PUSHED_AHEAD: Misconception = Misconception {
    id: "pushed-ahead",
    name: "pushed straight ahead",
    advice: "In the lab, switch on the line of impact and see the coin leave along it every \
             time.",
    predicts: |hit| {
        Some(Prediction {
            rays: Rays {
                target: Some(0.0),
                ..hit.truth()
            },
            telltale: Some(Ray::Target),
        })
    },
    says: |hit| {
        format!(
            "You sent the {} straight ahead. But smooth discs push only along the line through \
             their centres.",
            hit.pieces.target_name()
        )
    },
};
