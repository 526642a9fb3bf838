//! The striker goes on as if nothing had happened.

use super::{Misconception, Prediction, on_usual_sides};
use crate::quiz::question::Ray;

/// The striker is taken to keep its direction, though it is not the heavier one
/// (that is another belief).
pub static STRAIGHT_ON: Misconception = Misconception {
    id: "straight-on",
    name: "the striker goes straight on",
    advice: "In the lab, watch the striker alone: only a hit that barely grazes leaves it on \
             its path.",
    predicts: |hit| {
        (hit.mass_ratio() <= 1.0).then(|| Prediction {
            rays: on_usual_sides(hit, 0.0, hit.alpha().abs()),
            telltale: Some(Ray::Striker),
        })
    },
    says: |hit| {
        format!(
            "You let the striker go straight on. But it pushes the {name}, and the {name} \
             pushes it back as hard.",
            name = hit.pieces.target_name()
        )
    },
};
