//! The final speed of one of the two discs, given the initial speed and the impact angle.

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

/// Asks for the target's speed: the head-on formula applies to the component along the line of
/// impact.
fn target(hit: &Hit) -> Option<Question> {
    let name = hit.pieces.target_name();
    let (u, alpha, e) = (hit.speed, hit.alpha().abs(), hit.restitution);
    let speed = |hit: &Hit| hit.outcome().v2.length();
    let (truth, before) = (speed(hit), significant(u));
    let lossless = speed(&hit.with_restitution(1.0));
    let along = u * alpha.cos();
    let equal = hit.masses_are_equal();
    let product = |along: f64, times: f64| significant(along * times);
    let [shown, times] = Intermediate::pair([along, truth / along], product);
    let share = if equal && e >= 1.0 {
        format!("With equal masses and no energy lost, the {name} gets all of this.")
    } else {
        format!(
            "The {name}'s speed is (1 + e) m₁ / (m₁ + m₂) times this: {times} × {shown} m/s = {} \
             m/s.",
            product(shown.value, times.value)
        )
    };
    Outline::about(hit)
        .named("target", "target-speed")
        .ask(format!("What is the {name}'s speed after the collision?"))
        .number(Measure::Speed, truth)
        .wrong(SineCosine, truth * alpha.tan())
        .says(sine_for_cosine(name))
        .wrong(OneLineFormula, truth / alpha.cos())
        .says(format!(
            "You used the formula for a head-on collision with the whole {before} m/s. Use only \
             the component along the line of impact."
        ))
        .wrong(SpeedsAdd, equal.then_some(u * (1.0 - alpha.sin())))
        .says(
            "You subtracted the striker's final speed from the original speed. Speeds do not add \
             up like that: they are the sides of a triangle.",
        )
        .wrong(UpsideDown, speed(&hit.exchanged()))
        .says(format!(
            "You swapped the two masses: a heavier striker makes the {name} faster."
        ))
        .wrong(Lossless, lossless)
        .says(here_e("That is the speed if no energy is lost.", e))
        .wrong(LossOnEverything, e * lossless)
        .says(SHRUNK)
        .why(format!(
            "The striker's component along the line of impact is {before} m/s × cos {}° = {shown} \
             m/s. {share}",
            bare_degrees(alpha),
        ))
}

/// Feedback for an answer with the sine instead of the cosine in the target's speed or energy.
pub(super) fn sine_for_cosine(name: &str) -> String {
    format!("You used the sine instead of the cosine. Head-on, the {name} gets the most.")
}

/// Feedback for an answer that is, or follows from, the lossless speed multiplied by e.
pub(super) const SHRUNK: &str = "Your answer fits e times the speed without loss. But e multiplies \
                                 the speed of separation, not each of the two speeds.";

/// Asks for the striker's speed with equal masses: the striker keeps only the component
/// perpendicular to the line of impact.
fn striker(hit: &Hit) -> Option<Question> {
    let (u, alpha) = (hit.speed, hit.alpha().abs());
    let outcome = hit.outcome();
    Outline::about(hit)
        .named("striker", "striker-speed")
        .ask("What is the striker's speed after the collision?")
        .number(Measure::Speed, outcome.v1.length())
        .wrong(SineCosine, outcome.v2.length())
        .says("You used the cosine instead of the sine. Head-on, the striker stops.")
        .wrong(SpeedsAdd, u - outcome.v2.length())
        .says(
            "You subtracted the coin's speed from the original speed. Speeds do not add up like \
             that: they are the sides of a triangle.",
        )
        .wrong(OneLineFormula, 0.0)
        .says(
            "You assumed that the striker stops, as in a head-on collision. But its component \
             perpendicular to the line of impact does not change.",
        )
        .why(format!(
            "With equal masses and no energy lost the striker loses all of its velocity along the \
             line of impact. It keeps the perpendicular component: {} m/s × sin {}° = {} m/s.",
            significant(u),
            bare_degrees(alpha),
            significant(outcome.v1.length())
        ))
}
