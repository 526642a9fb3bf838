//! Why the two discs of a hit go where they go, on its own figures.

use crate::physics::CollisionOutcome;

use crate::numbers::{bare_degrees, bare_millimetres, degrees, significant};
use crate::physics::ImpactPoint;
use crate::quiz::question::Hit;

/// Why the two go where they go, on the hit's own figures.
pub fn reasoning(hit: &Hit) -> String {
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
            "{} / {} = sin {alpha}: there lies the line of impact, the {name}'s path.",
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
    let before = hit.collision().u1;
    let v1 = significant(outcome.v1.length());
    let v2 = significant(outcome.v2.length());
    let striker = match outcome.theta1 {
        None => "With equal masses and no loss they exchange velocities: the striker stops".into(),
        Some(_) if outcome.v1.dot(before) > 0.0 => {
            format!("The heavier striker is slowed but goes on, at {v1} m/s")
        }
        Some(_) => format!("The lighter striker is thrown straight back, at {v1} m/s"),
    };
    format!("Head-on, all stays on one line. {striker}, and the {name} leaves at {v2} m/s.")
}
