//! Explanations of where the two discs of a hit go, with the figures of the hit.

use std::f64::consts::FRAC_PI_2;

use crate::numbers::{Intermediate, bare_millimetres, degrees, fixed, significant, true_minus};
use crate::physics::{CollisionOutcome, ImpactPoint};
use crate::quiz::question::Hit;

/// Explains where the two discs go, with the figures of the hit.
pub(crate) fn reasoning(hit: &Hit) -> String {
    let outcome = hit.outcome();
    if hit.head_on() {
        return head_on(hit, &outcome);
    }
    let name = hit.pieces.target_name();
    let alpha = degrees(hit.alpha().abs());
    let is_stopped = outcome
        .normal
        .is_some_and(|normal| outcome.v1.dot(normal).abs() <= 1e-9 * hit.speed);
    let target = match hit.given {
        ImpactPoint::Angle { .. } if is_stopped => {
            format!("The {name} leaves along n, at α = {alpha}.")
        }
        ImpactPoint::Angle { .. } => format!("The {name} leaves along n."),
        ImpactPoint::Offset { offset_mm } => format!(
            "The {name} leaves along n: sin α = {} / {}, α = {alpha}.",
            bare_millimetres(offset_mm.abs()),
            bare_millimetres(hit.reach_mm())
        ),
    };
    format!("{target} {}", striker(hit, &outcome))
}

/// The sentence about the striker, based on its velocity components along n and t.
fn striker(hit: &Hit, outcome: &CollisionOutcome) -> String {
    let (Some(normal), Some(tangent), Some(theta1), Some(separation)) = (
        outcome.normal,
        outcome.tangent,
        outcome.theta1,
        outcome.separation,
    ) else {
        return String::new();
    };
    let (alpha, theta1) = (hit.alpha().abs(), theta1.abs());
    let (along, across) = (outcome.v1.dot(normal), outcome.v1.dot(tangent).abs());
    // Rounding errors are relative to the speed of the striker.
    if along.abs() <= 1e-9 * hit.speed {
        return format!(
            "Along n the striker stops; it keeps its component along t, at 90° − {}° = {}.",
            Intermediate::angle(alpha, |alpha| degrees(FRAC_PI_2 - alpha)),
            degrees(theta1)
        );
    }
    let shown = Intermediate::angle(separation, |whole| degrees(whole - alpha));
    let rest_of_sum = Intermediate::angle(alpha, |alpha| degrees(shown.value - alpha));
    let between =
        |along: f64, across: f64| fixed(across.atan2(along).to_degrees(), shown.decimals());
    let [along, across] = Intermediate::pair([along, across], between);
    let tangent = match along.value < 0.0 {
        true => format!("{across}/(−{})", along.size()),
        false => format!("{across}/{along}"),
    };
    format!(
        "The striker has {across} m/s along t and {along} m/s along n: tan φ = {tangent}, φ = {shown}° \
         to n, θ₁ = {shown}° − {rest_of_sum}° = {}.",
        degrees(theta1),
        along = true_minus(&along.to_string()),
    )
}

fn head_on(hit: &Hit, outcome: &CollisionOutcome) -> String {
    let name = hit.pieces.target_name();
    let collision = hit.collision();
    let v1 = significant(outcome.v1.length());
    let v2 = significant(outcome.v2.length());
    let heavier = collision.striker.mass > collision.target.mass;
    let striker = match outcome.theta1 {
        None if collision.striker.mass == collision.target.mass => {
            "With equal masses and no energy lost they exchange velocities: the striker stops"
                .into()
        }
        None => format!(
            "If no energy were lost, the striker would rebound from a {name} of this mass. With \
             this loss it just stops"
        ),
        Some(_) if outcome.v1.dot(collision.u1) < 0.0 => {
            format!("The lighter striker rebounds straight back at {v1} m/s")
        }
        Some(_) if heavier => {
            format!("The heavier striker is slowed but moves on at {v1} m/s")
        }
        Some(_) => {
            format!("As energy is lost, the striker does not quite stop: it moves on at {v1} m/s")
        }
    };
    format!(
        "In a head-on collision all motion stays on one line. {striker}, and the {name} \
             leaves at {v2} m/s."
    )
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;
    use crate::physics::{Collision, Disc};

    /// Along the line of impact the striker keeps the fraction (m₁ − e m₂) / (m₁ + m₂) of its
    /// original 4 m/s.
    #[test]
    fn a_head_on_explanation_depends_on_the_masses_and_the_loss() {
        let said = |m1: f64, m2: f64, restitution: f64| {
            let [striker, target] = [m1, m2].map(|mass| Disc::from_g_mm(mass, 15.0));
            let head_on = Collision::at_angle(striker, target, 4.0 * DVec2::X, 0.0);
            let collision = Collision {
                restitution,
                ..head_on
            };
            reasoning(&Hit::from(&collision))
        };
        assert!(said(15.0, 15.0, 1.0).contains("exchange velocities"));
        assert!(said(15.0, 15.0, 0.5).contains("energy is lost"));
        assert!(said(15.0, 15.0, 0.5).contains("moves on at 1.00 m/s"));
        assert!(said(15.0, 30.0, 0.5).contains("With this loss it just stops"));
        assert!(said(45.0, 15.0, 1.0).contains("heavier striker is slowed"));
        assert!(said(15.0, 45.0, 1.0).contains("rebounds straight back at 2.00 m/s"));
        assert!(!said(20.0, 30.0, 0.5).contains("heavier"));
    }
}
