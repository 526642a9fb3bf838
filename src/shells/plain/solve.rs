//! A worked solution in lines.

use super::number::number;
use super::spoken::sentence;
use super::talk::{Leave, Talk};
use super::working;
use crate::physics::worked::{self, WorkedStep};
use crate::physics::{CollisionSpec, ImpactPoint};

/// Writes a worked solution; if none is given, asks for the collision first.
///
/// # Errors
/// If the player quits, the input ends, or a line cannot be written or read.
pub fn solve(talk: &mut Talk, given: Option<Vec<WorkedStep>>) -> Result<(), Leave> {
    let steps = given.map_or_else(|| ask(talk), Ok)?;
    for (count, step) in (1..).zip(&steps) {
        talk.say(&format!("Step {count}: {}", sentence(step.title)))?;
        talk.say(&step.why)?;
        talk.say_all(working::lines(step))?;
    }
    Ok(())
}

/// Asks for each quantity in turn.
fn ask(talk: &mut Talk) -> Result<Vec<WorkedStep>, Leave> {
    talk.say("carrom solves a collision. Enter alone accepts the proposed value.")?;
    let mut one = |what: &str, unit: &str, proposed: f64, least: f64, most: f64| {
        let asked = format!("{what}? Proposed: {proposed}.");
        let help = "Type a number, or press Enter alone to accept the proposed value.";
        talk.ask_for(&asked, help, |heard| match heard {
            "" => Ok(proposed),
            heard => number(heard, unit, least, most),
        })
    };
    let m1_g = one("Mass of the striker in grams", "g", 15.0, 1e-3, 1e6)?;
    let m2_g = one("Mass of the target in grams", "g", 15.0, 1e-3, 1e6)?;
    let speed = one(
        "Speed of the striker in metres per second",
        "m/s",
        4.0,
        1e-3,
        1e3,
    )?;
    let alpha_deg = one(
        "Impact angle in degrees, positive if the target is to the right",
        "°",
        30.0,
        -89.9,
        89.9,
    )?;
    let restitution = one("Coefficient of restitution, from 0 to 1", "", 1.0, 0.0, 1.0)?;
    let spec = CollisionSpec {
        m1_g,
        m2_g,
        speed,
        point: ImpactPoint::Angle { alpha_deg },
        restitution,
        ..CollisionSpec::default()
    };
    Ok(worked::steps(&spec.collision(), false))
}
