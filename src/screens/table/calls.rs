//! Calls: predictions of the directions after the first impact of a stroke.

use super::preview::first_hit;
use crate::game::{Call, Strike};
use crate::physics::{Collision, Shot};
use crate::quiz::{Rays, RaysGrade};

/// A call and its result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Called {
    pub(super) said: Rays,
    /// The collision that was predicted.
    pub(super) collision: Collision,
}

impl Called {
    /// The largest number of points for a call.
    pub(super) const MOST: u32 = 10;

    /// The call made for a stroke, with the first collision of its shot; `None` if there was no
    /// call or no collision.
    pub(super) fn new(strike: &Strike, shot: &Shot) -> Option<Self> {
        let said = rays(&strike.call?);
        let collision = first_hit(shot)?.impact.collision;
        Some(Self { said, collision })
    }

    /// Points for the call, from 0 to [`Called::MOST`], according to the error of each ray: graded
    /// as in the quiz, but without confidence.
    pub(super) fn points(&self) -> u32 {
        let truth = Rays::from(&self.collision.outcome());
        let grade = RaysGrade::new(&self.said, &truth);
        (grade.credit() * f64::from(Self::MOST)).round() as u32
    }
}

/// The predicted rays, as a record stores them.
pub(super) fn call(said: &Rays) -> Call {
    Call {
        striker_deg: said.striker.map(f64::to_degrees),
        coin_deg: said.target.map(f64::to_degrees),
    }
}

fn rays(call: &Call) -> Rays {
    Rays {
        striker: call.striker_deg.map(f64::to_radians),
        target: call.coin_deg.map(f64::to_radians),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_call_earns_more_points_the_smaller_its_error() {
        let disc = crate::physics::Disc {
            mass: 0.015,
            radius: 0.02,
        };
        let collision = Collision::at_angle(disc, disc, 4.0 * glam::DVec2::X, 0.5);
        let truth = Rays::from(&collision.outcome());
        let points = |striker: f64, coin: f64| {
            let said = Rays {
                striker: truth.striker.map(|angle| angle + striker.to_radians()),
                target: truth.target.map(|angle| angle + coin.to_radians()),
            };
            Called { said, collision }.points()
        };
        assert_eq!(points(0.0, 0.0), 10);
        assert_eq!(points(0.0, 90.0), 5);
        assert_eq!(points(16.0, -16.0), 5);
        assert_eq!(points(40.0, 40.0), 0);
    }
}
