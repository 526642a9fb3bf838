//! The effects of the coefficient of restitution e on the speed of separation and on the angle
//! between the paths, and the masses that give a right angle in spite of a loss.

use super::prelude::*;
use super::separation::twice_alpha;
use super::weigh::seen_angles;
use crate::physics::resting_target::k_from_angles;

/// The masses in grams and e in tenths, with m₁ = e m₂: m₁, m₂, e.
const SQUARE: [&[(u32, u32, u32)]; 4] = [
    &[(4, 20, 2), (6, 20, 3), (6, 15, 4), (8, 20, 4)],
    &[(10, 20, 5), (12, 24, 5), (15, 30, 5)],
    &[(9, 15, 6), (12, 20, 6), (18, 30, 6)],
    &[(14, 20, 7), (16, 20, 8)],
];

pub(super) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    match difficulty {
        Difficulty::Easy if dice.coin() => square_again(dice),
        Difficulty::Easy => parting(dice),
        Difficulty::Middle if dice.coin() => striker_for_square(dice),
        Difficulty::Middle => e_for_square(dice),
        Difficulty::Hard if dice.coin() => corner(dice),
        Difficulty::Hard => e_from_angles(dice),
    }
}

/// The setting of a question that asks for the striker's mass.
fn of_any_striker(hit: &Hit) -> String {
    format!(
        "A smooth striker hits a smooth coin of {} g at rest, off-centre. {}",
        significant(hit.masses_g()[1]),
        hit.loss()
    )
}

const NOT_HERE: &str = "For equal masses the angle is 90° only if no energy is lost.";

/// Asks whether a right angle is possible in spite of a loss, and for which striker.
fn square_again(dice: &mut Dice) -> Option<Question> {
    const STRIKERS: [&str; 4] = [
        "for a certain lighter striker",
        "for a striker of equal mass",
        "for a certain heavier striker",
        "for no striker at all",
    ];
    let e = f64::from(*dice.pick(&[3, 4, 5, 6, 7, 8])?) / 10.0;
    let coin_g = *dice.pick(&[10, 15, 20, 30])?;
    let hit = drawn(pair(coin_g, coin_g), e, Difficulty::Easy, dice)?;
    let mut order = [0, 1, 2, 3];
    dice.shuffle(&mut order);
    let place = |it: usize| order.iter().position(|i| *i == it).unwrap_or(0);
    Outline::with_text(&hit, of_any_striker(&hit), Illustration::Nothing)
        .named("striker", "square-in-spite-of-loss")
        .ask("For which striker is the angle between the paths exactly 90°?")
        .options(order.map(|i| STRIKERS[i]), place(0))
        .chooses(AlwaysSquare, place(1))
        .says(here_e(NOT_HERE, e))
        .chooses(HeavyRebounds, place(2))
        .says(
            "You chose a heavier striker. But with a loss even an equal striker moves on along \
             the line of impact.",
        )
        .chooses(LossForbidsSquare, place(3))
        .says("You assumed that a loss rules out the right angle. But other masses can give 90°.")
        .why(format!(
            "{COMPONENT} With a loss this requires m₁ = e m₂ = {} × {} g = {} g.",
            significant(e),
            significant(f64::from(coin_g)),
            significant(e * f64::from(coin_g))
        ))
}

/// Draws a value of e from 0.2 to 0.8.
fn tenths(dice: &mut Dice) -> Option<f64> {
    let tenths = *dice.pick(&[2, 3, 4, 5, 6, 7, 8])?;
    Some(f64::from(tenths) / 10.0)
}

/// Asks for e, given the speeds after a head-on hit of equal masses.
fn parting(dice: &mut Dice) -> Option<Question> {
    let e = tenths(dice)?;
    let hit = drawn(Pieces::Equal, e, Difficulty::Easy, dice)?.at_angle(0.0);
    let outcome = hit.outcome();
    let (u, v1, v2) = (hit.speed, outcome.v1.length(), outcome.v2.length());
    let [u_words, v1_words, v2_words] = [u, v1, v2].map(significant);
    let text = format!(
        "A striker moving at {u_words} m/s hits a coin of the same mass at rest, head-on. \
         Afterwards the striker moves on at {v1_words} m/s, the coin at {v2_words} m/s."
    );
    Outline::with_text(&hit, text, unmarked(&hit))
        .named("e head-on", "e-head-on")
        .ask("What is e?")
        .number(Measure::Restitution, e)
        .wrong(EAsEnergy, outcome.energy_after / outcome.energy_before)
        .says(
            "That is the share of the energy that is left. e compares speeds: the speed of \
             separation and the speed of approach.",
        )
        .wrong(LossOnEverything, v2 / u)
        .says(
            "You divided the coin's speed by the striker's original speed. e compares the speed \
             of separation with the speed of approach.",
        )
        .wrong(Lossless, 1.0)
        .says("e = 1 means that no energy is lost: the striker would have stopped.")
        .why(format!(
            "The speed of separation is {v2_words} − {v1_words} = {apart} m/s, and the speed of \
             approach was {u_words} m/s. So e = {apart} / {u_words} = {}.",
            significant(e),
            apart = significant(v2 - v1),
        ))
}

/// Draws a collision that loses energy and after which the paths are at right angles.
fn square(dice: &mut Dice) -> Option<Hit> {
    let (m1_g, m2_g, e_tenths) = *dice.pick(&SQUARE.concat())?;
    let e = f64::from(e_tenths) / 10.0;
    drawn(pair(m1_g, m2_g), e, Difficulty::Middle, dice)
}

const COMPONENT: &str = "The angle is 90° if the striker's final velocity has no component along \
                         the line of impact.";

const PROPORTIONAL: &str = "That component is proportional to m₁ − e m₂.";

/// Asks for the striker's mass that makes the angle 90°.
fn striker_for_square(dice: &mut Dice) -> Option<Question> {
    let hit = square(dice)?;
    let ([m1, m2], e) = (hit.masses_g(), hit.restitution);
    Outline::with_text(&hit, of_any_striker(&hit), Illustration::Nothing)
        .named("striker mass", "square-in-spite-of-loss")
        .ask("For which mass of the striker is the angle between the paths exactly 90°?")
        .number(Measure::Mass, m1)
        .wrong(AlwaysSquare, m2)
        .says(here_e(
            "For equal masses the angle is 90° if no energy is lost.",
            e,
        ))
        .wrong(UpsideDown, m2 / e)
        .says("You inverted the ratio. m₁ / m₂ is e, not 1 / e.")
        .wrong(EAsEnergy, e.sqrt() * m2)
        .says("You used √e, as if e were a share of energy. e compares speeds.")
        .why(format!(
            "{COMPONENT} {PROPORTIONAL} So m₁ = e m₂ = {} × {} g = {} g.",
            significant(e),
            significant(m2),
            significant(m1)
        ))
}

/// Asks for the value of e that makes the angle between the paths 90°, given the two masses.
fn e_for_square(dice: &mut Dice) -> Option<Question> {
    let hit = square(dice)?;
    let e = hit.restitution;
    Outline::with_text(&hit, off_centre(&hit), unmarked(&hit))
        .named("e square", "e-for-square")
        .ask("The angle between their paths is exactly 90°. What is e?")
        .number(Measure::Restitution, e)
        .wrong(LossForbidsSquare, 1.0)
        .says(
            "You assumed that the angle is 90° only if no energy is lost. With a lighter striker \
             a loss is required.",
        )
        .wrong(EAsEnergy, e * e)
        .says("You squared the ratio, as if e were a share of energy. e compares speeds.")
        .wrong(LossOnEverything, 1.0 - e)
        .says("Your answer is close to 1 − m₁/m₂. The coefficient of restitution is m₁/m₂ itself.")
        .why(format!(
            "{COMPONENT} {PROPORTIONAL} So e = m₁ / m₂ = {} g / {} g = {}.",
            significant(hit.masses_g()[0]),
            significant(hit.masses_g()[1]),
            significant(e)
        ))
}

/// Asks for the angle between the paths of equal masses after a collision with a loss.
fn corner(dice: &mut Dice) -> Option<Question> {
    let e = f64::from(*dice.pick(&[2, 3, 4, 5, 6, 7])?) / 10.0;
    let hit = drawn(Pieces::Equal, e, Difficulty::Hard, dice)?;
    let alpha = hit.alpha().abs();
    let separation = hit.outcome().separation?;
    let between = |across: f64, along: f64| degrees(across.atan2(along));
    let along = 0.5 * (1.0 - e) * alpha.cos();
    let [across, along] = Intermediate::pair([alpha.sin(), along], between);
    Outline::about(&hit)
        .named("separation", "corner-with-loss")
        .ask("What is the angle between their paths after the collision?")
        .number(Measure::Angle, deg_from_rad(separation))
        .wrong(AlwaysSquare, 90.0)
        .says(here_e(NOT_HERE, e))
        .wrong(LossOnEverything, 90.0 * e)
        .says(
            "You multiplied the right angle by e. But e applies only along the line of impact.",
        )
        .wrong(CopiedAngle, 2.0 * deg_from_rad(alpha))
        .says(twice_alpha(alpha, "coin"))
        .wrong(LossOpensAngle, 180.0 - deg_from_rad(separation))
        .says("You made the angle larger than a right angle, by as much as the loss makes it smaller.")
        .why(format!(
            "The striker keeps sin {alpha}° = {across} of its speed perpendicular to the line of \
             impact and (1 − {}) / 2 × cos {alpha}° = {along} along it. The tangent of the angle is {across} / {along}, and the angle is {}.",
            significant(e),
            between(across.value, along.value),
            alpha = bare_degrees(alpha),
        ))
}

/// Asks for e, given the masses and the two angles after the collision.
fn e_from_angles(dice: &mut Dice) -> Option<Question> {
    let e = tenths(dice)?;
    let (m1_g, m2_g) = *dice.pick(&[(15, 15), (20, 20), (15, 10), (20, 15), (10, 15), (15, 20)])?;
    let hit = drawn(pair(m1_g, m2_g), e, Difficulty::Hard, dice)?;
    let outcome = hit.outcome();
    let [m1, m2] = hit.masses_g();
    let k = RestingTarget::from(&hit.collision()).k();
    let [read1, read2] = [outcome.theta1?.abs(), outcome.theta2?.abs()].map(read_off_angle);
    let read = k_from_angles(read1, read2).unwrap_or(k);
    let found = |k: f64| k * (m1 + m2) / m2 - 1.0;
    let shown = Intermediate::new(read, |k| significant(found(k)));
    let text = format!(
        "{}. {}",
        hit.who("smooth striker", "hit"),
        seen_angles(outcome.theta1?.abs(), outcome.theta2?.abs())
    );
    let collision = hit.collision();
    Outline::with_text(&hit, text, Illustration::After { collision })
        .named("e angles", "e-from-angles")
        .ask("What is e?")
        .number(Measure::Restitution, e)
        .wrong(EAsEnergy, outcome.energy_after / outcome.energy_before)
        .says("That is the share of the energy that is left.")
        .wrong(UpsideDown, k * (m1 + m2) / m1 - 1.0)
        .says("You swapped the two masses.")
        .wrong(Lossless, 1.0)
        .says("An e close to 1 means almost no loss. The angles would be different.")
        .why(format!(
            "Along the line of impact the striker loses the fraction k = sin θ₁ / \
             (cos θ₂ sin(θ₁ + θ₂)) = {shown}. As k = (1 + e) m₂ / (m₁ + m₂), e = {shown} × {} / {} \
             − 1 = {}.",
            significant(m1 + m2),
            significant(m2),
            within_readings(&significant(found(shown.value)), &significant(e)),
        ))
}
