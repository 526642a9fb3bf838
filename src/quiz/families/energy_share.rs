//! What share of the striker's energy each one has after the hit, and what share is lost.

use super::prelude::*;
use super::speeds::{SHRUNK, sine_for_cosine};

pub(super) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let unequal = [
        Pieces::Tournament,
        Pieces::Marbles,
        pair(20, 10),
        pair(10, 30),
    ];
    let draws = match difficulty {
        Difficulty::Easy => HitDraws(EQUAL, 15..=75, NO_LOSS),
        Difficulty::Middle => HitDraws(&unequal, 15..=75, NO_LOSS),
        Difficulty::Hard => HitDraws(ALL, 15..=75, &[0.2, 0.3, 0.4, 0.5, 0.6]),
    };
    let hit = draws.draw(difficulty, dice)?;
    match difficulty {
        Difficulty::Easy if dice.coin() => kept(&hit),
        Difficulty::Hard if dice.coin() => lost(&hit),
        _ => passed(&hit),
    }
}

const PERCENT: f64 = 100.0;

/// A share in percent, as printed.
fn percent(x: f64) -> String {
    Measure::Share.print(PERCENT * x)
}

const HALVES: &str =
    "You gave each of them half. That is so only at 45°, and only with equal masses.";

/// What the striker keeps, equal masses.
fn kept(hit: &Hit) -> Option<Question> {
    let alpha = hit.alpha().abs();
    let shares = RestingTarget::from(&hit.collision()).energy_shares(alpha);
    Outline::about(hit)
        .named("kept", "energy-of-striker")
        .ask("What share of its energy does it keep?")
        .number(Measure::Share, PERCENT * shares.kept)
        .wrong(EnergyAsSpeed, PERCENT * alpha.sin())
        .says(format!(
            "{} is its share of the speed. Energy goes with the square.",
            percent(alpha.sin())
        ))
        .wrong(SineCosine, PERCENT * shares.passed)
        .says(
            "That is the coin's share. Head-on the striker keeps nothing, so its share goes \
               with a sine.",
        )
        .wrong(HalfAndHalf, 50.0)
        .says(HALVES)
        .why(format!(
            "The striker keeps the part of its speed across the line of impact, sin {} = {}. \
             Squared, that is {} of the energy.",
            bare_degrees(alpha),
            significant(alpha.sin()),
            percent(shares.kept)
        ))
}

/// What the struck disc takes.
fn passed(hit: &Hit) -> Option<Question> {
    let name = hit.pieces.target_name();
    let alpha = hit.alpha().abs();
    let masses = RestingTarget::from(&hit.collision());
    let shares = masses.energy_shares(alpha);
    let without_loss = RestingTarget {
        restitution: 1.0,
        ..masses
    };
    let without_loss = PERCENT * without_loss.energy_shares(alpha).passed;
    let (e, speed) = (hit.restitution, masses.target_speed(alpha));
    let equal = hit.masses_are_equal();
    let by_mass = PERCENT * masses.m2 / (masses.m1 + masses.m2);
    let ratio = if equal {
        String::new()
    } else {
        format!(
            "and times m₂ / m₁ = {}, ",
            significant(masses.m2 / masses.m1)
        )
    };
    Outline::about(hit)
        .named("passed", "energy-of-target")
        .ask(format!("What share of its energy does the {name} get?"))
        .number(Measure::Share, PERCENT * shares.passed)
        .wrong(EnergyAsSpeed, PERCENT * speed)
        .says(format!(
            "{} is its speed against the striker's. Energy goes with the square, and with the \
             mass.",
            percent(speed)
        ))
        .wrong(SineCosine, PERCENT * shares.passed * alpha.tan().powi(2))
        .says(sine_for_cosine(name))
        .wrong(HalfAndHalf, equal.then_some(50.0))
        .says(HALVES)
        .wrong(HeavyTakesEnergy, (!equal).then_some(by_mass))
        .says("You shared the energy out by mass. The hit shares out momentum, not energy.")
        .wrong(Lossless, without_loss)
        .says(here_e("That is so without loss.", e))
        .wrong(EAsEnergy, e * without_loss)
        .says("You took e as a share of energy. It compares speeds of parting and of meeting.")
        .wrong(LossOnEverything, e * e * without_loss)
        .says(SHRUNK)
        .why(format!(
            "The {name} leaves with (1 + e) m₁ / (m₁ + m₂) cos {} = {} times the striker's speed. \
             Squared, {ratio}that is {} of the energy.",
            bare_degrees(alpha),
            significant(speed),
            percent(shares.passed)
        ))
}

/// What is lost: only of what the two have against each other along the line of impact.
fn lost(hit: &Hit) -> Option<Question> {
    let alpha = hit.alpha().abs();
    let masses = RestingTarget::from(&hit.collision());
    let lost = masses.energy_shares(alpha).lost;
    let e = hit.restitution;
    let missing = (1.0 - e) * (1.0 + e);
    Outline::about(hit)
        .named("lost", "energy-lost")
        .ask("What share of its energy is lost?")
        .number(Measure::Share, PERCENT * lost)
        .wrong(EAsEnergy, PERCENT * (1.0 - e))
        .says(format!(
            "You took e = {} as the share that is kept. e compares speeds, not energies.",
            significant(e)
        ))
        .wrong(LossOnEverything, PERCENT * missing)
        .says(
            "You took the loss off all of the motion. Only the part along the line of impact can \
             be lost.",
        )
        .wrong(SineCosine, PERCENT * lost * alpha.tan().powi(2))
        .says("You took the sine for the cosine. Head-on most is lost.")
        .why(format!(
            "At most m₂ / (m₁ + m₂) cos² {} = {} of the energy can be lost: that of their \
             approach along the line. Of that 1 - e² = {} is lost.",
            bare_degrees(alpha),
            percent(lost / missing),
            percent(missing)
        ))
}
