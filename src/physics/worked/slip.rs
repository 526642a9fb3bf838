//! The working for discs that slip: resolve along n and t, collide along n, add the components.

use super::number::{beside, factor, number, vector};
use super::{WorkedStep, directions, grams, rough, speed_scale};
use crate::physics::units::g_from_kg;
use crate::physics::{Collision, CollisionOutcome};
use glam::DVec2;

pub(super) fn steps(c: &Collision, after: &CollisionOutcome) -> Vec<WorkedStep> {
    let (Some(n), Some(t)) = (after.normal, after.tangent) else {
        return Vec::new();
    };
    let mut steps = vec![split(c, n, t), along(c, after, n)];
    if c.rims.friction > 0.0 {
        steps.extend(rough::steps(c, after, t));
    } else {
        steps.push(across(c, t));
    }
    steps.extend([together(c, after, n, t), directions(c, after)]);
    steps
}

fn split(c: &Collision, n: DVec2, t: DVec2) -> WorkedStep {
    let scale = speed_scale(c);
    let part = |name: &str, sub: char, u: DVec2, axis: char, unit: DVec2| {
        let along = beside(u.dot(unit), scale);
        format!("{name} = u{sub} · {axis} = {along} m/s")
    };
    let relative = c.relative_velocity();
    let along_x = relative.x > 0.0 && relative.y.abs() <= 1e-9 * relative.x;
    let (n_form, t_form, how) = if along_x {
        let how = "The motion is along x, so n is that direction turned clockwise by α.";
        (" = (cos α, −sin α)", " = (sin α, cos α)", how)
    } else {
        let how = "To find n, turn the direction of u₁ − u₂ clockwise by α.";
        ("", "", how)
    };
    let forces = if c.rims.friction > 0.0 {
        "The discs push each other apart along the line through their centres, and friction acts \
         at right angles to it. So there are two directions: along n the discs collide, and along \
         the tangent t the rims rub."
    } else {
        "Smooth discs exert forces on each other only along the line through their centres. So \
         there are two independent directions: along n the discs collide, and along the tangent t \
         no force acts."
    };
    WorkedStep {
        title: "Resolve each velocity along n and along t",
        why: format!("{forces} {how}"),
        lines: vec![
            format!("n{n_form} = {}", vector(n, 1.0)),
            format!("t{t_form} = {}", vector(t, 1.0)),
            part("u₁ₙ", '₁', c.u1, 'n', n),
            part("u₁ₜ", '₁', c.u1, 't', t),
            part("u₂ₙ", '₂', c.u2, 'n', n),
            part("u₂ₜ", '₂', c.u2, 't', t),
        ],
    }
}

fn along(c: &Collision, after: &CollisionOutcome, n: DVec2) -> WorkedStep {
    let scale = speed_scale(c);
    let (m1, m2) = (grams(c.striker.mass), grams(c.target.mass));
    let total = number(g_from_kg(c.striker.mass + c.target.mass));
    let e = number(c.restitution);
    let lively = number(1.0 + c.restitution);
    let (u1n, u2n) = (c.u1.dot(n), c.u2.dot(n));
    let (f1, f2) = (factor(u1n, scale), factor(u2n, scale));
    let (v1n, v2n) = (after.v1.dot(n), after.v2.dot(n));
    let (v1n, v2n) = (beside(v1n, scale), beside(v2n, scale));
    let impulse = number(g_from_kg(after.impulse));
    let name = if c.rims.friction > 0.0 { "Jₙ" } else { "J" };
    WorkedStep {
        title: "Along n: a head-on collision in one dimension",
        why: "Momentum along n is conserved, and the speed of separation along n is e times the \
              speed of approach. Solved for the two velocities:"
            .to_owned(),
        lines: vec![
            "v₁ₙ = [(m₁ − e m₂) u₁ₙ + (1 + e) m₂ u₂ₙ] / (m₁ + m₂)".to_owned(),
            format!(
                "    = [({m1} − {e} × {m2}) × {f1} + {lively} × {m2} × {f2}] / {total} = {v1n} m/s"
            ),
            "v₂ₙ = [(m₂ − e m₁) u₂ₙ + (1 + e) m₁ u₁ₙ] / (m₁ + m₂)".to_owned(),
            format!(
                "    = [({m2} − {e} × {m1}) × {f2} + {lively} × {m1} × {f1}] / {total} = {v2n} m/s"
            ),
            format!("impulse  {name} = m₂ (v₂ₙ − u₂ₙ) = {impulse} g m/s"),
        ],
    }
}

fn across(c: &Collision, t: DVec2) -> WorkedStep {
    let scale = speed_scale(c);
    let line = |sub: char, u: DVec2| format!("v{sub}ₜ = u{sub}ₜ = {} m/s", beside(u.dot(t), scale));
    WorkedStep {
        title: "Along t: nothing changes",
        why: "No force acts along t, so each disc keeps that component of its velocity.".to_owned(),
        lines: vec![line('₁', c.u1), line('₂', c.u2)],
    }
}

fn together(c: &Collision, after: &CollisionOutcome, n: DVec2, t: DVec2) -> WorkedStep {
    let scale = speed_scale(c);
    let body = |sub: char, v: DVec2| {
        let (along, across) = (factor(v.dot(n), scale), factor(v.dot(t), scale));
        let speed = beside(v.length(), scale);
        [
            format!("v{sub} = v{sub}ₙ n + v{sub}ₜ t = {} m/s", vector(v, scale)),
            format!("     speed √({along}² + {across}²) = {speed} m/s"),
        ]
    };
    WorkedStep {
        title: "Add the components",
        why: "n and t are at right angles, so the speeds follow from Pythagoras' theorem."
            .to_owned(),
        lines: [body('₁', after.v1), body('₂', after.v2)].concat(),
    }
}
