//! Two rays, which show where the striker and its target go.

use std::f64::consts::TAU;

use serde_json::{Value, json};

use crate::physics::CollisionOutcome;
use crate::physics::units::{deg_from_rad, rad_from_deg};

use super::Figures;
use super::tolerance::is_within;
use crate::numbers;

/// One of the two rays.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Ray {
    /// The striker's ray.
    Striker,
    /// The target's ray.
    Target,
}

impl Ray {
    /// Both rays, with the striker's first.
    pub const BOTH: [Self; 2] = [Self::Striker, Self::Target];

    /// Converts the angle of this ray so that it is positive to the left: a scattering angle
    /// already is, whereas a recoil angle is positive to the right.
    pub(crate) fn leftward(self, angle: f64) -> f64 {
        match self {
            Self::Striker => angle,
            Self::Target => -angle,
        }
    }

    /// The direction of this ray in words: "60.0° left", "straight ahead", "stays still". Left and
    /// right are as seen along the striker's path.
    pub fn words(self, angle: Option<f64>) -> String {
        match angle.map(|angle| self.leftward(angle)) {
            None => "stays still".into(),
            Some(angle) => match numbers::tenths(angle.abs()) {
                0 => "straight ahead".into(),
                1800 => "straight back".into(),
                _ if angle > 0.0 => format!("{} left", numbers::degrees(angle)),
                _ => format!("{} right", numbers::degrees(-angle)),
            },
        }
    }
}

/// Where the two discs go, or are predicted to go.
///
/// The angles are in radians and follow the sign convention of physics: the striker's scattering
/// angle θ₁ is positive anticlockwise, and the target's recoil angle θ₂ is positive clockwise, both
/// measured from the striker's original direction. `None` means that the disc stays still.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Rays {
    /// The scattering angle θ₁.
    pub striker: Option<f64>,
    /// The recoil angle θ₂.
    pub target: Option<f64>,
}

impl Rays {
    /// The largest angle, in degrees, by which a ray can be turned to either side.
    pub(crate) const FURTHEST_DEG: f64 = 180.0;

    /// Creates rays for two moving discs, given these angles in radians.
    pub const fn new(theta1: f64, theta2: f64) -> Self {
        Self {
            striker: Some(theta1),
            target: Some(theta2),
        }
    }

    /// Whether neither ray is turned by more than [`Self::FURTHEST_DEG`].
    pub(crate) fn are_in_range(&self) -> bool {
        let most = Self::FURTHEST_DEG;
        let mut angles = [self.striker, self.target].into_iter().flatten();
        angles.all(|angle| is_within(deg_from_rad(angle), -most, most))
    }

    /// Both angles in degrees, with the names and signs used by `carrom solve`.
    pub fn json(&self) -> Value {
        json!({
            "theta1_deg": self.striker.map(deg_from_rad),
            "theta2_deg": self.target.map(deg_from_rad),
        })
    }

    /// Reads what [`Rays::json`] writes; `None` if a field is missing or invalid. Other fields are
    /// ignored.
    pub(crate) fn of_figures(figures: &Figures) -> Option<Self> {
        let ray = |name| match figures.get(name)? {
            Value::Null => Some(None),
            angle => {
                let degrees = angle.as_f64().filter(|angle| angle.abs() <= 360.0)?;
                Some(Some(rad_from_deg(degrees)))
            }
        };
        Some(Self {
            striker: ray("theta1_deg")?,
            target: ray("theta2_deg")?,
        })
    }

    /// Both directions in words, as seen along the striker's path, where `target` is the name of
    /// the target: "striker 60.0° left, coin 30.0° right".
    pub fn words(&self, target: &str) -> String {
        let [striker, other] = Ray::BOTH.map(|ray| ray.words(self.get(ray)));
        format!("striker {striker}, {target} {other}")
    }

    /// The angle of a ray, in radians; `None` if its disc stays still.
    pub fn get(&self, ray: Ray) -> Option<f64> {
        match ray {
            Ray::Striker => self.striker,
            Ray::Target => self.target,
        }
    }

    /// The angle between a ray and the same ray of `other`, in radians from 0 to π; 0 if the disc
    /// stays still in both, `None` if the disc stays still in only one of them.
    pub fn apart(&self, other: &Self, ray: Ray) -> Option<f64> {
        match (self.get(ray), other.get(ray)) {
            (None, None) => Some(0.0),
            (Some(a), Some(b)) => {
                let turn = (a - b).rem_euclid(TAU);
                Some(turn.min(TAU - turn))
            }
            _ => None,
        }
    }

    /// The larger of the two [angles between corresponding rays](Self::apart); infinite if a disc
    /// moves in one prediction and stays still in the other.
    pub fn gap(&self, other: &Self) -> f64 {
        Ray::BOTH
            .map(|ray| self.apart(other, ray).unwrap_or(f64::INFINITY))
            .into_iter()
            .fold(0.0, f64::max)
    }
}

impl From<&CollisionOutcome> for Rays {
    fn from(outcome: &CollisionOutcome) -> Self {
        Self {
            striker: outcome.theta1,
            target: outcome.theta2,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rad(angle_deg: f64) -> f64 {
        angle_deg.to_radians()
    }

    #[test]
    fn gaps_are_measured_the_short_way_round() {
        let a = Rays::new(rad(175.0), rad(-10.0));
        let b = Rays::new(rad(-175.0), rad(20.0));
        assert!((a.apart(&b, Ray::Striker).unwrap() - rad(10.0)).abs() < 1e-12);
        assert!((a.gap(&b) - rad(30.0)).abs() < 1e-12);
    }

    #[test]
    fn a_still_and_a_moving_disc_have_no_angle_between_them() {
        let still = Rays {
            striker: None,
            ..Rays::new(0.0, 0.0)
        };
        assert_eq!(still.apart(&still, Ray::Striker), Some(0.0));
        assert_eq!(still.apart(&Rays::new(0.0, 0.0), Ray::Striker), None);
        assert!(still.gap(&Rays::new(0.0, 0.0)).is_infinite());
    }

    #[test]
    fn sides_are_named_as_seen_along_the_path() {
        assert_eq!(Ray::Striker.words(Some(rad(60.0))), "60.0° left");
        assert_eq!(Ray::Target.words(Some(rad(30.0))), "30.0° right");
        assert_eq!(Ray::Target.words(Some(rad(-30.0))), "30.0° left");
        assert_eq!(Ray::Striker.words(Some(-1e-9)), "straight ahead");
        assert_eq!(Ray::Striker.words(Some(rad(180.0))), "straight back");
        assert_eq!(Ray::Striker.words(None), "stays still");
    }
}
