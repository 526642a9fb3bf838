//! Why the two discs of a hit go where they go, on its own figures.

use crate::physics::CollisionOutcome;

use crate::numbers::{bare_degrees, bare_millimetres, degrees, significant};
use crate::physics::ImpactPoint;
use crate::quiz::question::Hit;

/// Why the two go where they go, on the hit's own figures.
pub(crate) fn reasoning(hit: &Hit) -> String {
    let outcome = hit.outcome();
    if hit.head_on() {
        return head_on(hit, &outcome);
    }
    let name = hit.pieces.target_name();
    let alpha = degrees(hit.alpha().abs());
    let target = match hit.given {
        ImpactPoint::Angle { .. } => {
            format!("The {name} leaves along the line of impact: {alpha}.")
        }
        ImpactPoint::Offset { offset_mm } => format!(
            "{} / {} = sin {alpha} gives the line of impact, the {name}'s path.",
            bare_millimetres(offset_mm.abs()),
            bare_millimetres(hit.reach_mm())
        ),
    };
    format!("{target} {}", striker(hit, &outcome))
}

/// The striker's part, by its velocity along the line of impact and across it.
fn striker(hit: &Hit, outcome: &CollisionOutcome) -> String {
    let (Some(normal), Some(tangent), Some(theta1), Some(separation)) = (
        outcome.normal,
        outcome.tangent,
        outcome.theta1,
        outcome.separation,
    ) else {
        return String::new();
    };
    let alpha = bare_degrees(hit.alpha().abs());
    let theta1 = degrees(theta1.abs());
    let along = outcome.v1.dot(normal);
    let across = significant(outcome.v1.dot(tangent).abs());
    // Rounding noise against the speed of the striker.
    if along.abs() <= 1e-9 * hit.speed {
        return format!(
            "Along it the striker gives up all its speed. Its part across stays, at right angles: \
             90 - {alpha} = {theta1}."
        );
    }
    let rest = significant(along.abs());
    let rest = if along > 0.0 {
        format!("along it {rest} m/s is left")
    } else {
        format!("along it, it bounces at {rest} m/s")
    };
    format!(
        "Across the line the striker keeps {across} m/s; {rest}. So the two part by \
         {separation}: {bare} - {alpha} = {theta1}.",
        separation = degrees(separation),
        bare = bare_degrees(separation),
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
            "With equal masses and no loss they exchange velocities: the striker stops".into()
        }
        None => format!(
            "A {name} of this mass would throw the striker back if no energy were lost. With this \
             loss it just stops it"
        ),
        Some(_) if outcome.v1.dot(collision.u1) < 0.0 => {
            format!("The lighter striker is thrown straight back, at {v1} m/s")
        }
        Some(_) if heavier => {
            format!("The heavier striker is slowed but goes on, at {v1} m/s")
        }
        Some(_) => {
            format!("As energy is lost, the striker is not quite stopped: it goes on, at {v1} m/s")
        }
    };
    format!("Head-on, everything stays on one line. {striker}, and the {name} leaves at {v2} m/s.")
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;
    use crate::physics::{Collision, Disc};

    /// Along the line the striker has (m₁ − e m₂) / (m₁ + m₂) of 4 m/s.
    #[test]
    fn head_on_the_reason_is_that_of_the_masses_and_the_loss() {
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
        assert!(said(15.0, 15.0, 0.5).contains("goes on, at 1.00 m/s"));
        assert!(said(15.0, 30.0, 0.5).contains("With this loss it just stops it"));
        assert!(said(45.0, 15.0, 1.0).contains("heavier striker is slowed"));
        assert!(said(15.0, 45.0, 1.0).contains("thrown straight back, at 2.00 m/s"));
        assert!(!said(20.0, 30.0, 0.5).contains("heavier"));
    }
}
