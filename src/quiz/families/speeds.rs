//! How fast one of the two leaves, from the speed before and the impact angle.

use super::prelude::*;

const DRAWS: [HitDraws; 3] = [
    HitDraws(EQUAL, 15..=75, NO_LOSS),
    HitDraws(UNEQUAL, 15..=75, NO_LOSS),
    HitDraws(UNEQUAL, 15..=75, &[0.4, 0.5, 0.6, 0.8]),
];

pub(super) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let hit = DRAWS[difficulty as usize].draw(difficulty, dice)?;
    match difficulty {
        Difficulty::Easy if dice.coin() => striker(&hit),
        _ => target(&hit),
    }
}

/// The struck disc's speed: the head-on formula, for the part along the line of impact.
fn target(hit: &Hit) -> Option<Question> {
    let name = hit.pieces.target_name();
    let (u, alpha, e) = (hit.speed, hit.alpha().abs(), hit.restitution);
    let speed = |hit: &Hit| hit.outcome().v2.length();
    let (truth, before) = (speed(hit), significant(u));
    let lossless = speed(&hit.with_restitution(1.0));
    let along = u * alpha.cos();
    let equal = hit.masses_are_equal();
    let share = if equal && e >= 1.0 {
        format!("With equal masses and no loss the {name} takes all of it.")
    } else {
        let [times, after] = [truth / along, truth].map(significant);
        format!("The {name} leaves with (1 + e) m₁ / (m₁ + m₂) = {times} times that: {after} m/s.")
    };
    Outline::about(hit)
        .named("target", "target-speed")
        .ask(format!("How fast does the {name} leave?"))
        .number(Measure::Speed, truth)
        .wrong(SineCosine, truth * alpha.tan())
        .says(sine_for_cosine(name))
        .wrong(OneLineFormula, truth / alpha.cos())
        .says(format!(
            "You used the formula of a head-on hit on the whole {before} m/s. Only the part along \
             the line of impact takes part."
        ))
        .wrong(SpeedsAdd, equal.then_some(u * (1.0 - alpha.sin())))
        .says(
            "You took what the striker keeps off the speed before. Speeds do not add up so: they \
             are the sides of a triangle.",
        )
        .wrong(UpsideDown, speed(&hit.exchanged()))
        .says("You had the masses the other way round: a heavier striker gives the more speed.")
        .wrong(Lossless, lossless)
        .says(here_e("That is the speed without loss.", e))
        .wrong(LossOnEverything, e * lossless)
        .says(SHRUNK)
        .why(format!(
            "Along the line of impact the striker brings {before} cos {} = {} m/s. {share}",
            bare_degrees(alpha),
            significant(along)
        ))
}

/// Of whoever takes the sine for the cosine in what the struck disc of this name gets.
pub(super) fn sine_for_cosine(name: &str) -> String {
    format!("You took the sine for the cosine. Head-on the {name} gets the most.")
}

/// Of whoever takes e off a speed without loss.
pub(super) const SHRUNK: &str = "You multiplied the speed without loss by e. But e makes them \
                                 part more slowly; it does not shrink each speed.";

/// The striker's speed, equal masses: the part across the line of impact, which is all
/// that it keeps.
fn striker(hit: &Hit) -> Option<Question> {
    let (u, alpha) = (hit.speed, hit.alpha().abs());
    let outcome = hit.outcome();
    Outline::about(hit)
        .named("striker", "striker-speed")
        .ask("How fast does the striker go on?")
        .number(Measure::Speed, outcome.v1.length())
        .wrong(SineCosine, outcome.v2.length())
        .says("You took the cosine for the sine. Head-on the striker keeps nothing.")
        .wrong(SpeedsAdd, u - outcome.v2.length())
        .says(
            "You took the coin's speed off the speed before. Speeds do not add up so: they are \
             the sides of a triangle.",
        )
        .wrong(OneLineFormula, 0.0)
        .says(
            "You stopped the striker as in a head-on hit. Its part across the line of impact is \
             not touched.",
        )
        .why(format!(
            "With equal masses and no loss the striker gives up all it had along the line of \
             impact. It keeps the part across: {} sin {} = {} m/s.",
            significant(u),
            bare_degrees(alpha),
            significant(outcome.v1.length())
        ))
}
