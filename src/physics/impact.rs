//! One contact of two smooth bodies with restitution.
//!
//! Along the line of impact n the two bodies exchange an impulse. Along the tangent t smooth
//! bodies exert no force, so the tangential components do not change.

use glam::DVec2;

/// Two bodies at the instant of contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Contact {
    /// Mass of body 1 in kilograms, positive.
    pub m1: f64,
    /// Mass of body 2 in kilograms, positive.
    pub m2: f64,
    /// Velocity of body 1 before the contact, in m/s.
    pub u1: DVec2,
    /// Velocity of body 2 before the contact, in m/s.
    pub u2: DVec2,
    /// Line of impact: the unit vector from centre 1 to centre 2.
    pub normal: DVec2,
    /// Coefficient of restitution e, 0 to 1.
    pub restitution: f64,
}

/// The result of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Impact {
    /// Velocity of body 1 after the contact, in m/s.
    pub v1: DVec2,
    /// Velocity of body 2 after the contact, in m/s.
    pub v2: DVec2,
    /// Impulse J on body 2 along n (and on body 1 against it), in N·s.
    pub impulse: f64,
    /// Kinetic energy lost, in joules: ½ μ (1 − e²) (u₁ₙ − u₂ₙ)².
    pub energy_lost: f64,
}

impl Contact {
    /// Speed of approach along the line of impact, u₁ₙ − u₂ₙ, in m/s; positive while the bodies
    /// approach each other.
    pub(crate) fn approach_speed(&self) -> f64 {
        (self.u1 - self.u2).dot(self.normal)
    }

    /// Resolves the contact; `None` unless the bodies are approaching each other.
    ///
    /// v₁ = u₁ − (J/m₁) n and v₂ = u₂ + (J/m₂) n with J = (1+e) μ (u₁ₙ − u₂ₙ). These
    /// formulas combine the components along n and t. A body that comes to rest gets a velocity of
    /// exactly zero, without rounding noise.
    #[inline]
    pub(crate) fn resolve(&self) -> Option<Impact> {
        let approach = self.approach_speed();
        if approach.is_nan() || approach <= 0.0 {
            return None;
        }
        let total = self.m1 + self.m2;
        let change = (1.0 + self.restitution) * approach;
        let change1 = change * (self.m2 / total);
        let change2 = change * (self.m1 / total);
        let mu = reduced_mass(self.m1, self.m2);
        let lost = 1.0 - self.restitution * self.restitution;
        Some(Impact {
            v1: changed(self.u1, -change1, self.normal),
            v2: changed(self.u2, change2, self.normal),
            impulse: mu * change,
            energy_lost: 0.5 * mu * lost * approach * approach,
        })
    }
}

/// Reduced mass μ = m₁m₂ / (m₁ + m₂), in the unit of the masses.
pub(crate) fn reduced_mass(m1: f64, m2: f64) -> f64 {
    m1 * (m2 / (m1 + m2))
}

/// Kinetic energy ½ m v² in joules.
pub(crate) fn kinetic_energy(mass: f64, velocity: DVec2) -> f64 {
    0.5 * mass * velocity.length_squared()
}

/// `before + change · direction`, or exactly zero if the two cancel except for rounding: the
/// normal, the product and the sum are each accurate to an ulp or two. (The sum of the
/// components' absolute values replaces the length, which would need a root.)
pub(super) fn changed(before: DVec2, change: f64, direction: DVec2) -> DVec2 {
    let after = before + change * direction;
    let size = before.x.abs() + before.y.abs() + change.abs();
    let noise = 16.0 * f64::EPSILON * size;
    if after.length_squared() <= noise * noise {
        DVec2::ZERO
    } else {
        after
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contact(normal: DVec2, restitution: f64) -> Contact {
        Contact {
            m1: 0.020,
            m2: 0.040,
            u1: DVec2::new(3.0, 0.5),
            u2: DVec2::new(-1.0, 2.0),
            normal,
            restitution,
        }
    }

    /// Checks the textbook formulas for the components, one by one.
    #[test]
    fn components_follow_the_textbook() {
        for e in [0.0, 0.4, 1.0] {
            let n = DVec2::from_angle(-0.6);
            let t = n.perp();
            let c = contact(n, e);
            let Contact { m1, m2, u1, u2, .. } = c;
            let after = c.resolve().unwrap();
            let (u1n, u2n) = (u1.dot(n), u2.dot(n));
            let v1n = ((m1 - e * m2) * u1n + (1.0 + e) * m2 * u2n) / (m1 + m2);
            let v2n = ((m2 - e * m1) * u2n + (1.0 + e) * m1 * u1n) / (m1 + m2);
            assert!((after.v1.dot(n) - v1n).abs() < 1e-14);
            assert!((after.v2.dot(n) - v2n).abs() < 1e-14);
            assert!((after.v1.dot(t) - u1.dot(t)).abs() < 1e-14);
            assert!((after.v2.dot(t) - u2.dot(t)).abs() < 1e-14);
            let j = (1.0 + e) * (m1 * m2 / (m1 + m2)) * (u1n - u2n);
            assert!((after.impulse - j).abs() < 1e-15);
            assert!((m2 * (after.v2 - u2).dot(n) - j).abs() < 1e-15);
            let before = kinetic_energy(m1, u1) + kinetic_energy(m2, u2);
            let left = kinetic_energy(m1, after.v1) + kinetic_energy(m2, after.v2);
            assert!((before - left - after.energy_lost).abs() < 1e-15);
        }
    }

    #[test]
    fn the_relative_normal_speed_is_reversed_and_scaled_by_restitution() {
        let n = DVec2::from_angle(0.3);
        let c = contact(n, 0.7);
        let after = c.resolve().unwrap();
        let separation = (after.v2 - after.v1).dot(n);
        assert!((separation - 0.7 * c.approach_speed()).abs() < 1e-14);
    }

    #[test]
    fn bodies_that_do_not_approach_exchange_nothing() {
        assert!(contact(-DVec2::X, 1.0).resolve().is_none());
        let side_by_side = Contact {
            u2: DVec2::new(3.0, 0.5),
            ..contact(DVec2::X, 1.0)
        };
        assert!(side_by_side.resolve().is_none());
    }

    #[test]
    fn a_head_on_hit_between_equal_masses_stops_the_striker_exactly_in_any_direction() {
        for step in 0..1000 {
            let u1 = 4.0 * DVec2::from_angle(f64::from(step) * 0.37);
            let after = Contact {
                m1: 0.0151,
                m2: 0.0151,
                u1,
                u2: DVec2::ZERO,
                normal: u1.normalize(),
                restitution: 1.0,
            }
            .resolve()
            .unwrap();
            assert_eq!(after.v1, DVec2::ZERO);
            assert!((after.v2 - u1).length() < 1e-14);
        }
    }
}
