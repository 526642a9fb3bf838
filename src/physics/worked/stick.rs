//! The working for discs that stick: one velocity, and a turn about the middle.

use super::number::{beside, number, vector};
use super::{Step, grams, mm};
use crate::physics::capture::moment_of_inertia;
use crate::physics::impact::reduced_mass;
use crate::physics::units::g_from_kg;
use crate::physics::{Collision, Outcome};

pub(super) fn steps(c: &Collision, after: &Outcome) -> Vec<Step> {
    vec![shared_velocity(c, after), turning(c, after)]
}

fn shared_velocity(c: &Collision, after: &Outcome) -> Step {
    let scale = c.u1.length() + c.u2.length();
    let (m1, m2) = (grams(c.striker.mass), grams(c.target.mass));
    let total = number(g_from_kg(c.striker.mass + c.target.mass));
    Step {
        title: "One velocity for both",
        why: "Stuck together the two are one body. Its centre of mass takes all the momentum \
              along; there is nothing to split."
            .to_owned(),
        lines: vec![
            "v = (m₁u₁ + m₂u₂) / (m₁ + m₂)".to_owned(),
            format!(
                "  = [{m1} × {} + {m2} × {}] / {total} = {} m/s",
                vector(c.u1, 0.0),
                vector(c.u2, 0.0),
                vector(after.v1, scale)
            ),
        ],
    }
}

fn turning(c: &Collision, after: &Outcome) -> Step {
    let (m1, m2) = (c.striker.mass, c.target.mass);
    let mu = reduced_mass(m1, m2);
    let speed = c.relative_velocity().length();
    // g mm² are 10⁻⁹ kg m².
    let inertia = moment_of_inertia(c.striker, c.target) * 1e9;
    let sense = match after.spin {
        spin if spin > 0.0 => ", clockwise",
        spin if spin < 0.0 => ", anticlockwise",
        _ => ": a hit through the middle turns nothing",
    };
    Step {
        title: "And a turn",
        why: "The striker comes in beside the common centre of mass, so there is angular \
              momentum too, μ b w with μ = m₁m₂ / (m₁ + m₂) and w the relative speed. It is \
              kept, and the pair turns with it. I counts each disc about its own centre and \
              both centres about the common one."
            .to_owned(),
        lines: vec![
            format!(
                "μ = {} g,  b = {} mm,  w = {} m/s",
                grams(mu),
                mm(c.offset),
                number(speed)
            ),
            format!(
                "I = ½ m₁r₁² + ½ m₂r₂² + μ (r₁ + r₂)² = {} g mm²",
                number(inertia)
            ),
            format!("ω = μ b w / I = {} rad/s{sense}", beside(after.spin, 1e-9)),
        ],
    }
}
