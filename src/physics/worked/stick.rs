//! The working for discs that stick: the velocity of their centre of mass, and the rotation about
//! it.

use super::number::{beside, number, vector};
use super::{WorkedStep, angle_line, grams, mm, speed_scale};
use crate::physics::capture::moment_of_inertia;
use crate::physics::impact::reduced_mass;
use crate::physics::units::g_from_kg;
use crate::physics::{Collision, CollisionOutcome};

pub(super) fn steps(c: &Collision, after: &CollisionOutcome) -> Vec<WorkedStep> {
    vec![
        centre_of_mass(c, after),
        turning(c, after),
        direction(c, after),
    ]
}

fn centre_of_mass(c: &Collision, after: &CollisionOutcome) -> WorkedStep {
    let (m1, m2) = (grams(c.striker.mass), grams(c.target.mass));
    let total = number(g_from_kg(c.striker.mass + c.target.mass));
    let (u1, u2) = (vector(c.u1, 0.0), vector(c.u2, 0.0));
    let shared = vector(after.v1, speed_scale(c));
    WorkedStep {
        title: "The centre of mass",
        why: "The discs move on together as one body. All of the momentum belongs to its centre \
              of mass, so no components along n and t are needed."
            .to_owned(),
        lines: vec![
            "V = (m₁u₁ + m₂u₂) / (m₁ + m₂)".to_owned(),
            format!("  = [{m1} × {u1} + {m2} × {u2}] / {total} = {shared} m/s"),
        ],
    }
}

fn turning(c: &Collision, after: &CollisionOutcome) -> WorkedStep {
    let mu = grams(reduced_mass(c.striker.mass, c.target.mass));
    let b = mm(c.offset);
    let w = number(c.relative_velocity().length());
    // 1 g mm² is 10⁻⁹ kg m².
    let inertia = number(moment_of_inertia(c.striker, c.target) * 1e9);
    let sense = match after.spin {
        spin if spin > 0.0 => ", clockwise",
        spin if spin < 0.0 => ", anticlockwise",
        _ => ": a head-on collision causes no rotation",
    };
    let omega = beside(after.spin, 1e-9);
    let mut lines = vec![
        format!("μ = {mu} g,  b = {b} mm,  w = {w} m/s"),
        format!("I = ½ m₁r₁² + ½ m₂r₂² + μ (r₁ + r₂)² = {inertia} g mm²"),
        format!("ω = μ b w / I = {omega} rad/s{sense}"),
    ];
    if after.energy_rotation > 0.0 {
        lines
            .push("right after the contact, with r from the centre of mass to each centre:".into());
        for (name, v) in ["striker  v₁", "target   v₂"].iter().zip(c.centres_after()) {
            let (speed, v) = (number(v.length()), vector(v, speed_scale(c)));
            lines.push(format!("{name} = V + ω × r = {v} m/s, speed {speed} m/s"));
        }
    }
    WorkedStep {
        title: "Rotation",
        why: "The discs approach their centre of mass on opposite sides, so they have angular \
              momentum about it: μ b w, with the reduced mass μ = m₁m₂ / (m₁ + m₂) and the \
              relative speed w. It is conserved, and the pair rotates. I includes each disc about \
              its own centre and both centres about the centre of mass."
            .to_owned(),
        lines,
    }
}

/// The direction of the pair, which moves on as one body.
fn direction(c: &Collision, after: &CollisionOutcome) -> WorkedStep {
    WorkedStep {
        title: "Read off the direction",
        why: "It is the direction of the centre of mass, measured from the striker's original \
              direction u₁. The discs move on together, so there is no angle between their paths."
            .to_owned(),
        lines: vec![angle_line("θ", after.theta1, c.u1, after.v1)],
    }
}
