//! The corner that the two ways out make: more, exactly or less than 90°, and how many
//! degrees.

use super::prelude::*;
use crate::quiz::misconceptions::reasoning;

/// The choices, in their natural order.
const CORNERS: [&str; 3] = ["more than 90°", "exactly 90°", "less than 90°"];
const MORE: usize = 0;
const EXACTLY: usize = 1;
const LESS: usize = 2;

/// Masses in grams and e in tenths: m₁, m₂, e.
type MassesAndLoss = (u32, u32, u32);

/// Alike, with a heavier striker, and with a lighter one.
const LOSSLESS_PAIRS: [&[MassesAndLoss]; 3] = [
    &[(15, 15, 10), (18, 18, 10), (20, 20, 10)],
    &[(15, 6, 10), (20, 10, 10), (24, 16, 10)],
    &[(10, 20, 10), (12, 18, 10), (20, 40, 10)],
];

/// The same, far from m₁ = e m₂.
const LOSSY_PAIRS: [&[MassesAndLoss]; 3] = [
    &[(15, 15, 5), (15, 15, 8), (20, 20, 6)],
    &[(20, 10, 8)],
    &[(10, 20, 9), (10, 30, 6), (15, 30, 8), (20, 40, 9)],
];

/// A lighter striker, at m₁ = e m₂ and to both sides of it.
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

/// More, exactly or less than 90°.
fn corner(pairs: &[&[MassesAndLoss]], difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let (m1_g, m2_g, e_tenths) = *dice.pick(&pairs.concat())?;
    let e = f64::from(e_tenths) / 10.0;
    let hit = drawn(pair(m1_g, m2_g), e, difficulty, dice)?;
    // The lighter the striker against e times the target, the wider.
    let right = place((10 * m1_g).cmp(&(e_tenths * m2_g)));
    let lossy = e_tenths < 10;
    let not_here = if m1_g == m2_g {
        "Equal masses part at a right angle if no energy is lost. Here some is."
    } else if lossy {
        "With loss it is not equal masses that part at a right angle, but m₁ = e m₂. These \
         two do not fit that."
    } else {
        "The right angle without loss is that of equal masses. Here they differ."
    };
    let text = format!("{} {}", off_centre(&hit), hit.loss());
    let topic = if lossy {
        "corner-with-loss"
    } else {
        "corner-without-loss"
    };
    let square = right == EXACTLY;
    Outline::told(&hit, text, unmarked(&hit))
        .topic(topic)
        .ask("How large is the angle between their paths after the hit?")
        .options(CORNERS, right)
        .chooses(LossForbidsSquare, (lossy && square).then_some(LESS))
        .says(
            "You thought that loss always makes it less than a right angle. It moves the right \
             angle to another pair of masses.",
        )
        .chooses(AlwaysSquare, EXACTLY)
        .says(not_here)
        .chooses(Lossless, lossy.then(|| place(m1_g.cmp(&m2_g))))
        .says("That is so without loss. Loss makes the angle smaller, and more loss makes it smaller still.")
        .chooses(SpeedOpensAngle, square.then_some(MORE))
        .says("Does a hard hit drive them wider apart? Speed alone changes no angle.")
        .chooses(PushedAhead, square.then_some(LESS))
        .says(
            "Does the striker push the coin along with it? A smooth rim pushes along the line of \
             impact alone.",
        )
        .chooses(
            (m1_g != m2_g).then_some(UpsideDown),
            (!square).then(|| LESS - right),
        )
        .says(if m1_g == m2_g {
            CLOSES
        } else {
            FOLLOWS_OR_BOUNCES
        })
        .why(if lossy {
            lossy_corner(right, e * f64::from(m2_g), f64::from(m1_g))
        } else {
            lossless_corner(right).into()
        })
}

/// Of whoever lets loss widen the angle between equal masses.
const CLOSES: &str = "You let the loss widen the angle between the paths. It narrows it: the two \
                      spring apart less, so the striker keeps some speed along the line of impact \
                      and follows the coin.";

/// Of whoever has the masses upside down.
pub(super) const FOLLOWS_OR_BOUNCES: &str = "You had it the other way round: a heavier striker \
                                             follows the coin, a lighter one bounces off.";

const fn lossless_corner(right: usize) -> &'static str {
    match right {
        MORE => {
            "A lighter striker bounces back along the line of impact, and the coin leaves along \
             it. That makes the angle larger: more than 90°, at any offset."
        }
        EXACTLY => {
            "With equal masses the striker gives up all it has along the line of impact. What it \
             keeps lies across, at right angles to the coin's path, at any offset and speed."
        }
        _ => {
            "A heavier striker is not stopped along the line of impact: it follows the coin. That \
             makes the angle smaller: less than 90°, at any offset."
        }
    }
}

fn lossy_corner(right: usize, lossy_target_g: f64, striker_g: f64) -> String {
    let (sign, follows) = match right {
        MORE => ("less than", "bounces back: more than 90°"),
        EXACTLY => ("just as much as", "stops: exactly 90°"),
        _ => ("more than", "goes on: less than 90°"),
    };
    format!(
        "Compare m₁ with e m₂, for along the line m₁ - e m₂ decides. {} g is {sign} {} g, so \
         there the striker {follows}, at any offset.",
        significant(striker_g),
        significant(lossy_target_g)
    )
}

/// How many degrees, with unequal masses.
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
        .ask("How many degrees apart do they leave?")
        .number(Measure::Angle, wide(&hit)?)
        .wrong(AlwaysSquare, 90.0)
        .says("You made it a right angle. That takes m₁ = e m₂: without loss, equal masses.")
        .wrong(CopiedAngle, 2.0 * deg_from_rad(alpha))
        .says(twice_alpha(alpha, hit.pieces.target_name()))
        .wrong(HeavyUnmoved, heavy.then_some(deg_from_rad(alpha)))
        .says("You sent the striker straight on. It is heavier, yet it is turned.")
        .wrong(UpsideDown, wide(&hit.exchanged()))
        .says("That is so with the two masses exchanged.")
        .wrong(Lossless, wide(&hit.with_restitution(1.0)))
        .says(here_e("That is the angle without loss.", hit.restitution))
        .why(reasoning(&hit))
}

/// Of whoever takes twice the impact angle for the corner.
pub(super) fn twice_alpha(alpha: f64, name: &str) -> String {
    format!(
        "You took twice {}. But only the {name} leaves at the impact angle.",
        degrees(alpha)
    )
}
