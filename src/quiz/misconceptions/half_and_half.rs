//! 45° each, wherever the two meet.

use std::f64::consts::FRAC_PI_4;

use super::{Misconception, Prediction, on_usual_sides};

/// The two are taken to share a right angle evenly.
pub static HALF_AND_HALF: Misconception = Misconception {
    id: "half-and-half",
    name: "half and half",
    advice: "In the lab, move the offset from 0 to a graze: equal pieces share evenly at one \
             place alone.",
    predicts: |hit| {
        Some(Prediction {
            rays: on_usual_sides(hit, FRAC_PI_4, FRAC_PI_4),
            telltale: None,
        })
    },
    says: |_| {
        "You gave each of them 45°. But they do not share evenly: where they touch decides.".into()
    },
};
