//! What students may believe about where the two discs of a hit will go.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use crate::numbers::{degrees, significant};
use crate::physics::ImpactPoint;
use crate::quiz::question::{Hit, Misconception, Ray, Rays};

/// The misconceptions that predict where the two discs of a hit will go. If an answer fits two of
/// them equally well, the one that comes first in this list is named.
pub const OF_RAYS: [Misconception; 13] = *Misconception::ALL
    .first_chunk()
    .expect("there are more than 13 misconceptions");

/// A prediction that differs from the truth by less than this, in radians, counts as right.
const SAME: f64 = 1e-9;

/// The rays that a misconception predicts, and which of them reveals the misconception by itself;
/// `None` if only both rays together reveal it.
type Prediction = (Rays, Option<Ray>);

impl Misconception {
    /// The prediction of this misconception for a hit; `None` if the misconception makes no
    /// prediction or happens to be right.
    pub(in crate::quiz) fn predict(self, hit: &Hit) -> Option<Prediction> {
        let truth = hit.truth();
        self.sends(hit, truth)
            .filter(|(rays, _)| rays.gap(&truth) > SAME)
    }

    /// The prediction of this misconception, even if the prediction is right.
    fn sends(self, hit: &Hit, truth: Rays) -> Option<Prediction> {
        let (alpha, ratio, side) = (hit.alpha().abs(), hit.mass_ratio(), hit.side());
        let rays = |striker, target| Rays { striker, target };
        // The target leaves on the side where it lies, and the striker on the other side.
        let usual = |theta1: f64, theta2: f64| Rays::new(side * theta1, side * theta2);
        let [striker, target] = Ray::BOTH.map(Some);
        let mirrored = |angle: Option<f64>| angle.map(|angle| -angle);
        Some(match self {
            Self::CopiedAngle if !hit.head_on() => (usual(alpha, alpha), striker),
            Self::AlwaysSquare if !hit.head_on() => (usual(FRAC_PI_2 - alpha, alpha), None),
            Self::HalfAndHalf => (usual(FRAC_PI_4, FRAC_PI_4), None),
            Self::Swapped => (rays(truth.target, truth.striker), None),
            Self::HeavyUnmoved if ratio > 1.0 => (usual(0.0, alpha), striker),
            // If the target never moves, the striker rebounds from it as from a wall.
            Self::HeavyUnmoved if ratio < 1.0 => {
                (rays(usual(PI - 2.0 * alpha, 0.0).striker, None), target)
            }
            Self::StraightOn if ratio <= 1.0 => (usual(0.0, alpha), striker),
            Self::PushedAhead => (rays(truth.striker, Some(0.0)), target),
            Self::SameSide => (rays(mirrored(truth.striker), truth.target), None),
            Self::SidesExchanged => (rays(mirrored(truth.striker), mirrored(truth.target)), None),
            Self::OffAWall => (usual(PI - 2.0 * alpha, alpha), striker),
            Self::OffsetAsAngle => {
                let ImpactPoint::Offset { offset_mm } = hit.given else {
                    return None;
                };
                let alpha = FRAC_PI_2 * offset_mm / hit.reach_mm();
                let outcome = hit.collision().with_alpha(alpha).outcome();
                (Rays::from(&outcome), None)
            }
            Self::Lossless if !hit.masses_are_equal() => (hit.with_restitution(1.0).truth(), None),
            Self::AlwaysStops if hit.head_on() => (rays(None, truth.target), striker),
            _ => return None,
        })
    }

    /// One or two sentences of feedback on the rays that this misconception predicts, with the
    /// figures of the hit.
    pub(in crate::quiz) fn say(self, hit: &Hit) -> String {
        let (name, side) = (hit.pieces.target_name(), hit.side_name());
        let alpha = hit.alpha().abs();
        match self {
            Self::CopiedAngle => format!(
                "Your striker's angle is close to the {name}'s, {}.",
                degrees(alpha)
            ),
            Self::AlwaysSquare if hit.restitution < 1.0 => {
                "Your paths are close to 90° apart, as for equal masses without loss.".into()
            }
            Self::AlwaysSquare => "Your paths are close to 90° apart, as for equal masses.".into(),
            Self::HalfAndHalf => {
                "Your angles are close to 45° each. That is right at one offset at most.".into()
            }
            Self::Swapped => match hit.truth() {
                Rays {
                    striker: Some(theta1),
                    target: Some(theta2),
                } if !hit.head_on() => format!(
                    "Your angles are swapped. The {name} leaves at {}, the striker at {}.",
                    degrees(theta2.abs()),
                    degrees(theta1.abs())
                ),
                _ => format!(
                    "Your rays are swapped: the ray that you drew for the {name} is the striker's."
                ),
            },
            Self::HeavyUnmoved if hit.mass_ratio() > 1.0 => {
                "You sent the heavy striker straight on. But the coin pushes back.".into()
            }
            Self::HeavyUnmoved => {
                format!("You left the heavy {name} at rest. But equal forces act on both discs.")
            }
            Self::StraightOn => {
                format!("You sent the striker straight on. But the {name} pushes back.")
            }
            Self::PushedAhead => {
                format!("You sent the {name} straight ahead. But smooth rims push along n.")
            }
            Self::SameSide => {
                format!("You sent both to the {side}. But the sideways momenta add up to zero.")
            }
            Self::SidesExchanged => {
                format!("Your angles are right, but the {name} lies to the {side} of the path.")
            }
            Self::OffAWall => format!(
                "Your striker turns by close to {}, as off a wall. But the {name} can move.",
                degrees(PI - 2.0 * alpha)
            ),
            Self::OffsetAsAngle => format!(
                "Your angles fit α close to {}, in proportion to the offset.",
                degrees(FRAC_PI_2 * hit.alpha().sin().abs())
            ),
            Self::Lossless => format!(
                "Your angles are close to those for e = 1. Here e = {}.",
                significant(hit.restitution)
            ),
            Self::AlwaysStops => {
                "You stopped the striker. If no energy is lost, it stops only if the masses are \
                 equal."
                    .into()
            }
            _ => String::new(),
        }
    }
}
