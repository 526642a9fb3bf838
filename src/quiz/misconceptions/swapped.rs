//! Both angles right, each given to the other disc.

use super::{Misconception, Prediction};
use crate::numbers;
use crate::quiz::question::Rays;

/// The striker's angle is given to the target and the target's to the striker.
pub static SWAPPED: Misconception = Misconception {
    id: "swapped",
    name: "the two were swapped",
    advice: "Before you answer, find the line through the two centres: it is the coin's way out.",
    predicts: |hit| {
        let truth = hit.truth();
        Some(Prediction {
            rays: Rays {
                striker: truth.target,
                target: truth.striker,
            },
            telltale: None,
        })
    },
    says: |hit| {
        let name = hit.pieces.target_name();
        match hit.truth() {
            Rays {
                striker: Some(theta1),
                target: Some(theta2),
            } if !hit.head_on() => format!(
                "Your figures are right, but swapped: {} is the {name}'s, {} the striker's.",
                numbers::degrees(theta2.abs()),
                numbers::degrees(theta1.abs())
            ),
            _ => format!("You had it the other way round: you gave the {name} the striker's part."),
        }
    },
};
