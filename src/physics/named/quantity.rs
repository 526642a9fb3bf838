//! Everything about a collision that a text can ask for by name.

use glam::DVec2;

use super::super::frames::cm_scattering_angle;
use super::super::resting_target::{LargestDeflection, mass_ratio_from_angles};
use super::super::units::{deg_from_rad, g_from_kg, mm_from_m};
use super::super::{Bond, Collision, CollisionOutcome, Frame, RestingTarget};
use crate::numbers::{fixed, true_minus};

/// A number that follows from a collision.
#[derive(Debug, Clone, Copy)]
pub struct Quantity {
    /// Its name in a file.
    pub name: &'static str,
    /// Its sign in a formula.
    pub symbol: &'static str,
    /// Its unit on the screen, or nothing.
    pub unit: &'static str,
    /// Decimals it is shown with where nobody says how many.
    pub decimals: usize,
    of: fn(&Collision, &CollisionOutcome) -> Option<f64>,
}

/// The same by name.
impl PartialEq for Quantity {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

const fn quantity(
    name: &'static str,
    symbol: &'static str,
    unit: &'static str,
    decimals: usize,
    of: fn(&Collision, &CollisionOutcome) -> Option<f64>,
) -> Quantity {
    Quantity {
        name,
        symbol,
        unit,
        decimals,
        of,
    }
}

/// Milli, as in millijoule.
const MILLI: f64 = 1e3;

impl Quantity {
    /// All of them, in the order of the table in `docs/lessons.md`.
    pub const ALL: [Self; 55] = [
        quantity("u", "u", "m/s", 2, |c, _| Some(c.u1.length())),
        quantity("v1", "v₁", "m/s", 2, |_, o| Some(o.v1.length())),
        quantity("v2", "v₂", "m/s", 2, |_, o| Some(o.v2.length())),
        quantity("v1_share", "v₁/u", "", 3, |c, o| {
            share(o.v1.length(), c.u1.length())
        }),
        quantity("v2_share", "v₂/u", "", 3, |c, o| {
            share(o.v2.length(), c.u1.length())
        }),
        quantity("u1n", "u₁ₙ", "m/s", 2, |c, o| Some(c.u1.dot(o.normal?))),
        quantity("u1t", "u₁ₜ", "m/s", 2, |c, o| {
            Some(c.u1.dot(o.tangent?))
        }),
        quantity("u2n", "u₂ₙ", "m/s", 2, |c, o| Some(c.u2.dot(o.normal?))),
        quantity("u2t", "u₂ₜ", "m/s", 2, |c, o| {
            Some(c.u2.dot(o.tangent?))
        }),
        quantity("v1n", "v₁ₙ", "m/s", 2, |_, o| Some(o.v1.dot(o.normal?))),
        quantity("v1t", "v₁ₜ", "m/s", 2, |_, o| {
            Some(o.v1.dot(o.tangent?))
        }),
        quantity("v2n", "v₂ₙ", "m/s", 2, |_, o| Some(o.v2.dot(o.normal?))),
        quantity("v2t", "v₂ₜ", "m/s", 2, |_, o| {
            Some(o.v2.dot(o.tangent?))
        }),
        quantity("v1x", "v₁ₓ", "m/s", 2, |_, o| Some(o.v1.x)),
        quantity("v1y", "v₁ᵧ", "m/s", 2, |_, o| Some(o.v1.y)),
        quantity("v2x", "v₂ₓ", "m/s", 2, |_, o| Some(o.v2.x)),
        quantity("v2y", "v₂ᵧ", "m/s", 2, |_, o| Some(o.v2.y)),
        quantity("alpha_deg", "α", "°", 1, |c, _| {
            c.alpha().map(deg_from_rad)
        }),
        quantity("theta1_deg", "θ₁", "°", 1, |_, o| {
            o.theta1.map(deg_from_rad)
        }),
        quantity("theta2_deg", "θ₂", "°", 1, |_, o| {
            o.theta2.map(deg_from_rad)
        }),
        quantity("separation_deg", "separation", "°", 1, |_, o| {
            o.separation.map(deg_from_rad)
        }),
        quantity("offset_mm", "b", "mm", 1, |c, _| Some(mm_from_m(c.offset))),
        quantity("reach_mm", "r₁ + r₂", "mm", 1, |c, _| {
            Some(mm_from_m(c.contact_distance()))
        }),
        quantity("offset_share", "b/(r₁ + r₂)", "", 3, |c, _| {
            Some(c.offset / c.contact_distance())
        }),
        quantity("mass_ratio", "m₁/m₂", "", 2, |c, _| {
            Some(c.striker.mass / c.target.mass)
        }),
        quantity("weighed_ratio", "m₁/m₂", "", 2, |c, o| {
            mass_ratio_from_angles(o.theta1?, o.theta2?, c.restitution)
        }),
        quantity("k", "k", "", 3, |c, _| Some(RestingTarget::from(c).k())),
        quantity(
            "largest_deflection_deg",
            "largest θ₁",
            "°",
            1,
            |c, _| largest_deflection(c),
        ),
        quantity("half_energy_deg", "α", "°", 1, |c, _| half_energy(c)),
        quantity("energy_before_mj", "E before", "mJ", 1, |_, o| {
            Some(MILLI * o.energy_before)
        }),
        quantity("energy_after_mj", "E after", "mJ", 1, |_, o| {
            Some(MILLI * o.energy_after)
        }),
        quantity("energy_lost_mj", "E lost", "mJ", 1, |_, o| {
            Some(MILLI * o.energy_lost)
        }),
        quantity("energy1_share", "E₁/E", "", 3, |c, o| {
            share(
                0.5 * c.striker.mass * o.v1.length_squared(),
                o.energy_before,
            )
        }),
        quantity("energy2_share", "E₂/E", "", 3, |c, o| {
            share(0.5 * c.target.mass * o.v2.length_squared(), o.energy_before)
        }),
        quantity("lost_share", "share lost", "", 3, |_, o| {
            share(o.energy_lost, o.energy_before)
        }),
        quantity("px", "pₓ", "g m/s", 1, |c, _| {
            Some(momentum(c, c.u1, c.u2).x)
        }),
        quantity("py", "pᵧ", "g m/s", 1, |c, _| {
            Some(momentum(c, c.u1, c.u2).y)
        }),
        quantity("px_after", "pₓ after", "g m/s", 1, |c, o| {
            Some(momentum(c, o.v1, o.v2).x)
        }),
        quantity("py_after", "pᵧ after", "g m/s", 1, |c, o| {
            Some(momentum(c, o.v1, o.v2).y)
        }),
        quantity("p1x", "p₁ₓ", "g m/s", 1, |c, o| {
            Some(momentum(c, o.v1, DVec2::ZERO).x)
        }),
        quantity("p1y", "p₁ᵧ", "g m/s", 1, |c, o| {
            Some(momentum(c, o.v1, DVec2::ZERO).y)
        }),
        quantity("p2x", "p₂ₓ", "g m/s", 1, |c, o| {
            Some(momentum(c, DVec2::ZERO, o.v2).x)
        }),
        quantity("p2y", "p₂ᵧ", "g m/s", 1, |c, o| {
            Some(momentum(c, DVec2::ZERO, o.v2).y)
        }),
        quantity("p1", "p₁", "g m/s", 1, |c, o| {
            Some(momentum(c, o.v1, DVec2::ZERO).length())
        }),
        quantity("p2", "p₂", "g m/s", 1, |c, o| {
            Some(momentum(c, DVec2::ZERO, o.v2).length())
        }),
        quantity("impulse", "J", "g m/s", 1, |_, o| {
            Some(g_from_kg(o.impulse))
        }),
        quantity("cm_speed", "V", "m/s", 2, |c, _| {
            Some(c.centre_of_mass_velocity().length())
        }),
        quantity("cm_angle_deg", "Θ", "°", 1, |c, _| {
            let smooth = c.bond == Bond::Slip;
            let turned = cm_scattering_angle(c.alpha()?, c.restitution);
            turned.filter(|_| smooth).map(deg_from_rad)
        }),
        quantity("u1_cm", "u₁*", "m/s", 2, |c, _| {
            Some((c.u1 - drift(c)).length())
        }),
        quantity("u2_cm", "u₂*", "m/s", 2, |c, _| {
            Some((c.u2 - drift(c)).length())
        }),
        quantity("v1_cm", "w₁", "m/s", 2, |c, o| {
            Some((o.v1 - drift(c)).length())
        }),
        quantity("v2_cm", "w₂", "m/s", 2, |c, o| {
            Some((o.v2 - drift(c)).length())
        }),
        quantity("cm_separation_deg", "separation", "°", 1, |c, _| {
            seen_from(Frame::CentreOfMass, c)
        }),
        quantity("target_separation_deg", "separation", "°", 1, |c, _| {
            seen_from(Frame::Target, c)
        }),
        quantity("turns", "turns", "1/s", 1, |_, o| {
            Some(o.spin / std::f64::consts::TAU)
        }),
    ];

    /// The quantity of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|quantity| quantity.name == name)
    }

    /// Its value in its unit; `None` where it is undefined, as the direction of a
    /// disc at rest is.
    pub fn of(&self, collision: &Collision) -> Option<f64> {
        let value = (self.of)(collision, &collision.outcome())?;
        value.is_finite().then_some(value + 0.0)
    }

    /// Its value as the screen shows it, without its unit; a word where it is
    /// undefined.
    pub fn shown(&self, collision: &Collision) -> String {
        self.of(collision).map_or_else(
            || "undefined".into(),
            |value| true_minus(&fixed(value, self.decimals)),
        )
    }
}

fn share(part: f64, whole: f64) -> Option<f64> {
    (whole > 0.0).then(|| part / whole)
}

/// Momentum in g m/s.
fn momentum(c: &Collision, v1: DVec2, v2: DVec2) -> DVec2 {
    g_from_kg(c.striker.mass) * v1 + g_from_kg(c.target.mass) * v2
}

fn drift(c: &Collision) -> DVec2 {
    c.centre_of_mass_velocity()
}

fn seen_from(frame: Frame, c: &Collision) -> Option<f64> {
    frame.view(c).outcome().separation.map(deg_from_rad)
}

fn largest_deflection(c: &Collision) -> Option<f64> {
    match RestingTarget::from(c).largest_deflection() {
        LargestDeflection::Turned { theta1, .. } => Some(deg_from_rad(theta1)),
        LargestDeflection::NearlyRight => Some(90.0),
        LargestDeflection::Reversed => Some(180.0),
    }
}

/// The impact angle that passes on half of the energy.
fn half_energy(c: &Collision) -> Option<f64> {
    let is_smooth = c.bond == Bond::Slip && c.u2 == DVec2::ZERO;
    let alpha = RestingTarget::from(c).alpha_for_energy_passed(0.5)?;
    is_smooth.then(|| deg_from_rad(alpha))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::CollisionSpec;

    fn of(name: &str, fields: &str) -> Option<f64> {
        let mut shot = CollisionSpec::default();
        for field in fields.split_whitespace() {
            let (name, value) = field.split_once('=').unwrap();
            shot.set(name, value).unwrap();
        }
        Quantity::named(name).unwrap().of(&shot.collision())
    }

    /// The worked figures of `physics.md`, and the closed forms beside them.
    #[test]
    fn the_figures_everybody_knows() {
        let marbles = "m1_g=20 m2_g=40 speed=3 alpha_deg=45";
        let tournament = "m1_g=15 m2_g=5.5 r1_mm=20.65 r2_mm=15.9";
        for (name, fields, expected) in [
            ("v1", "", 2.0),
            ("v2", "", 12.0_f64.sqrt()),
            ("theta1_deg", "", 60.0),
            ("theta2_deg", "", 30.0),
            ("separation_deg", "", 90.0),
            ("u1n", "", 12.0_f64.sqrt()),
            ("u1t", "", 2.0),
            ("energy1_share", "alpha_deg=45", 0.5),
            ("energy2_share", "alpha_deg=45", 0.5),
            ("half_energy_deg", "", 45.0),
            // Head-on 8/9 goes over, and cos² 41.4° = 9/16.
            ("half_energy_deg", marbles, 0.75_f64.acos().to_degrees()),
            ("v1x", marbles, 1.0),
            ("v1y", marbles, 2.0),
            ("v2y", marbles, -1.0),
            ("px", marbles, 60.0),
            ("px_after", marbles, 60.0),
            ("p1", marbles, 20.0 * 5.0_f64.sqrt()),
            ("p2", marbles, 40.0 * 2.0_f64.sqrt()),
            ("py_after", marbles, 0.0),
            (
                "separation_deg",
                marbles,
                45.0 + 2.0_f64.atan().to_degrees(),
            ),
            ("weighed_ratio", marbles, 0.5),
            ("separation_deg", tournament, 51.247_462),
            (
                "largest_deflection_deg",
                tournament,
                (5.5_f64 / 15.0).asin().to_degrees(),
            ),
            ("cm_angle_deg", "", 120.0),
            ("cm_separation_deg", "", 180.0),
            ("target_separation_deg", "target_speed=2", 90.0),
            ("offset_mm", "", 15.0),
            ("offset_share", "", 0.5),
            ("energy_before_mj", "", 120.0),
            ("cm_speed", marbles, 1.0),
        ] {
            let value = of(name, fields).unwrap();
            assert!((value - expected).abs() < 1e-6, "{name} {fields}: {value}");
        }
        assert_eq!(of("theta1_deg", "alpha_deg=0"), None);
        assert_eq!(of("v1n", "offset_mm=31"), None);
        // Never: 4 · 1 · 99 / 100² is less than a half.
        assert_eq!(of("half_energy_deg", "m1_g=1 m2_g=99"), None);
    }

    #[test]
    fn no_name_stands_twice_and_noise_has_no_sign() {
        for (i, one) in Quantity::ALL.iter().enumerate() {
            assert!(
                Quantity::ALL[i + 1..].iter().all(|other| other != one),
                "{}",
                one.name
            );
        }
        let collision = CollisionSpec::default().collision();
        let shown = |name| Quantity::named(name).unwrap().shown(&collision);
        assert_eq!(shown("v1n"), "0.00");
        assert_eq!(shown("v2y"), "−1.73");
    }

    #[test]
    fn the_manual_knows_every_name() {
        let manual = include_str!("../../../docs/lessons.md");
        for quantity in Quantity::ALL {
            assert!(
                manual.contains(&format!("`{}`", quantity.name)),
                "{}",
                quantity.name
            );
        }
    }
}
