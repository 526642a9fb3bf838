//! The working along t if the rims have friction: the slip, the impulse of friction, and the
//! changes that the impulse causes.

use super::number::{NOISE, beside, factors, number};
use super::{WorkedStep, speed_scale};
use crate::physics::impact::reduced_mass;
use crate::physics::units::g_from_kg;
use crate::physics::{Collision, CollisionOutcome};
use glam::DVec2;

/// The steps that replace "Along t: nothing changes".
pub(super) fn steps(c: &Collision, after: &CollisionOutcome, t: DVec2) -> [WorkedStep; 2] {
    [impulse(c, after, t), changes(c, after, t)]
}

/// The component of a velocity along t, without rounding noise.
fn part(c: &Collision, u: DVec2, t: DVec2) -> f64 {
    let part = u.dot(t);
    if part.abs() <= NOISE * speed_scale(c) {
        0.0
    } else {
        part
    }
}

fn impulse(c: &Collision, after: &CollisionOutcome, t: DVec2) -> WorkedStep {
    let [r1, r2] = c.discs().map(|disc| disc.radius);
    let [spin1, spin2] = c.rims.spins;
    let slip = c.slip().unwrap_or_default();
    let sum = |[u1, u2, w1, r1, w2, r2]: [f64; 6]| u1 - u2 + w1 * r1 + w2 * r2;
    let [u1t, u2t] = [c.u1, c.u2].map(|u| part(c, u, t));
    let scale = u1t.abs() + u2t.abs() + (spin1 * r1).abs() + (spin2 * r2).abs();
    let terms = factors([u1t, u2t, spin1, r1, spin2, r2], scale, sum);
    let [a, b, w1, r1, w2, r2] = &terms;
    let mut lines = vec![
        "slip  uₛ = u₁ₜ − u₂ₜ + ω₁r₁ + ω₂r₂".to_owned(),
        format!(
            "    = {a} − {b} + {w1} × {r1} + {w2} × {r2} = {} m/s",
            number(slip)
        ),
    ];
    let normal = g_from_kg(after.impulse);
    let mu = g_from_kg(reduced_mass(c.striker.mass, c.target.mass));
    let limit = c.rims.friction * normal;
    let product = |[a, b]: [f64; 2]| a * b;
    let [friction, along] = factors([c.rims.friction, normal], 0.0, product);
    let [reduced, size] = factors([mu, slip.abs()], 0.0, |[a, b]| a * b / 3.0);
    let needed = mu * slip.abs() / 3.0;
    lines.push(format!(
        "limit  μᵣ Jₙ = {friction} × {along} = {} g m/s",
        number(limit)
    ));
    lines.push(format!(
        "to stop the slip  μ |uₛ| / 3 = {reduced} × {size} / 3 = {} g m/s",
        number(needed)
    ));
    let verdict = match slip.abs() <= 0.0 {
        true => "there is no slip, so no friction acts",
        false if c.rub_stops() => "the limit is not reached: the rims stop slipping",
        false => "the limit is reached first: the rims still slip at the end",
    };
    let impulse = number(g_from_kg(after.friction_impulse));
    lines.push(format!("Jₜ = {impulse} g m/s: {verdict}"));
    WorkedStep {
        title: "Along t: friction between the rims",
        why: "The striker's rim slides along the target's at uₛ, and friction opposes that. Its \
              impulse Jₜ is at most μᵣ Jₙ. It changes both velocities and turns both discs, so an \
              impulse of μ |uₛ| / 3, with the reduced mass μ = m₁m₂ / (m₁ + m₂), is enough to stop \
              the slip of solid discs (I = ½ m r²)."
            .to_owned(),
        lines,
    }
}

fn changes(c: &Collision, after: &CollisionOutcome, t: DVec2) -> WorkedStep {
    let scale = speed_scale(c);
    let impulse = g_from_kg(after.friction_impulse);
    let mut lines = Vec::new();
    let bodies = [
        ('₁', '−', c.striker.mass, c.u1, after.v1),
        ('₂', '+', c.target.mass, c.u2, after.v2),
    ];
    for (sub, sign, mass, u, v) in bodies {
        let by = if sign == '−' { -1.0 } else { 1.0 };
        let [before, push, grams] = factors(
            [part(c, u, t), impulse, g_from_kg(mass)],
            scale,
            |[u, push, mass]| u + by * push / mass,
        );
        let now = beside(v.dot(t), scale);
        lines.push(format!(
            "v{sub}ₜ = u{sub}ₜ {sign} Jₜ / m{sub} = {before} {sign} {push} / {grams} = {now} m/s"
        ));
    }
    for (body, sub) in ['₁', '₂'].into_iter().enumerate() {
        let disc = c.discs()[body];
        let [spin, push, grams, radius] = factors(
            [
                c.rims.spins[body],
                impulse,
                g_from_kg(disc.mass),
                disc.radius,
            ],
            0.0,
            |[spin, push, mass, radius]| spin - 2.0 * push / (mass * radius),
        );
        let now = number(after.spins[body]);
        lines.push(format!("ω{sub}′ = ω{sub} − 2 Jₜ / (m{sub} r{sub})"));
        lines.push(format!(
            "    = {spin} − 2 × {push} / ({grams} × {radius}) = {now} rad/s"
        ));
    }
    WorkedStep {
        title: "What friction changes",
        why: "Jₜ acts on the target along t and on the striker against it. The two \
              impulses are opposite and act on opposite sides of the centres, so they turn both \
              discs in the same sense. Spins are positive anticlockwise, and radii are in m here."
            .to_owned(),
        lines,
    }
}

/// The lines about the rims in "What we know".
pub(super) fn knowns(c: &Collision) -> [String; 2] {
    let [spin1, spin2] = c.rims.spins.map(number);
    let friction = number(c.rims.friction);
    [
        format!("rims     friction μᵣ = {friction}"),
        format!("spins    ω₁ = {spin1} rad/s   ω₂ = {spin2} rad/s"),
    ]
}

/// The spins after the collision, in words.
pub(super) fn in_words(c: &Collision, after: &CollisionOutcome) -> String {
    let spin = |body: usize, name: &str| match after.spins[body] {
        0.0 => format!("the {name} does not spin"),
        spin => {
            let sense = if spin > 0.0 {
                "anticlockwise"
            } else {
                "clockwise"
            };
            format!("the {name} spins {sense} at {} rad/s", number(spin.abs()))
        }
    };
    let slips = match c.slip() {
        _ if c.rims.friction <= 0.0 => "The rims are smooth",
        Some(slip) if slip.abs() <= 0.0 => "The rims do not slip",
        _ => "Friction acts between the rims",
    };
    let (striker, target) = (spin(0, "striker"), spin(1, "target"));
    format!("{slips}: after the collision {striker}, and {target}.")
}
