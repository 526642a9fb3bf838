//! Misconceptions about collisions: those about where both discs will go, and the others in the
//! catalogue.
//!
//! A misconception about rays predicts the rays of every `Hit` to which it applies; a family of
//! questions that asks for anything else must define the answers that misconceptions lead to. A
//! question is asked only if it can distinguish the misconceptions: their answers and the right
//! answer must be so far apart that no answer could fit two of them completely.

mod catalogue;
mod evidence;
mod explain;
mod of_rays;
mod reasoning;
mod why;

pub use catalogue::Origin;
pub use evidence::{Clue, named};
pub(crate) use evidence::{Evidence, NAMED_ODDS, SLIP, evidence};
pub use explain::explain;
pub use of_rays::OF_RAYS;
pub(crate) use reasoning::reasoning;
pub use why::why;
pub(crate) use why::why_of_hit;

#[cfg(test)]
mod tests {
    use crate::physics::ImpactPoint;
    use crate::physics::units::rad_from_deg;
    use crate::quiz::question::{Hit, Misconception, Pieces, Rays};

    fn hit(pieces: Pieces, given: ImpactPoint, restitution: f64) -> Hit {
        Hit {
            pieces,
            given,
            restitution,
            speed: 4.0,
            direction_deg: 0.0,
        }
    }

    /// The predictions of each misconception, calculated by hand.
    #[test]
    fn predictions_agree_with_a_calculation_by_hand() {
        let still = f64::NAN;
        let angle = |alpha_deg| ImpactPoint::Angle { alpha_deg };
        let equal = hit(Pieces::Equal, angle(30.0), 1.0);
        let to_the_left = hit(Pieces::Equal, angle(-30.0), 1.0);
        let tournament = hit(Pieces::Tournament, angle(30.0), 1.0);
        let marbles = hit(Pieces::Marbles, angle(30.0), 1.0);
        let lossy = hit(Pieces::Marbles, angle(45.0), 0.8);
        let offset = hit(Pieces::Equal, ImpactPoint::Offset { offset_mm: 10.0 }, 1.0);
        let head_on = hit(Pieces::Tournament, angle(0.0), 1.0);
        for (id, hit, theta1_deg, theta2_deg) in [
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
            let found = misconception.predict(&hit).unwrap().0;
            assert!(found.gap(&expected) < 1e-12, "{id}: {found:?}");
        }
    }

    #[test]
    fn a_right_prediction_is_not_a_misconception() {
        let equal = hit(Pieces::Equal, ImpactPoint::Angle { alpha_deg: 30.0 }, 1.0);
        // With m1 = e m2 the angle is 90° in spite of the loss.
        let half = hit(Pieces::Marbles, ImpactPoint::Angle { alpha_deg: 30.0 }, 0.5);
        for hit in [equal, half] {
            assert_eq!(Misconception::AlwaysSquare.predict(&hit), None);
        }
    }

    #[test]
    fn no_two_misconceptions_share_an_id_or_a_name() {
        for (i, a) in Misconception::ALL.iter().enumerate() {
            for b in &Misconception::ALL[i + 1..] {
                assert!(a.id() != b.id() && a.name() != b.name());
            }
            assert_eq!(Misconception::with_id(a.id()), Some(*a));
        }
        assert_eq!(Misconception::with_id("none"), None);
        let merged = Misconception::with_id("linear-offset");
        assert_eq!(merged, Some(Misconception::OffsetAsAngle));
    }
}
