//! Both leave to the same side.

use super::{Misconception, Prediction};
use crate::quiz::question::Rays;

/// The striker is taken to be drawn after the target.
pub static SAME_SIDE: Misconception = Misconception {
    id: "same-side",
    name: "both to one side",
    advice: "Before you answer, ask what moves sideways before the hit. Nothing: so afterwards \
             the two must balance.",
    predicts: |hit| {
        let truth = hit.truth();
        Some(Prediction {
            rays: Rays {
                striker: truth.striker.map(|theta1| -theta1),
                ..truth
            },
            telltale: None,
        })
    },
    says: |hit| {
        format!(
            "You sent both to the {}. Nothing moved sideways before, so sideways the two must \
             balance.",
            hit.side_name()
        )
    },
};
