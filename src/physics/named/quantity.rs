//! Everything about a collision that a text can refer to by name.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::DVec2;

use super::super::impact::{kinetic_energy, reduced_mass};
use super::super::resting_target::{LargestDeflection, mass_ratio_from_angles};
use super::super::units::{deg_from_rad, g_from_kg, mm_from_m};
use super::super::{Bond, Collision, CollisionOutcome, Disc, Frame, RestingTarget};
use crate::numbers::{fixed, true_minus};

/// A number that follows from a collision.
#[derive(Debug, Clone, Copy)]
pub struct Quantity {
    /// The quantity's name in a file.
    pub name: &'static str,
    /// The quantity's symbol in a formula.
    pub symbol: &'static str,
    /// The quantity's unit on the screen; may be empty.
    pub unit: &'static str,
    /// The usual number of decimals.
    pub decimals: usize,
    /// The factor from SI units.
    scale: f64,
    of: Formula,
}

/// The formula of a quantity; the result is in the quantity's unit if the factor of that unit is 1,
/// and in SI units otherwise.
type Formula = fn(&Collision, &CollisionOutcome) -> Option<f64>;

/// Quantities are equal if their names are equal.
impl PartialEq for Quantity {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

/// A unit as shown on the screen, the number of decimal places, and the factor that converts SI
/// units to it.
struct Unit(&'static str, usize, f64);

const SPEED: Unit = Unit("m/s", 2, 1.0);
const ANGLE: Unit = Unit("°", 1, deg_from_rad(1.0));
const LENGTH: Unit = Unit("mm", 1, mm_from_m(1.0));
const ENERGY: Unit = Unit("mJ", 1, 1e3);
/// Formulas give momentum in g m/s.
const MOMENTUM: Unit = Unit("g m/s", 1, 1.0);
/// Formulas give mass in grams.
const MASS: Unit = Unit("g", 1, 1.0);
const RATE: Unit = Unit("1/s", 1, 1.0);
const SPIN: Unit = Unit("rad/s", 1, 1.0);
const SHARE: Unit = Unit("", 3, 1.0);
const RATIO: Unit = Unit("", 2, 1.0);

impl Unit {
    const fn of(self, name: &'static str, symbol: &'static str, of: Formula) -> Quantity {
        let Self(unit, decimals, scale) = self;
        Quantity {
            name,
            symbol,
            unit,
            decimals,
            scale,
            of,
        }
    }
}

impl Quantity {
    /// All quantities, in the order of the table in `docs/lessons.md`.
    pub(crate) const ALL: [Self; 69] = [
        SPEED.of("u", "u", |c, _| Some(c.u1.length())),
        SPEED.of("v1", "v₁", |_, o| Some(o.v1.length())),
        SPEED.of("v2", "v₂", |_, o| Some(o.v2.length())),
        SHARE.of("v1_share", "v₁/u", |c, o| {
            Some(o.v1.length() / c.u1.length())
        }),
        SHARE.of("v2_share", "v₂/u", |c, o| {
            Some(o.v2.length() / c.u1.length())
        }),
        SPEED.of("u1n", "u₁ₙ", |c, o| Some(c.u1.dot(o.normal?))),
        SPEED.of("u1t", "u₁ₜ", |c, o| Some(c.u1.dot(o.tangent?))),
        SPEED.of("u2n", "u₂ₙ", |c, o| Some(c.u2.dot(o.normal?))),
        SPEED.of("u2t", "u₂ₜ", |c, o| Some(c.u2.dot(o.tangent?))),
        SPEED.of("v1n", "v₁ₙ", |_, o| Some(o.v1.dot(o.normal?))),
        SPEED.of("v1t", "v₁ₜ", |_, o| Some(o.v1.dot(o.tangent?))),
        SPEED.of("v2n", "v₂ₙ", |_, o| Some(o.v2.dot(o.normal?))),
        SPEED.of("v2t", "v₂ₜ", |_, o| Some(o.v2.dot(o.tangent?))),
        SPEED.of("v1x", "v₁ₓ", |_, o| Some(o.v1.x)),
        SPEED.of("v1y", "v₁ᵧ", |_, o| Some(o.v1.y)),
        SPEED.of("v2x", "v₂ₓ", |_, o| Some(o.v2.x)),
        SPEED.of("v2y", "v₂ᵧ", |_, o| Some(o.v2.y)),
        ANGLE.of("alpha_deg", "α", |c, _| c.alpha()),
        ANGLE.of("theta1_deg", "θ₁", |_, o| o.theta1),
        ANGLE.of("theta2_deg", "θ₂", |_, o| o.theta2),
        ANGLE.of("separation_deg", "separation", |_, o| o.separation),
        LENGTH.of("offset_mm", "b", |c, _| Some(c.offset)),
        LENGTH.of("reach_mm", "r₁ + r₂", |c, _| Some(c.contact_distance())),
        SHARE.of("offset_share", "b/(r₁ + r₂)", |c, _| {
            Some(c.offset / c.contact_distance())
        }),
        RATIO.of("mass_ratio", "m₁/m₂", |c, _| {
            Some(c.striker.mass / c.target.mass)
        }),
        RATIO.of("weighed_ratio", "m₁/m₂", |c, o| {
            mass_ratio_from_angles(o.theta1?, o.theta2?, c.restitution)
        }),
        SHARE.of("k", "k", |c, _| Some(RestingTarget::from(c).k())),
        ANGLE.of("largest_deflection_deg", "largest θ₁", |c, _| {
            Some(largest_deflection(c))
        }),
        ANGLE.of("half_energy_deg", "α", |c, _| half_energy(c)),
        ENERGY.of("energy_before_mj", "E before", |_, o| Some(o.energy_before)),
        ENERGY.of("energy_after_mj", "E after", |_, o| Some(o.energy_after)),
        ENERGY.of("energy_lost_mj", "E lost", |_, o| Some(o.energy_lost)),
        SHARE.of("energy1_share", "E₁/E", |c, o| {
            Some(kinetic_energy(c.striker.mass, o.v1) / o.energy_before)
        }),
        SHARE.of("energy2_share", "E₂/E", |c, o| {
            Some(kinetic_energy(c.target.mass, o.v2) / o.energy_before)
        }),
        SHARE.of("lost_share", "share lost", |_, o| {
            Some(o.energy_lost / o.energy_before)
        }),
        MOMENTUM.of("px", "pₓ", |c, _| Some(both(c, c.u1, c.u2).x)),
        MOMENTUM.of("py", "pᵧ", |c, _| Some(both(c, c.u1, c.u2).y)),
        MOMENTUM.of("px_after", "pₓ after", |c, o| Some(both(c, o.v1, o.v2).x)),
        MOMENTUM.of("py_after", "pᵧ after", |c, o| Some(both(c, o.v1, o.v2).y)),
        MOMENTUM.of("p1x", "p₁ₓ", |c, o| Some(momentum(c.striker, o.v1).x)),
        MOMENTUM.of("p1y", "p₁ᵧ", |c, o| Some(momentum(c.striker, o.v1).y)),
        MOMENTUM.of("p2x", "p₂ₓ", |c, o| Some(momentum(c.target, o.v2).x)),
        MOMENTUM.of("p2y", "p₂ᵧ", |c, o| Some(momentum(c.target, o.v2).y)),
        MOMENTUM.of("p1", "p₁", |c, o| {
            Some(momentum(c.striker, o.v1).length())
        }),
        MOMENTUM.of("p2", "p₂", |c, o| Some(momentum(c.target, o.v2).length())),
        MOMENTUM.of("impulse", "J", |_, o| Some(g_from_kg(o.impulse))),
        SPEED.of("relative_speed", "u₁ − u₂", |c, _| {
            Some(c.relative_velocity().length())
        }),
        MASS.of("reduced_mass_g", "μ", |c, _| {
            Some(g_from_kg(reduced_mass(c.striker.mass, c.target.mass)))
        }),
        ENERGY.of("cm_energy_mj", "½MV²", |c, _| Some(cm_energy(c))),
        ENERGY.of("relative_energy_mj", "½μ(u₁ − u₂)²", |c, o| {
            Some(o.energy_before - cm_energy(c))
        }),
        ENERGY.of("relative_after_mj", "½μ(v₁ − v₂)²", |c, o| {
            Some(o.energy_after - cm_energy(c))
        }),
        SHARE.of("relative_share", "share of the energy", |c, o| {
            Some(1.0 - cm_energy(c) / o.energy_before)
        }),
        SPEED.of("cm_speed", "V", |c, _| Some(drift(c).length())),
        ANGLE.of("cm_angle_deg", "Θ", |c, _| cm_angle(c)),
        SPEED.of("u1_cm", "u₁*", |c, _| Some((c.u1 - drift(c)).length())),
        SPEED.of("u2_cm", "u₂*", |c, _| Some((c.u2 - drift(c)).length())),
        SPEED.of("v1_cm", "w₁", |c, o| Some((o.v1 - drift(c)).length())),
        SPEED.of("v2_cm", "w₂", |c, o| Some((o.v2 - drift(c)).length())),
        ANGLE.of("cm_separation_deg", "separation", |c, _| {
            separation_from(Frame::CentreOfMass, c)
        }),
        ANGLE.of("target_separation_deg", "separation", |c, _| {
            separation_from(Frame::Target, c)
        }),
        RATE.of("turns", "turns", |_, o| Some(o.spin / TAU)),
        RATIO.of("rim_friction", "μᵣ", |c, _| Some(c.rims.friction)),
        SPEED.of("slip", "uₛ", |c, _| c.slip()),
        MOMENTUM.of("friction_impulse", "Jₜ", |_, o| {
            Some(g_from_kg(o.friction_impulse))
        }),
        ANGLE.of("throw_deg", "δ", |c, _| c.throw()),
        SPIN.of("spin1", "ω₁", |c, _| Some(c.rims.spins[0])),
        SPIN.of("spin2", "ω₂", |c, _| Some(c.rims.spins[1])),
        SPIN.of("spin1_after", "ω₁′", |_, o| Some(o.spins[0])),
        SPIN.of("spin2_after", "ω₂′", |_, o| Some(o.spins[1])),
    ];

    /// The quantity of this name.
    pub(crate) fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|quantity| quantity.name == name)
    }

    /// Whether the quantity is a fraction of a whole, from 0 to 1.
    pub(crate) fn is_part_of_whole(&self) -> bool {
        matches!(
            self.name,
            "energy1_share" | "energy2_share" | "lost_share" | "relative_share"
        )
    }

    /// The value in the quantity's unit; `None` if it is undefined, such as the direction of a disc
    /// at rest.
    pub(crate) fn of(&self, collision: &Collision) -> Option<f64> {
        let value = (self.of)(collision, &collision.outcome())? * self.scale;
        value.is_finite().then_some(value + 0.0)
    }

    /// The value as the screen shows it, without its unit; a word if the value is undefined.
    pub(crate) fn shown(&self, collision: &Collision) -> String {
        self.of(collision).map_or_else(
            || "undefined".into(),
            |value| true_minus(&fixed(value, self.decimals)),
        )
    }
}

/// Momentum in g m/s.
fn momentum(disc: Disc, velocity: DVec2) -> DVec2 {
    g_from_kg(disc.mass) * velocity
}

/// Momentum of both discs in g m/s.
fn both(c: &Collision, v1: DVec2, v2: DVec2) -> DVec2 {
    momentum(c.striker, v1) + momentum(c.target, v2)
}

fn drift(c: &Collision) -> DVec2 {
    c.centre_of_mass_velocity()
}

/// ½MV² in joules: the energy that no collision can lose.
fn cm_energy(c: &Collision) -> f64 {
    kinetic_energy(c.striker.mass + c.target.mass, drift(c))
}

fn cm_angle(c: &Collision) -> Option<f64> {
    c.cm_deflection().filter(|_| c.bond == Bond::Slip)
}

fn separation_from(frame: Frame, c: &Collision) -> Option<f64> {
    frame.view(c).outcome().separation
}

fn largest_deflection(c: &Collision) -> f64 {
    match RestingTarget::from(c).largest_deflection() {
        LargestDeflection::Turned { theta1, .. } => theta1,
        LargestDeflection::NearlyRight => FRAC_PI_2,
        LargestDeflection::Reversed => PI,
    }
}

/// The impact angle at which half of the energy is transferred.
fn half_energy(c: &Collision) -> Option<f64> {
    let is_smooth = c.bond == Bond::Slip && c.u2 == DVec2::ZERO;
    let alpha = RestingTarget::from(c).alpha_for_energy_passed(0.5)?;
    is_smooth.then_some(alpha)
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

    /// Worked examples with known values, and their closed forms.
    #[test]
    fn well_known_values_are_reproduced() {
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
            // Head-on, 8/9 of the energy is transferred, and cos² 41.4° = 9/16.
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
            ("slip", "", 2.0),
            ("throw_deg", "", 0.0),
            (
                "throw_deg",
                "rim_friction=0.05",
                0.05_f64.atan().to_degrees(),
            ),
            // The slip stops: tan δ = tan 30° / 6.
            (
                "throw_deg",
                "rim_friction=1",
                (0.75_f64.sqrt() / 9.0).atan().to_degrees(),
            ),
            ("friction_impulse", "rim_friction=1", 5.0),
            ("spin2_after", "rim_friction=1", -400.0 / 9.0),
            (
                "spin1_after",
                "rim_friction=1 spin1=5",
                5.0 - 400.0 / 9.0 - 5.0 / 3.0,
            ),
            // Without friction, Θ in the centre-of-mass frame is 180° − 2 · 30°.
            ("cm_angle_deg", "rim_friction=0", 120.0),
            ("relative_speed", "target_speed=3 target_deg=90", 5.0),
            ("reduced_mass_g", marbles, 40.0 / 3.0),
            // 90 mJ in all: 30 mJ = ½ · 60 g · (1 m/s)², and 60 mJ = ½ · 40/3 g · (3 m/s)².
            ("cm_energy_mj", marbles, 30.0),
            ("relative_energy_mj", marbles, 60.0),
            ("relative_share", marbles, 2.0 / 3.0),
            (
                "relative_after_mj",
                "m1_g=20 m2_g=40 speed=3 alpha_deg=0 restitution=0.5",
                15.0,
            ),
        ] {
            let value = of(name, fields).unwrap();
            assert!((value - expected).abs() < 1e-6, "{name} {fields}: {value}");
        }
        assert_eq!(of("theta1_deg", "alpha_deg=0"), None);
        assert_eq!(of("v1n", "offset_mm=31"), None);
        // No angle: 4 · 1 · 99 / 100² is less than one half.
        assert_eq!(of("half_energy_deg", "m1_g=1 m2_g=99"), None);
    }

    #[test]
    fn names_are_unique_and_zero_has_no_sign() {
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
    fn the_manual_lists_every_quantity() {
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
