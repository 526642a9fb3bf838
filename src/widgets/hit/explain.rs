//! The explanation of the shot, starting from the player's prediction.

use glam::DVec2;

use super::Watch;
use crate::numbers::tidy;
use crate::physics::units::mm_from_m;
use crate::physics::{Bond, CollisionOutcome, Meeting};
use crate::quiz::why;

/// The title, which may be empty, and the text of the panel.
pub(crate) fn explain(watch: &Watch) -> (&'static str, String) {
    let collision = watch.collision();
    let text = match watch.outcome().meeting {
        Meeting::Miss if collision.relative_velocity().length() == 0.0 => {
            "Both discs have the same velocity, so the distance between them never changes: there \
             is no collision."
                .into()
        }
        Meeting::Miss => format!(
            "A miss. The offset of {:.1} mm is more than r₁ + r₂ = {:.1} mm, so the discs do not \
             touch: the striker goes straight on, and the coin is unaffected.",
            tidy(mm_from_m(collision.offset.abs())),
            tidy(mm_from_m(collision.contact_distance()))
        ),
        Meeting::Graze => {
            "The discs only graze each other: at an offset of exactly r₁ + r₂ the line of impact \
             is at right angles to the motion, no force acts, and the striker goes straight on."
                .into()
        }
        Meeting::Hit if collision.bond == Bond::Stick => stuck(watch),
        Meeting::Hit => {
            let (title, text) = why(collision, watch.said);
            if collision.u2 == DVec2::ZERO {
                return (title, text);
            }
            format!("{text} Press f for the coin's own frame.")
        }
    };
    ("", text)
}

fn stuck(watch: &Watch) -> String {
    let outcome = watch.outcome();
    let turning = if outcome.energy_rotation > 0.0 {
        let [striker, coin] = watch.collision().centres_after().map(DVec2::length);
        format!(
            " After an off-centre collision the pair also rotates about the centre of mass, {} \
             times a second: right after the contact the striker's centre moves at {striker:.2} \
             m/s and the coin's at {coin:.2} m/s.",
            turns_a_second(outcome)
        )
    } else {
        " After a head-on collision the pair does not rotate.".into()
    };
    format!(
        "The collision is perfectly inelastic: the discs move on together, and their centre of \
         mass moves at V = {:.2} m/s.{turning} This is not the same as e = 0 with smooth rims, \
         where the discs still slip past each other.",
        outcome.v1.length()
    )
}

/// Formats the rotation rate of a pair that moves on together, in turns per second, with more
/// decimals if the rotation is slow.
pub(crate) fn turns_a_second(outcome: &CollisionOutcome) -> String {
    let turns = outcome.spin.abs() / std::f64::consts::TAU;
    let decimals = if turns < 0.1 { 3 } else { 1 };
    format!("{turns:.decimals$}")
}
