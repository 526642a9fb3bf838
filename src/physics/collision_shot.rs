//! The record of a [`Collision`] as a shot on a frictionless open sheet.

use super::engine::{Limits, check, play};
use super::{Board, Collision, Motion, Shot};

impl Collision {
    /// The two discs as a shot that starts `lead` seconds before the contact (or the closest
    /// approach) and lasts `duration` seconds, with the contact point at the origin. The engine
    /// plays smooth discs; friction at the rims changes the velocities with which they leave.
    ///
    /// `None` if the numbers do not describe a shot: for example, if `lead` is not finite, or if it
    /// is negative and the discs would overlap at the start.
    pub fn shot(&self, lead: f64, duration: f64) -> Option<Shot> {
        let (p1, p2) = self.positions_before(lead);
        let discs = [self.striker, self.target];
        let start = [Motion::new(p1, self.u1), Motion::new(p2, self.u2)];
        let limits = Limits::until(duration);
        match self.coalesces() {
            false => {
                let mut shot = play(&Board::open(self.restitution), &discs, &start, limits).ok()?;
                let outcome = self.outcome();
                if outcome.friction_impulse != 0.0 {
                    shot.leave_with([outcome.v1, outcome.v2]);
                }
                Some(shot)
            }
            true => {
                let board = Board::open(0.0);
                check(&board, &discs, &start, limits).ok()?;
                let ends = duration.is_finite();
                ends.then(|| Shot::captured(&board, discs, start, duration))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;
    use crate::physics::{Bond, Disc, EventKind};

    fn glancing(bond: Bond) -> Collision {
        let (striker, target) = (Disc::from_g_mm(20.0, 12.0), Disc::from_g_mm(40.0, 15.0));
        Collision {
            u2: DVec2::new(-0.5, 0.25),
            restitution: 0.7,
            bond,
            ..Collision::at_angle(striker, target, DVec2::new(3.0, 0.0), 0.6)
        }
    }

    #[test]
    fn the_engine_agrees_with_the_closed_form() {
        let collision = glancing(Bond::Slip);
        let outcome = collision.outcome();
        let shot = collision.shot(0.02, 0.05).unwrap();
        let impacts: Vec<_> = shot
            .events()
            .iter()
            .filter(|event| matches!(event.kind, EventKind::Impact { .. }))
            .collect();
        assert_eq!(impacts.len(), 1);
        assert!((impacts[0].time - 0.02).abs() < 1e-12);
        assert!((shot.at(0, 0.04).velocity - outcome.v1).length() < 1e-10);
        assert!((shot.at(1, 0.04).velocity - outcome.v2).length() < 1e-10);
    }

    #[test]
    fn a_pair_that_sticks_shares_one_centre_of_mass() {
        let collision = glancing(Bond::Stick);
        let outcome = collision.outcome();
        let shot = collision.shot(0.02, 0.05).unwrap();
        let centre = |t| {
            (collision.striker.mass * shot.at(0, t).position
                + collision.target.mass * shot.at(1, t).position)
                / (collision.striker.mass + collision.target.mass)
        };
        let drift = (centre(0.05) - centre(0.03)) / 0.02;
        assert!((drift - outcome.v1).length() < 1e-10);
        let apart = shot
            .at(0, 0.05)
            .position
            .distance(shot.at(1, 0.05).position);
        assert!((apart - collision.contact_distance()).abs() < 1e-12);
    }

    #[test]
    fn discs_that_only_graze_each_other_never_stick() {
        for (r1, r2) in [(15.0, 15.0), (20.65, 15.9), (12.4, 15.6), (10.0, 7.1)] {
            let (striker, target) = (Disc::from_g_mm(15.0, r1), Disc::from_g_mm(5.5, r2));
            for side in [-1.0, 1.0] {
                let offset = side * (striker.radius + target.radius);
                let collision = Collision {
                    bond: Bond::Stick,
                    ..Collision::at_offset(striker, target, DVec2::new(4.0, 0.0), offset)
                };
                let shot = collision.shot(0.01, 0.05).unwrap();
                let after = [0, 1].map(|disc| shot.at(disc, 0.05).velocity);
                assert!(after[0].abs_diff_eq(collision.u1, 1e-6), "{after:?}");
                assert!(after[1].length() < 1e-6, "{after:?}");
            }
        }
    }

    #[test]
    fn unusable_numbers_give_no_shot() {
        for bond in [Bond::Slip, Bond::Stick] {
            assert!(glancing(bond).shot(1e-9, 0.05).is_some());
            assert!(glancing(bond).shot(-1e-3, 0.05).is_none());
            assert!(glancing(bond).shot(f64::NAN, 0.05).is_none());
        }
    }
}
