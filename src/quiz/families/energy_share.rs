//! The fraction of the striker's energy that each disc has after the collision, and the fraction
//! that is lost.

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

/// A fraction as a percentage, as printed.
fn percent(x: f64) -> String {
    Measure::Share.print(PERCENT * x)
}

const HALVES: &str =
    "You gave each disc half the energy. With equal masses that requires α = 45° and no loss.";

/// Asks for the fraction that the striker keeps, with equal masses.
fn kept(hit: &Hit) -> Option<Question> {
    let alpha = hit.alpha().abs();
    let shares = RestingTarget::from(&hit.collision()).energy_shares(alpha);
    let sin = Intermediate::new(alpha.sin(), |sin| percent(sin * sin));
    Outline::about(hit)
        .named("kept", "energy-of-striker")
        .ask("What share of its kinetic energy does the striker keep?")
        .number(Measure::Share, PERCENT * shares.kept)
        .wrong(EnergyAsSpeed, PERCENT * alpha.sin())
        .says(format!(
            "{} is the striker's share of the speed. Energy is proportional to the square of the \
             speed.",
            percent(alpha.sin())
        ))
        .wrong(SineCosine, PERCENT * shares.passed)
        .says(
            "That is the coin's share. Head-on, the striker keeps no energy, so you need the sine.",
        )
        .wrong(HalfAndHalf, 50.0)
        .says(HALVES)
        .why(format!(
            "The striker keeps the component perpendicular to the line of impact, sin {}° = {sin} \
             of its speed. The share of the energy is the square: {sin}² = {}.",
            bare_degrees(alpha),
            percent(sin.value.powi(2)),
        ))
}

/// Asks for the fraction that is transferred to the target.
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
    let share = |speed: f64, ratio: f64| percent(ratio * speed.powi(2));
    let [shown, ratio] = Intermediate::pair([speed, masses.m2 / masses.m1], share);
    let passed = share(shown.value, ratio.value);
    let of_energy = if equal {
        format!("{shown}² = {passed}")
    } else {
        format!("m₂ / m₁ times the square, {ratio} × {shown}² = {passed}")
    };
    Outline::about(hit)
        .named("passed", "energy-of-target")
        .ask(format!(
            "What share of the striker's kinetic energy does the {name} get?"
        ))
        .number(Measure::Share, PERCENT * shares.passed)
        .wrong(EnergyAsSpeed, PERCENT * speed)
        .says(format!(
            "{} is the {name}'s speed divided by the striker's. Energy is proportional to the \
             square of the speed, and to the mass.",
            percent(speed)
        ))
        .wrong(SineCosine, PERCENT * shares.passed * alpha.tan().powi(2))
        .says(sine_for_cosine(name))
        .wrong(HalfAndHalf, equal.then_some(50.0))
        .says(HALVES)
        .wrong(HeavyTakesEnergy, (!equal).then_some(by_mass))
        .says(
            "You split the energy in proportion to mass. A collision does not share it that \
               way: work out ½m₂v₂² and divide by ½m₁u².",
        )
        .wrong(Lossless, without_loss)
        .says(here_e("That is right if no energy is lost.", e))
        .wrong(EAsEnergy, e * without_loss)
        .says("You used e as a share of energy. e compares the speeds of separation and approach.")
        .wrong(LossOnEverything, e * e * without_loss)
        .says(SHRUNK)
        .why(format!(
            "The {name}'s speed is (1 + e) m₁ cos {}° / (m₁ + m₂) = {shown} of the striker's \
             original speed. The {name}'s share of the energy is {of_energy}.",
            bare_degrees(alpha)
        ))
}

/// Asks for the fraction that is lost: only the energy of the relative motion along the line of
/// impact can be lost.
fn lost(hit: &Hit) -> Option<Question> {
    let alpha = hit.alpha().abs();
    let masses = RestingTarget::from(&hit.collision());
    let lost = masses.energy_shares(alpha).lost;
    let e = hit.restitution;
    let missing = (1.0 - e) * (1.0 + e);
    let without_return = PERCENT * missing;
    let product = |most: f64, missing: f64| percent(most * missing);
    let [most, missing] = Intermediate::pair([lost / missing, missing], product);
    Outline::about(hit)
        .named("lost", "energy-lost")
        .ask("What share of the kinetic energy is lost?")
        .number(Measure::Share, PERCENT * lost)
        .wrong(EAsEnergy, PERCENT * (1.0 - e))
        .says(format!(
            "You used e = {} as the share that is kept. e compares speeds, not energies.",
            significant(e)
        ))
        .wrong(LossOnEverything, without_return)
        .says(
            "You applied the loss to all of the motion. Only the energy of motion along the line \
             of impact can be lost.",
        )
        .wrong(SineCosine, PERCENT * lost * alpha.tan().powi(2))
        .says("You used the sine instead of the cosine. The loss is greatest head-on.")
        .why(format!(
            "At most m₂ cos² {}° / (m₁ + m₂) = {most} of the energy can be lost: the energy of the \
             approach along the line of impact. The share 1 − e² = {missing} of this is lost: \
             {most} × {missing} = {}.",
            bare_degrees(alpha),
            product(most.value, missing.value)
        ))
}
