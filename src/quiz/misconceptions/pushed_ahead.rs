//! The target goes the way the striker came.

use super::super::{Ray, Rays};
use super::{Misconception, Prediction};

/// The target is taken to be pushed along the striker's path, not along the line of
/// impact.
pub static PUSHED_AHEAD: Misconception = Misconception {
    id: "pushed-ahead",
    name: "pushed straight ahead",
    advice: "In the lab, switch on the line of impact and see the coin leave along it every \
             time.",
    predicts: |question| {
        Some(Prediction {
            rays: Rays {
                target: Some(0.0),
                ..question.truth()
            },
            telltale: Some(Ray::Target),
        })
    },
    says: |question, _| {
        format!(
            "You sent the {} straight ahead. But smooth discs push only along the line through \
             their centres.",
            question.pieces.target_name()
        )
    },
};
