//! Why the shot went as it did, starting from what the player said.

use super::Setup;
use crate::physics::{Bond, Meeting};
use crate::quiz;
use crate::screens::why::{both_moving, of_hit};
use crate::widgets::hit::Watch;

/// A title and a text for the panel.
pub(in crate::screens) fn explain(setup: &Setup, watch: &Watch) -> (String, String) {
    let outcome = watch.outcome();
    let collision = watch.collision();
    let plain = |text: String| (String::new(), text);
    match outcome.meeting {
        Meeting::Miss if collision.relative_velocity().length() == 0.0 => {
            plain("Both move alike, so the gap between them never closes: no hit.".into())
        }
        Meeting::Miss => plain(format!(
            "A miss. The offset of {:.1} mm is more than r₁ + r₂ = {:.1} mm, so nothing touches: the striker goes straight on and the coin is left as it was.",
            setup.offset_mm.abs(),
            setup.reach_mm()
        )),
        Meeting::Graze => plain(
            "They just brush: at an offset of exactly r₁ + r₂ the line of impact is square to the motion, nothing is pushed, and the striker goes straight on.".into(),
        ),
        Meeting::Hit if setup.bond == Bond::Stick => plain(stuck(watch)),
        Meeting::Hit if setup.target_speed > 0.0 => plain(format!(
            "{} Press f for the coin's own frame.",
            both_moving(watch.collision())
        )),
        Meeting::Hit => match watch.said() {
            Some(said) => {
                let (title, text) = of_hit(&setup.question(), *said);
                (title.into(), text)
            }
            None => plain(quiz::reasoning(&setup.question())),
        },
    }
}

fn stuck(watch: &Watch) -> String {
    let outcome = watch.outcome();
    let turns = outcome.spin.abs() / std::f64::consts::TAU;
    let turning = if turns > 0.005 {
        format!(" Hit off-centre, the pair also turns, {turns:.1} times a second.")
    } else {
        " Hit head-on, the pair does not turn.".into()
    };
    format!(
        "They stick and share one velocity, that of the centre of mass: {:.2} m/s.{turning} Sticking is not the same as e = 0: smooth discs would still slip past each other.",
        outcome.v1.length()
    )
}
