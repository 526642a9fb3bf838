//! What students are known to believe about glancing hits, one file a belief.
//!
//! Each misconception says where it would send the two discs of a question.
//! [`diagnose`] compares an answer with all of them. A question is only asked if
//! it [tells them apart](is_clear): then no two of them, and none and the truth,
//! lie so close that an answer could fit both.

mod always_square;
mod always_stops;
mod copied_angle;
mod diagnosis;
mod half_and_half;
mod heavy_unmoved;
mod lossless;
mod off_a_wall;
mod offset_as_angle;
mod pushed_ahead;
mod same_side;
mod sides_exchanged;
mod straight_on;
mod swapped;

use std::fmt;

use crate::physics::units::rad_from_deg;

use super::{Question, Ray, Rays};

pub use diagnosis::{Diagnosis, Fit, diagnose};

/// Up to this far from what a misconception predicts, a ray fits it, in degrees.
pub const FIT_DEG: f64 = 4.0;

/// Predictions nearer to each other than this cannot be told apart, in degrees;
/// more than twice [`FIT_DEG`], so that no answer fits two.
pub const CLEAR_DEG: f64 = 8.25;

/// A prediction that differs from the truth by less is the truth, in radians.
const SAME: f64 = 1e-9;

/// Something students are known to believe.
pub struct Misconception {
    /// Its name in files.
    pub id: &'static str,
    /// Its name as shown: "the angle was copied".
    pub name: &'static str,
    /// What to try next against it.
    pub advice: &'static str,
    /// Where it sends the two; `None` where it has nothing to say.
    predicts: fn(&Question) -> Option<Prediction>,
    /// One or two sentences on what is wrong, with the question's and the player's
    /// own figures.
    says: fn(&Question, &Rays) -> String,
}

/// Where a misconception sends the two.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prediction {
    /// Both rays.
    pub rays: Rays,
    /// The ray that gives the misconception away whatever the other one does; `None`
    /// if only both together do.
    pub telltale: Option<Ray>,
}

/// All misconceptions. Where an answer fits two alike, the earlier one is named.
pub static ALL: [&Misconception; 13] = [
    &copied_angle::COPIED_ANGLE,
    &always_square::ALWAYS_SQUARE,
    &half_and_half::HALF_AND_HALF,
    &swapped::SWAPPED,
    &heavy_unmoved::HEAVY_UNMOVED,
    &straight_on::STRAIGHT_ON,
    &pushed_ahead::PUSHED_AHEAD,
    &same_side::SAME_SIDE,
    &sides_exchanged::SIDES_EXCHANGED,
    &off_a_wall::OFF_A_WALL,
    &offset_as_angle::OFFSET_AS_ANGLE,
    &lossless::LOSSLESS,
    &always_stops::ALWAYS_STOPS,
];

impl Misconception {
    /// The misconception of an `id`.
    pub fn with_id(id: &str) -> Option<&'static Self> {
        ALL.into_iter().find(|misconception| misconception.id == id)
    }

    /// Where it sends the two in this question; `None` where it has nothing to say
    /// or happens to be right.
    pub fn predict(&self, question: &Question) -> Option<Prediction> {
        (self.predicts)(question).filter(|prediction| prediction.rays.gap(&question.truth()) > SAME)
    }

    /// What is wrong, in one or two sentences on the player's own figures.
    pub fn say(&self, question: &Question, said: &Rays) -> String {
        (self.says)(question, said)
    }
}

impl PartialEq for Misconception {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

impl Eq for Misconception {}

impl fmt::Debug for Misconception {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Misconception").field(&self.id).finish()
    }
}

/// Whether the truth and all that the misconceptions predict for this question are
/// far enough apart to tell from an answer which of them it follows.
pub fn is_clear(question: &Question) -> bool {
    let clear = rad_from_deg(CLEAR_DEG);
    let mut rays: Vec<Rays> = ALL
        .into_iter()
        .filter_map(|misconception| misconception.predict(question))
        .map(|prediction| prediction.rays)
        .collect();
    rays.push(question.truth());
    rays.iter()
        .enumerate()
        .all(|(i, a)| rays.iter().skip(i + 1).all(|b| a.gap(b) > clear))
}

/// A prediction on the usual sides: the striker away from the target, the target
/// towards its own side, both by these angles in radians.
fn on_usual_sides(question: &Question, theta1: f64, theta2: f64) -> Rays {
    let side = question.side();
    Rays::new(side * theta1, side * theta2)
}

#[cfg(test)]
mod tests {
    use super::super::{Given, Pieces};
    use super::*;

    fn question(pieces: Pieces, given: Given, restitution: f64) -> Question {
        Question {
            pieces,
            given,
            restitution,
            speed: 4.0,
            direction_deg: 0.0,
        }
    }

    /// What each belief gives in plain figures, worked out by hand.
    #[test]
    fn predictions_in_degrees() {
        let still = f64::NAN;
        let angle = |alpha_deg| Given::Angle { alpha_deg };
        let equal = question(Pieces::Equal, angle(30.0), 1.0);
        let to_the_left = question(Pieces::Equal, angle(-30.0), 1.0);
        let tournament = question(Pieces::Tournament, angle(30.0), 1.0);
        let marbles = question(Pieces::Marbles, angle(30.0), 1.0);
        let lossy = question(Pieces::Marbles, angle(45.0), 0.8);
        let offset = question(Pieces::Equal, Given::Offset { offset_mm: 10.0 }, 1.0);
        let head_on = question(Pieces::Tournament, angle(0.0), 1.0);
        for (id, question, theta1_deg, theta2_deg) in [
            ("copied-angle", equal, 30.0, 30.0),
            ("copied-angle", to_the_left, -30.0, -30.0),
            ("always-square", tournament, 60.0, 30.0),
            ("half-and-half", equal, 45.0, 45.0),
            ("swapped", equal, 30.0, 60.0),
            ("heavy-unmoved", tournament, 0.0, 30.0),
            ("heavy-unmoved", marbles, 120.0, still),
            ("straight-on", equal, 0.0, 30.0),
            ("pushed-ahead", equal, 60.0, 0.0),
            ("same-side", equal, -60.0, 30.0),
            ("sides-exchanged", equal, -60.0, -30.0),
            ("off-a-wall", equal, 120.0, 30.0),
            ("offset-as-angle", offset, 60.0, 30.0),
            ("lossless", lossy, 63.434_948_822_922_01, 45.0),
            ("always-stops", head_on, still, 0.0),
        ] {
            let angle = |deg: f64| (!deg.is_nan()).then(|| rad_from_deg(deg));
            let expected = Rays {
                striker: angle(theta1_deg),
                target: angle(theta2_deg),
            };
            let misconception = Misconception::with_id(id).unwrap();
            let found = misconception.predict(&question).unwrap().rays;
            assert!(found.gap(&expected) < 1e-12, "{id}: {found:?}");
        }
    }

    #[test]
    fn what_is_true_is_no_misconception() {
        let equal = question(Pieces::Equal, Given::Angle { alpha_deg: 30.0 }, 1.0);
        // m1 = e m2 opens a right angle again.
        let half = question(Pieces::Marbles, Given::Angle { alpha_deg: 30.0 }, 0.5);
        for question in [equal, half] {
            assert_eq!(always_square::ALWAYS_SQUARE.predict(&question), None);
        }
    }

    #[test]
    fn no_two_share_an_id_or_a_name() {
        for (i, a) in ALL.into_iter().enumerate() {
            for b in ALL.into_iter().skip(i + 1) {
                assert!(a.id != b.id && a.name != b.name);
            }
            assert_eq!(Misconception::with_id(a.id), Some(a));
        }
        assert_eq!(Misconception::with_id("none"), None);
    }
}
