//! The heavier of the two takes no notice.

use std::f64::consts::PI;

use super::{Misconception, Prediction, on_usual_sides};
use crate::quiz::question::{Ray, Rays};

/// The heavier disc is taken to go on, or to lie, as if nothing had hit it.
pub static HEAVY_UNMOVED: Misconception = Misconception {
    id: "heavy-unmoved",
    name: "the heavier is not moved",
    advice: "In the lab, make one piece ten times as heavy as the other and look closely: it \
             still turns, a little.",
    predicts: |hit| {
        let alpha = hit.alpha().abs();
        let ratio = hit.mass_ratio();
        if ratio > 1.0 {
            Some(Prediction {
                rays: on_usual_sides(hit, 0.0, alpha),
                telltale: Some(Ray::Striker),
            })
        } else if ratio < 1.0 {
            // A thing that never moves throws the striker back like a wall.
            Some(Prediction {
                rays: Rays {
                    target: None,
                    ..on_usual_sides(hit, PI - 2.0 * alpha, 0.0)
                },
                telltale: Some(Ray::Target),
            })
        } else {
            None
        }
    },
    says: |hit| {
        if hit.mass_ratio() > 1.0 {
            "You let the heavy striker go straight on. But the push that moves the coin pushes \
             the striker back as hard."
                .into()
        } else {
            "You left the heavy marble lying. But the push that turns the striker pushes the \
             marble as hard."
                .into()
        }
    },
};
