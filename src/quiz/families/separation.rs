//! The angle between the paths: whether it is more than, exactly or less than 90°, and how many
//! degrees it is.

use super::prelude::*;
use crate::quiz::misconceptions::reasoning;

/// The choices, in their natural order.
const CORNERS: [&str; 3] = ["more than 90°", "exactly 90°", "less than 90°"];
const MORE: usize = 0;
const EXACTLY: usize = 1;
const LESS: usize = 2;

/// The masses in grams and e in tenths: m₁, m₂, e.
type MassesAndLoss = (u32, u32, u32);

/// Equal masses, a heavier striker, and a lighter striker.
const LOSSLESS_PAIRS: [&[MassesAndLoss]; 3] = [
    &[(15, 15, 10), (18, 18, 10), (20, 20, 10)],
    &[(15, 6, 10), (20, 10, 10), (24, 16, 10)],
    &[(10, 20, 10), (12, 18, 10), (20, 40, 10)],
];

/// Equal masses, a heavier striker, and a lighter striker, none of them with m₁ = e m₂.
const LOSSY_PAIRS: [&[MassesAndLoss]; 3] = [
    &[(15, 15, 5), (15, 15, 8), (20, 20, 6)],
    &[(20, 10, 8)],
    &[(10, 20, 9), (10, 30, 6), (15, 30, 8), (20, 40, 9)],
];

/// A lighter striker with m₁ = e m₂, and lighter strikers in collisions whose e is larger or
/// smaller than m₁/m₂.
const NEAR_SQUARE: [&[MassesAndLoss]; 5] = [
    &[(10, 20, 5), (10, 20, 8), (10, 20, 3)],
    &[(12, 20, 6), (12, 20, 9), (12, 20, 3)],
    &[(12, 15, 8), (12, 15, 5)],
    &[(9, 15, 6), (9, 15, 9)],
    &[(6, 15, 4), (6, 15, 2)],
];

pub(super) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    match difficulty {
        Difficulty::Easy => corner(&LOSSLESS_PAIRS, difficulty, dice),
        Difficulty::Middle if dice.coin() => corner(&LOSSY_PAIRS, difficulty, dice),
        Difficulty::Middle => how_wide(NO_LOSS, difficulty, dice),
        Difficulty::Hard if dice.coin() => corner(&NEAR_SQUARE, difficulty, dice),
        Difficulty::Hard => how_wide(&[0.4, 0.5, 0.6, 0.8], difficulty, dice),
    }
}

/// Asks whether the angle is more than, exactly or less than 90°.
fn corner(pairs: &[&[MassesAndLoss]], difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let (m1_g, m2_g, e_tenths) = *dice.pick(&pairs.concat())?;
    let e = f64::from(e_tenths) / 10.0;
    let hit = drawn(pair(m1_g, m2_g), e, difficulty, dice)?;
    // The smaller m₁ is in comparison with e m₂, the larger the angle.
    let right = place((10 * m1_g).cmp(&(e_tenths * m2_g)));
    let lossy = e_tenths < 10;
    let not_here = if m1_g == m2_g {
        "For equal masses the angle is 90° only if no energy is lost. Here some is lost."
    } else if lossy {
        "If energy is lost, the angle is 90° not for equal masses but for m₁ = e m₂. That is not \
         the case here."
    } else {
        "If no energy is lost, the angle is 90° only for equal masses. Here the masses differ."
    };
    let text = format!("{} {}", off_centre(&hit), hit.loss());
    let topic = if lossy {
        "corner-with-loss"
    } else {
        "corner-without-loss"
    };
    let square = right == EXACTLY;
    let (opposite, says) = match m1_g == m2_g {
        true => (LossOpensAngle, CLOSES),
        false => (HeavyRebounds, FOLLOWS_OR_BOUNCES),
    };
    Outline::with_text(&hit, text, unmarked(&hit))
        .topic(topic)
        .ask("What is the angle between their paths after the collision?")
        .options(CORNERS, right)
        .chooses(LossForbidsSquare, (lossy && square).then_some(LESS))
        .says(
            "You assumed that a loss always makes the angle less than 90°. But with a loss, \
             another pair of masses gives 90°.",
        )
        .chooses(AlwaysSquare, EXACTLY)
        .says(not_here)
        .chooses(Lossless, lossy.then(|| place(m1_g.cmp(&m2_g))))
        .says(
            "That is right if no energy is lost. A loss makes the angle smaller, and a larger \
               loss makes it smaller still.",
        )
        .chooses(SpeedOpensAngle, square.then_some(MORE))
        .says(
            "Did you assume that a hard collision makes the angle larger? Speed alone does not \
             change the angle.",
        )
        .chooses(PushedAhead, square.then_some(LESS))
        .says(
            "Did you assume that the striker pushes the coin along the striker's path? Smooth rims \
             exert a force only along the line of impact.",
        )
        .chooses(opposite, (!square).then(|| LESS - right))
        .says(says)
        .why(if lossy {
            lossy_corner(right, &hit)
        } else {
            lossless_corner(right).into()
        })
}

/// Feedback for an answer that assumes that a loss makes the angle larger for equal masses.
const CLOSES: &str = "You assumed that the loss makes the angle larger. But the discs separate \
                      more slowly, so the striker follows the coin.";

/// Feedback for an answer in which a heavier striker rebounds or a lighter striker follows the
/// target.
pub(super) const FOLLOWS_OR_BOUNCES: &str = "You swapped the two cases: a heavier striker follows \
                                             the coin, and a lighter striker rebounds.";

const fn lossless_corner(right: usize) -> &'static str {
    match right {
        MORE => {
            "A lighter striker rebounds along the line of impact, and the coin leaves along the \
             same line. So the angle is more than 90°, at any offset."
        }
        EXACTLY => {
            "With equal masses the striker loses all of its velocity along the line of impact. \
             The rest is perpendicular to that line, and so to the coin's path, at any offset and \
             speed."
        }
        _ => {
            "A heavier striker is not stopped along the line of impact: it follows the coin. So \
             the angle is less than 90°, at any offset."
        }
    }
}

fn lossy_corner(right: usize, hit: &Hit) -> String {
    let (compared, angle) = match right {
        MORE => ("less than", "more than 90°"),
        EXACTLY => ("equal to", "exactly 90°"),
        _ => ("more than", "less than 90°"),
    };
    let ([_, m2], e) = (hit.masses_g(), hit.restitution);
    format!(
        "Along the line of impact the striker's final velocity is proportional to m₁ − e m₂. Here \
         e m₂ = {} × {} g = {} g. As m₁ is {compared} that, the angle is {angle}, at any offset.",
        significant(e),
        significant(m2),
        significant(e * m2)
    )
}

/// Asks for the angle in degrees, with unequal masses.
fn how_wide(restitutions: &[f64], difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let hit = HitDraws(UNEQUAL, 15..=75, restitutions).draw(difficulty, dice)?;
    let alpha = hit.alpha().abs();
    let wide = |hit: &Hit| hit.outcome().separation.map(deg_from_rad);
    let heavy = hit.mass_ratio() > 1.0;
    let topic = if heavy {
        "corner-heavier-striker"
    } else {
        "corner-lighter-striker"
    };
    Outline::about(&hit)
        .topic(topic)
        .ask("What is the angle between their paths after the collision?")
        .number(Measure::Angle, wide(&hit)?)
        .wrong(AlwaysSquare, 90.0)
        .says("Your answer is close to 90°. That requires m₁ = e m₂.")
        .wrong(CopiedAngle, 2.0 * deg_from_rad(alpha))
        .says(twice_alpha(alpha, hit.pieces.target_name()))
        .wrong(HeavyUnmoved, heavy.then_some(deg_from_rad(alpha)))
        .says("You assumed that the striker goes straight on. It is heavier, but it is deflected.")
        .wrong(UpsideDown, wide(&hit.exchanged()))
        .says("You swapped the two masses in the formula.")
        .wrong(Lossless, wide(&hit.with_restitution(1.0)))
        .says(here_e(
            "That is the angle if no energy is lost.",
            hit.restitution,
        ))
        .why(reasoning(&hit))
}

/// Feedback for an answer that is twice the impact angle.
pub(super) fn twice_alpha(alpha: f64, name: &str) -> String {
    format!(
        "Your answer is close to twice {}. But only the {name} leaves at the impact angle.",
        degrees(alpha)
    )
}
