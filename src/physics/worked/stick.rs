//! The working for discs that stick: the velocity of their centre of mass, and a
//! turn about it.

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
        why: "Stuck together the two are one body. Its centre of mass takes all the momentum \
              along; there is nothing to split."
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
    // g mm² are 10⁻⁹ kg m².
    let inertia = number(moment_of_inertia(c.striker, c.target) * 1e9);
    let sense = match after.spin {
        spin if spin > 0.0 => ", clockwise",
        spin if spin < 0.0 => ", anticlockwise",
        _ => ": a hit through the middle turns nothing",
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
        title: "And a turn",
        why: "The striker comes in beside the common centre of mass, so there is angular \
              momentum too, μ b w with μ = m₁m₂ / (m₁ + m₂) and w the relative speed. It is \
              kept, and the pair turns with it. I counts each disc about its own centre and \
              both centres about the common one."
            .to_owned(),
        lines,
    }
}

/// Where the pair goes, for the two stay together.
fn direction(c: &Collision, after: &CollisionOutcome) -> WorkedStep {
    WorkedStep {
        title: "Read off the direction",
        why: "It is that of the centre of mass, measured from the striker's old direction u₁. \
              The two stay together, so there is no angle between them."
            .to_owned(),
        lines: vec![angle_line("θ", after.theta1, c.u1, after.v1)],
    }
}
