//! Left and right mixed up.

use super::{Misconception, Prediction};
use crate::quiz::question::Rays;

/// Both angles right, each to the wrong side.
pub static SIDES_EXCHANGED: Misconception = Misconception {
    id: "sides-exchanged",
    name: "left and right exchanged",
    advice: "Look along the striker's path, as if you rode on it, and say first on which side \
             the coin lies.",
    predicts: |hit| {
        let truth = hit.truth();
        Some(Prediction {
            rays: Rays {
                striker: truth.striker.map(|theta1| -theta1),
                target: truth.target.map(|theta2| -theta2),
            },
            telltale: None,
        })
    },
    says: |hit| {
        format!(
            "Your figures are right, on the wrong sides. The {} lies to the {side}, so it \
             goes to the {side}.",
            hit.pieces.target_name(),
            side = hit.side_name()
        )
    },
};
