//! What students believe about where both discs of a hit will go.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use crate::numbers;
use crate::physics::{Collision, ImpactPoint};
use crate::quiz::question::{Hit, Misconception, Prediction, Ray, Rays};

/// The misconceptions that say where both discs of a hit will go. Where an answer fits
/// two alike, the earlier one is named.
pub static OF_RAYS: [&Misconception; 13] = [
    &COPIED_ANGLE,
    &ALWAYS_SQUARE,
    &HALF_AND_HALF,
    &SWAPPED,
    &HEAVY_UNMOVED,
    &STRAIGHT_ON,
    &PUSHED_AHEAD,
    &SAME_SIDE,
    &SIDES_EXCHANGED,
    &OFF_A_WALL,
    &OFFSET_AS_ANGLE,
    &LOSSLESS,
    &ALWAYS_STOPS,
];

/// A prediction on the usual sides: the striker away from the target, the target
/// towards its own side, both by these angles in radians.
fn on_usual_sides(hit: &Hit, theta1: f64, theta2: f64) -> Rays {
    let side = hit.side();
    Rays::new(side * theta1, side * theta2)
}

/// The scattering angle is taken to be the impact angle.
pub(crate) static COPIED_ANGLE: Misconception = Misconception {
    id: "copied-angle",
    name: "the angle was copied",
    advice: "In the lab, step the offset and watch both angles: as the coin's grows, the \
             striker's shrinks.",
    predicts: |hit| {
        let alpha = hit.alpha().abs();
        (!hit.head_on())
            .then(|| Prediction::new(on_usual_sides(hit, alpha, alpha), Some(Ray::Striker)))
    },
    says: |hit| {
        format!(
            "You sent the striker off at the impact angle, {}. That is the {}'s angle.",
            numbers::degrees(hit.alpha().abs()),
            hit.pieces.target_name()
        )
    },
};

/// The right angle of equal masses is taken to hold for all.
pub(crate) static ALWAYS_SQUARE: Misconception = Misconception {
    id: "always-square",
    name: "always 90°",
    advice: "In the lab, set a right angle with equal masses, then change one mass or e and \
             watch it open or close.",
    predicts: |hit| {
        let alpha = hit.alpha().abs();
        (!hit.head_on())
            .then(|| Prediction::new(on_usual_sides(hit, FRAC_PI_2 - alpha, alpha), None))
    },
    says: |hit| {
        let reason = if hit.restitution < 1.0 {
            "with energy lost"
        } else {
            "with unequal masses"
        };
        let alpha = hit.alpha().abs();
        format!(
            "You opened a right angle, {} + {}. That is not so {reason}.",
            numbers::bare_degrees(FRAC_PI_2 - alpha),
            numbers::degrees(alpha),
        )
    },
};

/// The two are taken to share a right angle evenly.
pub(crate) static HALF_AND_HALF: Misconception = Misconception {
    id: "half-and-half",
    name: "half and half",
    advice: "In the lab, move the offset from 0 to a graze: equal pieces share evenly at one \
             place alone.",
    predicts: |hit| {
        Some(Prediction::new(
            on_usual_sides(hit, FRAC_PI_4, FRAC_PI_4),
            None,
        ))
    },
    says: |_| {
        "You gave each of them 45°. But they do not share evenly: where they touch decides.".into()
    },
};

/// The striker's angle is given to the target and the target's to the striker.
pub(crate) static SWAPPED: Misconception = Misconception {
    id: "swapped",
    name: "the two were swapped",
    advice: "Before you answer, find the line through the two centres: it is the coin's way out.",
    predicts: |hit| {
        let truth = hit.truth();
        Some(Prediction::new(
            Rays {
                striker: truth.target,
                target: truth.striker,
            },
            None,
        ))
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

/// The heavier disc is taken to go on, or to lie, as if nothing had hit it.
pub(crate) static HEAVY_UNMOVED: Misconception = Misconception {
    id: "heavy-unmoved",
    name: "the heavier is not moved",
    advice: "In the lab, make one piece ten times as heavy as the other and look closely: it \
             still turns, a little.",
    predicts: |hit| {
        let alpha = hit.alpha().abs();
        let ratio = hit.mass_ratio();
        if ratio > 1.0 {
            Some(Prediction::new(
                on_usual_sides(hit, 0.0, alpha),
                Some(Ray::Striker),
            ))
        } else if ratio < 1.0 {
            // A thing that never moves throws the striker back like a wall.
            Some(Prediction::new(
                Rays {
                    target: None,
                    ..on_usual_sides(hit, PI - 2.0 * alpha, 0.0)
                },
                Some(Ray::Target),
            ))
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

/// The striker is taken to keep its direction, though it is not the heavier one
/// (that is another belief).
pub(crate) static STRAIGHT_ON: Misconception = Misconception {
    id: "straight-on",
    name: "the striker goes straight on",
    advice: "In the lab, watch the striker alone: only a hit that barely grazes leaves it on \
             its path.",
    predicts: |hit| {
        (hit.mass_ratio() <= 1.0).then(|| {
            Prediction::new(
                on_usual_sides(hit, 0.0, hit.alpha().abs()),
                Some(Ray::Striker),
            )
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

/// The target is taken to be pushed along the striker's path, not along the line of
/// impact.
pub(crate) static PUSHED_AHEAD: Misconception = Misconception {
    id: "pushed-ahead",
    name: "pushed straight ahead",
    advice: "In the lab, switch on the line of impact and see the coin leave along it every \
             time.",
    predicts: |hit| {
        Some(Prediction::new(
            Rays {
                target: Some(0.0),
                ..hit.truth()
            },
            Some(Ray::Target),
        ))
    },
    says: |hit| {
        format!(
            "You sent the {} straight ahead. But smooth discs push only along the line through \
             their centres.",
            hit.pieces.target_name()
        )
    },
};

/// The striker is taken to be drawn after the target.
pub(crate) static SAME_SIDE: Misconception = Misconception {
    id: "same-side",
    name: "both to one side",
    advice: "Before you answer, ask what moves sideways before the hit. Nothing: so afterwards \
             the two must balance.",
    predicts: |hit| {
        let truth = hit.truth();
        Some(Prediction::new(
            Rays {
                striker: truth.striker.map(|theta1| -theta1),
                ..truth
            },
            None,
        ))
    },
    says: |hit| {
        format!(
            "You sent both to the {}. Nothing moved sideways before, so sideways the two must \
             balance.",
            hit.side_name()
        )
    },
};

/// Both angles right, each to the wrong side.
pub(crate) static SIDES_EXCHANGED: Misconception = Misconception {
    id: "sides-exchanged",
    name: "left and right exchanged",
    advice: "Look along the striker's path, as if you rode on it, and say first on which side \
             the coin lies.",
    predicts: |hit| {
        let truth = hit.truth();
        Some(Prediction::new(
            Rays {
                striker: truth.striker.map(|theta1| -theta1),
                target: truth.target.map(|theta2| -theta2),
            },
            None,
        ))
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

/// The target is taken to throw the striker back as a wall would.
pub(crate) static OFF_A_WALL: Misconception = Misconception {
    id: "off-a-wall",
    name: "bounced as off a wall",
    advice: "In the lab, make the target heavier and heavier: only then does the striker bounce \
             as off a wall.",
    predicts: |hit| {
        let alpha = hit.alpha().abs();
        Some(Prediction::new(
            on_usual_sides(hit, PI - 2.0 * alpha, alpha),
            Some(Ray::Striker),
        ))
    },
    says: |hit| {
        format!(
            "You bounced the striker by {}, as off a wall. But the {} gives way.",
            numbers::degrees(PI - 2.0 * hit.alpha().abs()),
            hit.pieces.target_name()
        )
    },
};

/// α is taken to be 90° · b / (r₁ + r₂), where it is the sine that is b / (r₁ + r₂).
pub(crate) static OFFSET_AS_ANGLE: Misconception = Misconception {
    id: "offset-as-angle",
    name: "the offset read as an angle",
    advice: "In the lab, set half the largest offset and read the impact angle: 30°, not 45°.",
    predicts: |hit| match hit.given {
        ImpactPoint::Angle { .. } => None,
        ImpactPoint::Offset { offset_mm } => {
            let alpha = FRAC_PI_2 * offset_mm / hit.reach_mm();
            let outcome = hit.collision().with_alpha(alpha).outcome();
            Some(Prediction::new(Rays::from(&outcome), None))
        }
    },
    says: |hit| {
        let alpha = FRAC_PI_2 * hit.alpha().sin().abs();
        format!(
            "You took the offset as a share of 90° and found {}. It gives the sine of the \
             angle.",
            numbers::degrees(alpha)
        )
    },
};

/// e < 1 is taken for e = 1. With equal masses that is "always 90°".
pub(crate) static LOSSLESS: Misconception = Misconception {
    id: "lossless",
    name: "the loss was forgotten",
    advice: "In the lab, turn e down from 1 and watch the striker's ray alone.",
    predicts: |hit| {
        let unequal = (hit.mass_ratio() - 1.0).abs() > 0.0;
        let lossless = Collision {
            restitution: 1.0,
            ..hit.collision()
        };
        unequal.then(|| Prediction::new(Rays::from(&lossless.outcome()), None))
    },
    says: |hit| {
        format!(
            "Your angles are those without loss. With e = {} the two part more slowly along \
             the line of impact.",
            numbers::significant(hit.restitution)
        )
    },
};

/// What equal masses do head-on is taken to hold for all.
pub(crate) static ALWAYS_STOPS: Misconception = Misconception {
    id: "always-stops",
    name: "the striker always stops",
    advice: "In the lab, hit head-on with a heavier striker and then with a lighter one.",
    predicts: |hit| {
        hit.head_on().then(|| {
            Prediction::new(
                Rays {
                    striker: None,
                    ..hit.truth()
                },
                Some(Ray::Striker),
            )
        })
    },
    says: |_| "You stopped the striker. Without loss that takes equal masses.".into(),
};
