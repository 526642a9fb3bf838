//! The steps in which a player sets a stroke.
//!
//! The keys of the table use these steps, and so do hints: a stroke that cannot be set is useless.

use glam::DVec2;

use super::placing::BaseLines;
use super::seat::Seat;
use crate::physics::Motion;
use crate::physics::angle::heading;
use crate::physics::units::deg_from_rad;

/// A step of the striker along the base lines, in metres.
pub(crate) const PLACE_STEP: f64 = 0.002;
/// The rounding error allowed in a position, in metres.
const SLACK: f64 = 1e-9;
/// Steps of direction per degree.
pub(crate) const STEPS_PER_DEGREE: f64 = 10.0;
/// Steps of speed per m/s.
pub(crate) const STEPS_PER_SPEED: f64 = 10.0;

/// The stroke with its direction and speed, as seen from `seat`, rounded to the nearest steps; the
/// speed is at least one step. `None` for a stroke without motion.
pub(crate) fn on_steps(stroke: Motion, seat: Seat) -> Option<Motion> {
    let way = seat.turn_back(stroke.velocity.try_normalize()?);
    let degrees = deg_from_rad(way.to_angle());
    let direction = (degrees * STEPS_PER_DEGREE).round() / STEPS_PER_DEGREE;
    let steps = (stroke.velocity.length() * STEPS_PER_SPEED).round();
    let speed = steps.max(1.0) / STEPS_PER_SPEED;
    Some(Motion {
        velocity: speed * seat.turn(heading(direction.rem_euclid(360.0))),
        ..stroke
    })
}

impl BaseLines<'_> {
    /// The legal position nearest to `at` that is a whole number of steps from the middle or on a
    /// base circle. `None` if there is none.
    pub(crate) fn nearest_on_steps(&self, at: DVec2) -> Option<DVec2> {
        self.nearest_of(Self::steps(), at)
    }

    /// The first legal position on the steps that is at least `metres`, to the nearest step, to the
    /// player's right of `from` (negative: to the left); if there is none that far, the last legal
    /// one on that side. `None` if no position on that side is legal.
    pub(crate) fn next_on_steps(&self, from: DVec2, metres: f64) -> Option<DVec2> {
        let (here, sense) = (self.along(from), metres.signum());
        // A target that is not on a step is rounded to the nearest step.
        let least = here + metres - sense * PLACE_STEP / 2.0;
        let ahead: Vec<f64> = Self::steps()
            .filter(|along| (along - here) * sense > SLACK)
            .filter(|along| self.check(self.at(*along)).is_ok())
            .collect();
        let first = |a: &f64, b: &f64| (sense * a).total_cmp(&(sense * b));
        let far_enough = ahead.iter().filter(|along| (*along - least) * sense >= 0.0);
        let next = far_enough.copied().min_by(first);
        let last = || ahead.iter().copied().max_by(first);
        next.or_else(last).map(|along| self.at(along))
    }

    /// All steps along the lines, and both base circles, in metres from the middle.
    fn steps() -> impl Iterator<Item = f64> {
        let end = Self::base_circle_along();
        let count = (end / PLACE_STEP).floor() as i32;
        let steps = (-count..=count).map(|step| f64::from(step) * PLACE_STEP);
        steps.chain([-end, end])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::{Coin, Piece, PieceSet};

    const SET: PieceSet = PieceSet::Tournament;

    fn coin(along: f64) -> Coin {
        let lines = BaseLines::new(SET, Seat::South, &[]);
        Coin {
            piece: Piece::Black,
            at: lines.at(along),
        }
    }

    /// Between 182.55 mm and 214.35 mm from the middle the striker would cut a base circle; from
    /// there on it covers the circle.
    #[test]
    fn a_step_skips_illegal_positions() {
        for seat in Seat::ALL {
            let lines = BaseLines::new(SET, seat, &[]);
            let mut at = lines.at(0.0);
            let mut passed = Vec::new();
            while let Some(next) = lines.next_on_steps(at, PLACE_STEP) {
                assert_eq!(lines.check(next), Ok(()));
                at = next;
                passed.push((lines.along(at) * 1e4).round() / 10.0);
            }
            assert_eq!(passed.len(), 91 + 3);
            assert_eq!(passed[89..], [180.0, 182.0, 216.0, 218.0, 219.1]);
            // The steps lead all the way back through the middle.
            let mut places = vec![at];
            while let Some(next) = lines.next_on_steps(at, -PLACE_STEP) {
                at = next;
                places.push(at);
            }
            assert!(places.contains(&lines.at(0.0)));
        }
    }

    #[test]
    fn a_step_skips_a_coin_and_returns_to_the_steps() {
        let coins = [coin(0.0)];
        let lines = BaseLines::new(SET, Seat::South, &coins);
        let beside = lines.nearest(lines.at(0.01)).unwrap();
        let reach = SET.striker_radius() + SET.coin_radius();
        assert!((lines.along(beside) - reach).abs() < 2e-4, "36.65 mm");
        let next = lines.next_on_steps(beside, PLACE_STEP).unwrap();
        assert!((lines.along(next) - 0.038).abs() < 1e-12);
        let across = lines.next_on_steps(beside, -PLACE_STEP).unwrap();
        assert!((lines.along(across) + 0.038).abs() < 1e-12);
        assert_eq!(lines.nearest_on_steps(lines.at(0.001)), Some(next));
    }

    #[test]
    fn a_stroke_is_rounded_by_less_than_half_a_step() {
        for seat in Seat::ALL {
            for tenth in 1..60 {
                let turn = f64::from(tenth) * 0.1037;
                let stroke = Motion {
                    position: DVec2::ZERO,
                    velocity: DVec2::from_angle(turn) * (0.3 + 0.0613 * f64::from(tenth)),
                };
                let rounded = on_steps(stroke, seat).unwrap();
                let apart = stroke.velocity.angle_to(rounded.velocity).abs();
                assert!(apart < 0.0501_f64.to_radians(), "{apart}");
                let faster = rounded.velocity.length() - stroke.velocity.length();
                assert!(faster.abs() < 0.0501, "{faster}");
                assert_eq!(on_steps(rounded, seat), Some(rounded));
            }
        }
        assert_eq!(on_steps(Motion::at_rest(DVec2::ZERO), Seat::South), None);
    }
}
