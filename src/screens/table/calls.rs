//! "Call it": saying before a stroke where the two of its first impact will go.

use super::preview::first_hit;
use crate::game::{Call, Strike};
use crate::physics::Shot;
use crate::quiz::{Rays, RaysGrade};

/// A call and what came of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Called {
    /// What was said.
    pub(super) said: Rays,
    /// Where they went.
    pub(super) truth: Rays,
}

impl Called {
    /// Most points a call can bring.
    pub(super) const MOST: u32 = 10;

    /// The call of a stroke against its shot; `None` if nothing was called or
    /// nothing was hit.
    pub(super) fn new(strike: &Strike, shot: &Shot) -> Option<Self> {
        let said = rays(&strike.call?);
        let outcome = first_hit(shot)?.impact.collision.outcome();
        Some(Self {
            said,
            truth: Rays::from(&outcome),
        })
    }

    /// Points for it, 0 to [`Called::MOST`], by how far off each ray was: graded as
    /// in the quiz, without a question of confidence.
    pub(super) fn points(&self) -> u32 {
        let grade = RaysGrade::new(&self.said, &self.truth);
        (grade.credit() * f64::from(Self::MOST)).round() as u32
    }
}

/// What was said as a record keeps it.
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
    fn a_call_earns_by_how_near_it_is() {
        let truth = Rays::new(0.3, 0.5);
        let points = |striker: f64, coin: f64| {
            let said = Rays::new(0.3 + striker.to_radians(), 0.5 + coin.to_radians());
            Called { said, truth }.points()
        };
        assert_eq!(points(0.0, 0.0), 10);
        assert_eq!(points(0.0, 90.0), 5);
        assert_eq!(points(16.0, -16.0), 5);
        assert_eq!(points(40.0, 40.0), 0);
    }
}
