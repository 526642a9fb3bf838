//! Properties of every collision, for all masses, velocities, offsets and restitutions.

use carrom::physics::{Bond, Collision, Disc, Frame, RestingTarget, units};
use glam::DVec2;
use proptest::prelude::*;

/// Masses from a milligram to a kilogram, distributed evenly over the powers of ten.
fn mass_g() -> impl Strategy<Value = f64> {
    (-3.0..3.0_f64).prop_map(|power| 10.0_f64.powf(power))
}

fn disc() -> impl Strategy<Value = Disc> {
    (mass_g(), 1.0..50.0_f64).prop_map(|(mass, radius)| Disc::from_g_mm(mass, radius))
}

fn velocity() -> impl Strategy<Value = DVec2> {
    (0.0..10.0_f64, -180.0..180.0_f64)
        .prop_map(|(speed, deg)| speed * DVec2::from_angle(deg.to_radians()))
}

fn restitution() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), Just(1.0), 0.0..=1.0]
}

prop_compose! {
    fn both_moving()(
        striker in disc(),
        target in disc(),
        u1 in velocity(),
        u2 in velocity(),
        alpha_deg in -89.9..=89.9_f64,
        restitution in restitution(),
        bond in prop_oneof![Just(Bond::Slip), Just(Bond::Stick)],
    ) -> Collision {
        let collision = Collision { restitution, bond, u2, ..Collision::at_offset(striker, target, u1, 0.0) };
        collision.with_alpha(alpha_deg.to_radians())
    }
}

prop_compose! {
    fn target_at_rest()(
        collision in both_moving(),
        speed in 0.1..10.0_f64,
        deg in -180.0..180.0_f64,
    ) -> Collision {
        Collision {
            u1: speed * DVec2::from_angle(deg.to_radians()),
            u2: DVec2::ZERO,
            bond: Bond::Slip,
            ..collision
        }
    }
}

fn momentum(c: &Collision, v1: DVec2, v2: DVec2) -> DVec2 {
    c.striker.mass * v1 + c.target.mass * v2
}

fn energy(c: &Collision, v1: DVec2, v2: DVec2) -> f64 {
    (c.striker.mass * v1.length_squared() + c.target.mass * v2.length_squared()) / 2.0
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() })]

    /// The tolerance is relative to the sum of the magnitudes of the two momenta, because the total
    /// momentum may be zero.
    #[test]
    fn momentum_is_conserved(c in both_moving()) {
        let after = c.outcome();
        let scale = c.striker.mass * c.u1.length() + c.target.mass * c.u2.length();
        let change = momentum(&c, after.v1, after.v2) - momentum(&c, c.u1, c.u2);
        prop_assert!(change.length() <= 1e-12 * scale);
    }

    /// The energy is recomputed from the velocities, the loss and the rotation.
    #[test]
    fn energy_balances(c in both_moving()) {
        let after = c.outcome();
        let before = energy(&c, c.u1, c.u2);
        let left = energy(&c, after.v1, after.v2) + after.energy_rotation + after.energy_lost;
        prop_assert!((left - before).abs() <= 1e-12 * before);
        prop_assert!((after.energy_before - before).abs() <= 1e-12 * before);
        prop_assert!((after.energy_after + after.energy_lost - before).abs() <= 1e-12 * before);
        prop_assert!(after.energy_lost >= 0.0);
    }

    /// A stricter test: in this frame the centre of mass is at rest, so the energy of its motion
    /// cannot hide an error in a collision with a small relative velocity.
    #[test]
    fn energy_balances_in_the_centre_of_mass_frame(c in both_moving()) {
        let cm = Frame::CentreOfMass.view(&c);
        let after = cm.outcome();
        let before = energy(&cm, cm.u1, cm.u2);
        let left = energy(&cm, after.v1, after.v2) + after.energy_rotation + after.energy_lost;
        prop_assert!((left - before).abs() <= 1e-12 * before);
    }

    /// Newton's law of restitution holds along n, and nothing changes perpendicular to n.
    #[test]
    fn only_the_components_along_the_line_of_impact_change(c in both_moving()) {
        let c = Collision { bond: Bond::Slip, ..c };
        let after = c.outcome();
        let (n, t) = (after.normal.unwrap(), after.tangent.unwrap());
        let w = c.relative_velocity();
        let scale = 1e-12 * (c.u1.length() + c.u2.length() + w.length());
        let parting = (after.v2 - after.v1).dot(n);
        prop_assert!((parting - c.restitution * w.dot(n)).abs() <= scale);
        prop_assert!((after.v1 - c.u1).dot(t).abs() <= scale);
        prop_assert!((after.v2 - c.u2).dot(t).abs() <= scale);
        prop_assert!(w.dot(n) > 0.0, "the line of impact points at the target");
    }

    #[test]
    fn the_angle_is_recovered_from_the_offset(c in both_moving(), alpha_deg in -89.9..=89.9_f64) {
        let found = c.with_alpha(alpha_deg.to_radians()).alpha().unwrap();
        prop_assert!((found.to_degrees() - alpha_deg).abs() <= 1e-9);
    }

    /// Angles agree to a billionth of a degree, speeds to about 10⁻¹² of the greatest possible
    /// speed.
    #[test]
    fn closed_forms_agree_with_the_vectors(c in target_at_rest(), alpha_deg in -89.9..=89.9_f64) {
        let alpha = alpha_deg.to_radians();
        let after = c.with_alpha(alpha).outcome();
        let closed = RestingTarget::from(&c);
        let speed = c.u1.length();
        prop_assert!((after.v1.length() - speed * closed.striker_speed(alpha)).abs() <= 1e-12 * speed);
        prop_assert!((after.v2.length() - speed * closed.target_speed(alpha)).abs() <= 1e-12 * speed * (1.0 + closed.target_speed(0.0)));
        let same = |a: Option<f64>, b: Option<f64>| {
            let off = (a.unwrap() - b.unwrap()).to_degrees().abs();
            off.min(360.0 - off) <= 1e-9
        };
        // For a striker that is slower than this, the direction depends on the last bits of α.
        if closed.striker_speed(alpha) > 1e-4 {
            prop_assert!(same(after.theta1, closed.theta1(alpha)));
            prop_assert!(same(after.separation, closed.separation(alpha)));
        }
        prop_assert!(same(after.theta2, closed.theta2(alpha)));
        let shares = closed.energy_shares(alpha);
        prop_assert!((after.energy_lost - shares.lost * after.energy_before).abs() <= 1e-12 * after.energy_before);
    }

    /// 90° exactly when m₁ = e m₂, more for a lighter and less for a heavier striker.
    #[test]
    fn the_separation_is_90_degrees_exactly_at_m1_equal_to_e_m2(
        c in target_at_rest(),
        alpha_deg in 1.0..=89.0_f64,
        factor in prop_oneof![0.01..0.99_f64, 1.01..100.0_f64],
    ) {
        let e = c.restitution.max(0.01);
        let separation_deg = |factor: f64| {
            let striker = Disc { mass: e * factor * c.target.mass, ..c.striker };
            let shot = Collision { striker, restitution: e, ..c }.with_alpha(alpha_deg.to_radians());
            units::deg_from_rad(shot.outcome().separation.unwrap())
        };
        prop_assert!((separation_deg(1.0) - 90.0).abs() <= 1e-9);
        let other = separation_deg(factor);
        // Even at e = 0.01 and 89°, a mass that differs by 1 % changes the separation by more than
        // 10⁻⁵ degrees.
        prop_assert!((other - 90.0).abs() > 1e-5, "{other}");
        prop_assert_eq!(other > 90.0, factor < 1.0);
    }

    #[test]
    fn the_collision_is_the_same_in_any_frame(c in both_moving()) {
        let truth = c.outcome();
        for frame in [Frame::Laboratory, Frame::CentreOfMass, Frame::Target] {
            let seen = frame.view(&c).outcome();
            let shift = frame.velocity(&c);
            let scale = 1e-12 * (c.u1.length() + c.u2.length() + truth.v1.length() + truth.v2.length());
            prop_assert!((seen.v1 + shift - truth.v1).length() <= scale);
            prop_assert!((seen.v2 + shift - truth.v2).length() <= scale);
        }
    }
}
