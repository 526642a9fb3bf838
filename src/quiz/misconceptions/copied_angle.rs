//! θ₁ = α: the striker leaves at the impact angle.

use super::{Misconception, Prediction, on_usual_sides};
use crate::numbers;
use crate::quiz::question::Ray;

/// The scattering angle is taken to be the impact angle.
pub static COPIED_ANGLE: Misconception = Misconception {
    id: "copied-angle",
    name: "the angle was copied",
    advice: "In the lab, step the offset and watch both angles: as the coin's grows, the \
             striker's shrinks.",
    predicts: |hit| {
        let alpha = hit.alpha().abs();
        (!hit.head_on()).then(|| Prediction {
            rays: on_usual_sides(hit, alpha, alpha),
            telltale: Some(Ray::Striker),
        })
    },
    says: |hit| {
        format!(
            "You sent the striker off at the impact angle, {}. That is the {}'s angle.",
            numbers::degrees(hit.alpha().abs()),
            hit.pieces.target_name()
        )
    },
};
