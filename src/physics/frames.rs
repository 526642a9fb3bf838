//! The same collision in other reference frames.
//!
//! A frame moves with a constant velocity, which is subtracted from every velocity. Offset,
//! impact angle, line of impact and impulse are the same in all frames; speeds, scattering
//! angles and energies are not.

use glam::DVec2;

use super::Collision;

/// A reference frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Frame {
    /// The laboratory frame: the board is at rest.
    #[default]
    Laboratory,
    /// The centre-of-mass frame: the total momentum is zero before and after.
    CentreOfMass,
    /// The frame in which the target is at rest before the collision.
    Target,
}

impl Frame {
    /// Velocity of the frame in the laboratory, in m/s.
    pub fn velocity(self, collision: &Collision) -> DVec2 {
        match self {
            Self::Laboratory => DVec2::ZERO,
            Self::CentreOfMass => collision.centre_of_mass_velocity(),
            Self::Target => collision.u2,
        }
    }

    /// The collision in this frame. In its [`outcome`](Collision::outcome), the velocities are
    /// those of the laboratory frame minus the velocity of this frame, and the angles are those in
    /// this frame.
    #[must_use]
    pub fn view(self, collision: &Collision) -> Collision {
        let frame = self.velocity(collision);
        Collision {
            u1: collision.u1 - frame,
            u2: collision.u2 - frame,
            ..*collision
        }
    }
}

impl Collision {
    /// Scattering angle Θ in radians of discs that do not stick, in the centre-of-mass frame;
    /// `None` for a miss, or if both discs stop.
    pub(crate) fn cm_deflection(&self) -> Option<f64> {
        let alpha = self.alpha()?;
        if self.rims.friction > 0.0 {
            return Frame::CentreOfMass.view(self).outcome().theta1;
        }
        cm_scattering_angle(alpha, self.restitution)
    }
}

/// Scattering angle Θ in radians of both discs in the centre-of-mass frame, in
/// (−π, π], positive anticlockwise, for smooth discs with this coefficient of restitution.
///
/// Θ = atan2((1+e) sin α cos α, 1 − (1+e) cos²α), which at e = 1 is 180° − 2α. `None` if both discs
/// stop (head-on at e = 0).
pub(crate) fn cm_scattering_angle(alpha: f64, restitution: f64) -> Option<f64> {
    let (sin, cos) = alpha.sin_cos();
    let along = sin * sin - restitution * cos * cos;
    let across = (1.0 + restitution) * sin * cos;
    (along.hypot(across) > 4.0 * f64::EPSILON).then(|| across.atan2(along))
}

/// Scattering angle θ₁ in the laboratory frame, for a target at rest, from the scattering
/// angle Θ in the centre-of-mass frame at e = 1: θ₁ = atan2(sin Θ, cos Θ + m₁/m₂).
/// `None` if the striker stops.
pub(crate) fn lab_scattering_angle(cm_angle: f64, m1: f64, m2: f64) -> Option<f64> {
    let (sin, cos) = cm_angle.sin_cos();
    let along = m2 * cos + m1;
    let across = m2 * sin;
    (along.hypot(across) > 4.0 * f64::EPSILON * (m1 + m2)).then(|| across.atan2(along))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{CollisionOutcome, Disc, RestingTarget, angle, impact::kinetic_energy};
    use std::f64::consts::{FRAC_PI_2, PI};

    fn both_moving() -> Collision {
        Collision {
            u2: DVec2::new(-1.0, 0.5),
            ..Collision::at_angle(
                Disc::from_g_mm(20.0, 12.0),
                Disc::from_g_mm(40.0, 15.0),
                DVec2::new(3.0, 1.0),
                0.7,
            )
        }
    }

    #[test]
    fn momentum_is_zero_in_the_centre_of_mass_frame() {
        for e in [0.0, 0.6, 1.0] {
            let lab = Collision {
                restitution: e,
                ..both_moving()
            };
            let cm = Frame::CentreOfMass.view(&lab);
            let CollisionOutcome { v1, v2, .. } = cm.outcome();
            let (m1, m2) = (lab.striker.mass, lab.target.mass);
            assert!((m1 * cm.u1 + m2 * cm.u2).length() < 1e-16);
            assert!((m1 * v1 + m2 * v2).length() < 1e-16);
            assert!((angle::angle_between(cm.u1, cm.u2).unwrap() - PI).abs() < 1e-14);
            assert!((cm.outcome().separation.unwrap() - PI).abs() < 1e-14);
        }
    }

    #[test]
    fn in_the_centre_of_mass_frame_both_keep_their_speed_and_turn_equally() {
        let lab = both_moving();
        let cm = Frame::CentreOfMass.view(&lab);
        let after = cm.outcome();
        assert!((after.v1.length() - cm.u1.length()).abs() < 1e-14);
        assert!((after.v2.length() - cm.u2.length()).abs() < 1e-14);
        let turned1 = angle::signed_angle(cm.u1, after.v1).unwrap();
        let turned2 = angle::signed_angle(cm.u2, after.v2).unwrap();
        assert!((turned1 - (PI - 2.0 * 0.7)).abs() < 1e-14);
        assert!((turned2 - turned1).abs() < 1e-14);
        assert_eq!(
            cm_scattering_angle(0.7, 1.0).map(|a| (a - turned1).abs() < 1e-14),
            Some(true)
        );
    }

    #[test]
    fn the_closed_form_gives_the_scattering_angle_at_any_restitution() {
        for e in [0.0, 0.3, 0.9] {
            let lab = Collision {
                restitution: e,
                ..both_moving()
            };
            let turned = Frame::CentreOfMass.view(&lab).outcome().theta1.unwrap();
            assert!((cm_scattering_angle(0.7, e).unwrap() - turned).abs() < 1e-13);
        }
        assert_eq!(cm_scattering_angle(0.0, 0.0), None);
    }

    /// Adding the frame's velocity back gives the outcome in the laboratory frame.
    #[test]
    fn every_frame_gives_the_same_collision() {
        let lab = both_moving();
        let truth = lab.outcome();
        for frame in [Frame::Laboratory, Frame::CentreOfMass, Frame::Target] {
            let seen = frame.view(&lab).outcome();
            let shift = frame.velocity(&lab);
            assert!((seen.v1 + shift - truth.v1).length() < 1e-14);
            assert!((seen.v2 + shift - truth.v2).length() < 1e-14);
            assert!((seen.impulse - truth.impulse).abs() < 1e-15);
            let change = |u: DVec2, v: DVec2| {
                kinetic_energy(1.0, v - shift) - kinetic_energy(1.0, u - shift)
            };
            let gained1 = lab.striker.mass * change(lab.u1, truth.v1);
            let gained2 = lab.target.mass * change(lab.u2, truth.v2);
            assert!((gained1 + gained2).abs() < 1e-15);
        }
    }

    /// The 90° rule with both discs moving: v₁ − u₂ ⟂ v₂ − u₂ for equal masses.
    #[test]
    fn equal_masses_leave_at_90_degrees_in_the_frame_where_one_was_at_rest() {
        let lab = Collision {
            target: Disc::from_g_mm(20.0, 15.0),
            ..both_moving()
        };
        let CollisionOutcome {
            v1, v2, separation, ..
        } = lab.outcome();
        assert!((v1 - lab.u2).dot(v2 - lab.u2).abs() < 1e-14);
        let seen = Frame::Target.view(&lab).outcome();
        assert!((seen.separation.unwrap() - FRAC_PI_2).abs() < 1e-14);
        assert!(
            (separation.unwrap() - FRAC_PI_2).abs() > 0.1,
            "not in the laboratory"
        );
    }

    #[test]
    fn laboratory_angles_follow_from_centre_of_mass_angles() {
        for (m1, m2) in [(15.0, 15.0), (20.0, 40.0), (15.0, 5.5)] {
            for step in 1..90 {
                let alpha = f64::from(step).to_radians();
                let cm = cm_scattering_angle(alpha, 1.0).unwrap();
                let lab = lab_scattering_angle(cm, m1, m2).unwrap();
                let closed = RestingTarget {
                    m1,
                    m2,
                    restitution: 1.0,
                };
                assert!((lab - closed.theta1(alpha).unwrap()).abs() < 1e-13);
                if m1.total_cmp(&m2).is_eq() {
                    assert!((lab - cm / 2.0).abs() < 1e-14);
                    assert!((alpha - (FRAC_PI_2 - cm / 2.0)).abs() < 1e-14);
                }
            }
        }
        assert_eq!(lab_scattering_angle(PI, 15.0, 15.0), None);
    }
}
