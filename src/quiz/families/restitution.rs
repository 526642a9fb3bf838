//! What the coefficient of restitution e does: speeds of parting, the corner, and where the
//! right angle is found again.

use super::prelude::*;
use super::separation::twice_alpha;
use super::weigh::seen_angles;

/// Masses in grams and e in tenths, with m₁ = e m₂: m₁, m₂, e.
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

/// A hit of which the striker's mass is asked for, in words.
fn of_any_striker(hit: &Hit) -> String {
    format!(
        "Smooth discs meet off-centre, the coin of {} g at rest. {}",
        significant(hit.masses_g()[1]),
        hit.loss()
    )
}

const NOT_HERE: &str = "The right angle of equal masses needs that nothing is lost.";

const HEAVIER_CLOSES: &str = "You had it the other way round: a heavier striker makes the angle \
                              smaller, and so does loss.";

/// Whether, and with which striker, there is a right angle in spite of loss.
fn square_again(dice: &mut Dice) -> Option<Question> {
    const STRIKERS: [&str; 4] = [
        "with a certain lighter striker",
        "with a striker of equal mass",
        "with a certain heavier striker",
        "with no striker at all",
    ];
    let e = f64::from(*dice.pick(&[3, 4, 5, 6, 7, 8])?) / 10.0;
    let coin_g = *dice.pick(&[10, 15, 20, 30])?;
    let hit = drawn(pair(coin_g, coin_g), e, Difficulty::Easy, dice)?;
    let mut order = [0, 1, 2, 3];
    dice.shuffle(&mut order);
    let place = |it: usize| order.iter().position(|i| *i == it).unwrap_or(0);
    Outline::told(&hit, of_any_striker(&hit), Illustration::Nothing)
        .named("striker", "square-in-spite-of-loss")
        .ask("With which striker do the two part at exactly 90°?")
        .options(order.map(|i| STRIKERS[i]), place(0))
        .chooses(AlwaysSquare, place(1))
        .says(here_e(NOT_HERE, e))
        .chooses(UpsideDown, place(2))
        .says(HEAVIER_CLOSES)
        .chooses(LossForbidsSquare, place(3))
        .says("You thought that loss rules out the right angle. It only takes other masses.")
        .why(format!(
            "They part at a right angle when the striker stops along the line of impact. With \
             loss it still follows an equal coin; one of m₁ = e m₂ = {} g just stops.",
            significant(e * f64::from(coin_g))
        ))
}

/// An e from 0.2 to 0.8.
fn tenths(dice: &mut Dice) -> Option<f64> {
    let tenths = *dice.pick(&[2, 3, 4, 5, 6, 7, 8])?;
    Some(f64::from(tenths) / 10.0)
}

/// e from the speeds after a head-on hit of equal masses.
fn parting(dice: &mut Dice) -> Option<Question> {
    let e = tenths(dice)?;
    let hit = drawn(Pieces::Equal, e, Difficulty::Easy, dice)?.at_angle(0.0);
    let outcome = hit.outcome();
    let (u, v1, v2) = (hit.speed, outcome.v1.length(), outcome.v2.length());
    let [u_words, v1_words, v2_words] = [u, v1, v2].map(significant);
    let text = format!(
        "A striker hits a resting coin of the same mass head-on at {u_words} m/s. After it the \
         striker goes on at {v1_words} m/s, the coin at {v2_words} m/s."
    );
    Outline::told(&hit, text, unmarked(&hit))
        .named("e head-on", "e-head-on")
        .ask("What is e?")
        .number(Measure::Restitution, e)
        .wrong(EAsEnergy, outcome.energy_after / outcome.energy_before)
        .says(
            "That is the share of the energy that is left. e compares speeds: how they part and \
             how they met.",
        )
        .wrong(LossOnEverything, v2 / u)
        .says(
            "You compared the coin's speed with the striker's before. e compares how fast the two \
             part from each other.",
        )
        .wrong(Lossless, 1.0)
        .says("e = 1 is a hit without loss: the striker would have stopped.")
        .why(format!(
            "They part at {v2_words} - {v1_words} = {} m/s and met at {u_words} m/s. e is the first \
             over the second: {}.",
            significant(v2 - v1),
            significant(e)
        ))
}

/// A hit that is square in spite of loss.
fn square(dice: &mut Dice) -> Option<Hit> {
    let (m1_g, m2_g, e_tenths) = *dice.pick(&SQUARE.concat())?;
    let e = f64::from(e_tenths) / 10.0;
    drawn(pair(m1_g, m2_g), e, Difficulty::Middle, dice)
}

const STOPS: &str = "At a right angle the striker stops along the line of impact. What it keeps \
                     there goes with m₁ - e m₂.";

/// The striker's mass that brings the right angle back.
fn striker_for_square(dice: &mut Dice) -> Option<Question> {
    let hit = square(dice)?;
    let ([m1, m2], e) = (hit.masses_g(), hit.restitution);
    Outline::told(&hit, of_any_striker(&hit), Illustration::Nothing)
        .named("striker mass", "square-in-spite-of-loss")
        .ask("With which mass of the striker do they part at exactly 90°?")
        .number(Measure::Mass, m1)
        .wrong(AlwaysSquare, m2)
        .says(here_e("Equal masses part at 90° when nothing is lost.", e))
        .wrong(UpsideDown, m2 / e)
        .says(HEAVIER_CLOSES)
        .wrong(EAsEnergy, e.sqrt() * m2)
        .says("You took the root of e, as if it were a share of energy. e compares speeds.")
        .why(format!("{STOPS} So m₁ = e m₂ = {} g.", significant(m1)))
}

/// The e that brings the right angle to two masses.
fn e_for_square(dice: &mut Dice) -> Option<Question> {
    let hit = square(dice)?;
    let e = hit.restitution;
    Outline::told(&hit, off_centre(&hit), unmarked(&hit))
        .named("e square", "e-for-square")
        .ask("They part at exactly 90°. What is e?")
        .number(Measure::Restitution, e)
        .wrong(LossForbidsSquare, 1.0)
        .says(
            "You thought that only a hit without loss gives 90°. With a lighter striker it takes \
             some loss.",
        )
        .wrong(EAsEnergy, e * e)
        .says("You squared the ratio, as if e were a share of energy. e compares speeds.")
        .wrong(LossOnEverything, 1.0 - e)
        .says("That is what is missing of the ratio of masses. e is the ratio itself.")
        .why(format!("{STOPS} So e = m₁ / m₂ = {}.", significant(e)))
}

/// How far loss closes the corner of equal masses.
fn corner(dice: &mut Dice) -> Option<Question> {
    let e = f64::from(*dice.pick(&[2, 3, 4, 5, 6, 7])?) / 10.0;
    let hit = drawn(Pieces::Equal, e, Difficulty::Hard, dice)?;
    let alpha = hit.alpha().abs();
    let separation = hit.outcome().separation?;
    Outline::about(&hit)
        .named("separation", "corner-with-loss")
        .ask("How many degrees apart do they leave?")
        .number(Measure::Angle, deg_from_rad(separation))
        .wrong(AlwaysSquare, 90.0)
        .says(here_e(NOT_HERE, e))
        .wrong(LossOnEverything, 90.0 * e)
        .says(
            "You multiplied the right angle itself by e. But e works along the line of impact \
             alone.",
        )
        .wrong(CopiedAngle, 2.0 * deg_from_rad(alpha))
        .says(twice_alpha(alpha, "coin"))
        .wrong(UpsideDown, 180.0 - deg_from_rad(separation))
        .says("You made the angle larger by as much as loss makes it smaller.")
        .why(format!(
            "Of its speed the striker keeps sin {} = {} across the line and (1 - e) / 2 cos {0} = \
             {} along it, the coin's direction. The first over the second is the tangent of {}.",
            bare_degrees(alpha),
            significant(alpha.sin()),
            significant(0.5 * (1.0 - e) * alpha.cos()),
            degrees(separation)
        ))
}

/// e from the two angles after a hit, the masses being known.
fn e_from_angles(dice: &mut Dice) -> Option<Question> {
    let e = tenths(dice)?;
    let (m1_g, m2_g) = *dice.pick(&[(15, 15), (20, 20), (15, 10), (20, 15), (10, 15), (15, 20)])?;
    let hit = drawn(pair(m1_g, m2_g), e, Difficulty::Hard, dice)?;
    let outcome = hit.outcome();
    let [m1, m2] = hit.masses_g();
    let k = RestingTarget::from(&hit.collision()).k();
    let text = format!(
        "{}. {}",
        hit.who("smooth striker", "hit"),
        seen_angles(outcome.theta1?.abs(), outcome.theta2?.abs())
    );
    let collision = hit.collision();
    Outline::told(&hit, text, Illustration::After { collision })
        .named("e angles", "e-from-angles")
        .ask("What is e?")
        .number(Measure::Restitution, e)
        .wrong(EAsEnergy, outcome.energy_after / outcome.energy_before)
        .says(
            "That is the share of the energy that is left. e compares speeds along the line of \
             impact.",
        )
        .wrong(UpsideDown, k * (m1 + m2) / m1 - 1.0)
        .says("You had the two masses the other way round.")
        .wrong(Lossless, 1.0)
        .says("Without loss these masses would part at another angle.")
        .why(format!(
            "Along the line the striker gives up k = sin θ₁ / (cos θ₂ sin(θ₁ + θ₂)) = {} of its \
             speed. k is (1 + e) m₂ / (m₁ + m₂), so e = {}.",
            significant(k),
            significant(e)
        ))
}
