//! A mass from what is seen after the hit: which is the heavier, and how heavy it is.

use std::cmp::Ordering;

use serde_json::json;

use super::setting::{Asked, Setting, more, number, pair, told, wrong, wrong_choices};
use crate::physics::resting_target::{k_from_angles, mass_ratio_from_angles};
use crate::quiz::dice::Dice;
use crate::quiz::misconceptions::catalogue::{
    DOUBLE_ANGLE_FORGOTTEN, SCALAR_MOMENTUM, SINE_COSINE, UPSIDE_DOWN,
};
use crate::quiz::misconceptions::{HEAVY_UNMOVED, LOSSLESS};
use crate::quiz::words::{degrees, significant, tenths};
use crate::quiz::{Difficulty, Family, Form, Hit, Illustration, Measure, Question};

/// The choices, in their natural order.
const WEIGHTS: [&str; 3] = [
    "lighter than the striker",
    "as heavy as the striker",
    "heavier than the striker",
];
const LIGHTER: usize = 0;
const ALIKE: usize = 1;
const HEAVIER: usize = 2;

/// Masses of coins in grams, to be weighed by a striker of 15 g.
const COINS_G: [u32; 10] = [5, 6, 8, 10, 12, 18, 20, 25, 30, 40];
const STRIKER_G: u32 = 15;

/// Draws a question.
pub(in crate::quiz) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    match difficulty {
        Difficulty::Easy => which(dice),
        Difficulty::Middle => by_momentum(dice),
        Difficulty::Hard => by_angles(dice),
    }
}

/// A hit seen from the outside.
struct Seen {
    hit: Hit,
    coin_g: f64,
    theta1: f64,
    theta2: f64,
}

impl Seen {
    fn draw(
        coins_g: &[u32],
        restitutions: &[f64],
        difficulty: Difficulty,
        dice: &mut Dice,
    ) -> Option<Self> {
        let coin_g = *dice.pick(coins_g)?;
        let setting = Setting {
            pieces: &[pair(STRIKER_G, coin_g)],
            fives_deg: 20..=70,
            restitutions,
        };
        let hit = setting.draw(difficulty, dice)?;
        let outcome = hit.outcome();
        Some(Self {
            hit,
            coin_g: f64::from(coin_g),
            theta1: outcome.theta1?.abs(),
            theta2: outcome.theta2?.abs(),
        })
    }

    fn picture(&self) -> Illustration {
        Illustration::After {
            collision: self.hit.collision(),
        }
    }

    /// What was seen, in words.
    fn words(&self, striker: &str) -> String {
        format!(
            "{striker} hit a resting coin. It left {} off its way (θ₁), the coin {} off to the \
             other side (θ₂).",
            degrees(self.theta1),
            degrees(self.theta2)
        )
    }

    /// The mass of the coin to be found.
    fn form(&self) -> Form {
        Form::Number {
            quantity: Measure::Mass,
            truth: self.coin_g,
        }
    }
}

const STRIKER: f64 = STRIKER_G as f64;

/// How the coin compares with the striker.
const fn weight(coin: Ordering) -> usize {
    match coin {
        Ordering::Less => LIGHTER,
        Ordering::Equal => ALIKE,
        Ordering::Greater => HEAVIER,
    }
}

/// Which of the two is the heavier, from the corner.
fn which(dice: &mut Dice) -> Option<Question> {
    let alike = dice.below(3) == 0;
    let coins_g: &[u32] = if alike { &[STRIKER_G] } else { &COINS_G };
    let seen = Seen::draw(coins_g, &[1.0], Difficulty::Easy, dice)?;
    let right = weight(seen.coin_g.total_cmp(&STRIKER));
    let turned_less = weight(tenths(seen.theta1).cmp(&tenths(seen.theta2)));
    if right == ALIKE && turned_less == ALIKE {
        // Whoever compares the two angles is right by accident.
        return None;
    }
    let chosen = [
        (
            &HEAVY_UNMOVED,
            turned_less,
            "You took the one that is turned less for the heavier. How far each is turned depends \
             on the offset, too."
                .into(),
        ),
        (
            &UPSIDE_DOWN,
            HEAVIER - right,
            "You had it the other way round: a heavier striker follows the coin, a lighter one \
             bounces off."
                .into(),
        ),
    ];
    let sum = degrees(seen.theta1 + seen.theta2);
    let why = match right {
        LIGHTER => format!(
            "Together that is {sum}, less than 90°: the striker still followed the coin along the \
             line of impact. So it is the heavier."
        ),
        ALIKE => format!(
            "Together that is {sum}. A right angle without loss means equal masses, whatever the \
             offset."
        ),
        _ => format!(
            "Together that is {sum}, more than 90°: the striker bounced back along the line of \
             impact. So the coin is the heavier."
        ),
    };
    let asked = Asked {
        family: Family::Weigh,
        difficulty: Difficulty::Easy,
        topic: "which-is-heavier".into(),
        ask: "No energy was lost. What is the coin?".into(),
        form: Form::Choice {
            options: WEIGHTS.map(str::to_owned).into(),
            right,
        },
        beliefs: wrong_choices(right, chosen),
        why,
        more: more([("asked", json!("which"))]),
    };
    Some(told(
        &seen.hit,
        &seen.words("A smooth striker"),
        seen.picture(),
        asked,
    ))
}

/// The mass of the coin by the momentum across the striker's way: angles and speeds.
fn by_momentum(dice: &mut Dice) -> Option<Question> {
    let seen = Seen::draw(&COINS_G, &[1.0], Difficulty::Middle, dice)?;
    let outcome = seen.hit.outcome();
    let (v1, v2) = (outcome.v1.length(), outcome.v2.length());
    let (theta1, theta2) = (seen.theta1, seen.theta2);
    let form = seen.form();
    let beliefs = wrong(
        &form,
        [
            number(
                &SCALAR_MOMENTUM,
                STRIKER * (seen.hit.speed - v1) / v2,
                "You added the momenta like plain numbers. They point different ways: across the \
                 way they cancel."
                    .into(),
            ),
            number(
                &UPSIDE_DOWN,
                STRIKER * STRIKER / seen.coin_g,
                "You had the ratio of the masses upside down.".into(),
            ),
            number(
                &SINE_COSINE,
                (STRIKER * v1 * theta1.cos() / (v2 * theta2.cos())).abs(),
                "You took the parts along the way, with cosines. It is those across that cancel: \
                 sines."
                    .into(),
            ),
        ],
    );
    let across = STRIKER * v1 * theta1.sin();
    let asked = Asked {
        family: Family::Weigh,
        difficulty: Difficulty::Middle,
        topic: "mass-from-momentum".into(),
        ask: format!(
            "Speeds: {} m/s before, then {} m/s, the coin {} m/s. Its mass?",
            significant(seen.hit.speed),
            significant(v1),
            significant(v2)
        ),
        form,
        beliefs,
        why: format!(
            "Across the way there was no momentum, so both parts are alike: m₁ v₁ sin θ₁ = {} g \
             m/s = m₂ v₂ sin θ₂. So m₂ = {} / {} = {} g.",
            significant(across),
            significant(across),
            significant(v2 * theta2.sin()),
            significant(seen.coin_g)
        ),
        more: more([("asked", json!("momentum"))]),
    };
    let striker = format!("A striker of {} g", significant(STRIKER));
    Some(told(
        &seen.hit,
        &seen.words(&striker),
        seen.picture(),
        asked,
    ))
}

/// The mass of the coin by the two angles alone.
fn by_angles(dice: &mut Dice) -> Option<Question> {
    let restitutions = [1.0, 1.0, 0.8, 0.6, 0.5];
    let seen = Seen::draw(&COINS_G, &restitutions, Difficulty::Hard, dice)?;
    let (theta1, theta2, e) = (seen.theta1, seen.theta2, seen.hit.restitution);
    let k = k_from_angles(theta1, theta2)?;
    let lossless = mass_ratio_from_angles(theta1, theta2, 1.0)?;
    let form = seen.form();
    let beliefs = wrong(
        &form,
        [
            number(
                &UPSIDE_DOWN,
                STRIKER * STRIKER / seen.coin_g,
                "You had the ratio of the masses upside down.".into(),
            ),
            number(
                &LOSSLESS,
                STRIKER / lossless,
                format!(
                    "That is the mass if nothing is lost. Here e = {}.",
                    significant(e)
                ),
            ),
            number(
                &DOUBLE_ANGLE_FORGOTTEN,
                STRIKER * theta1.sin() / (theta1 + theta2).sin(),
                "You took θ₂ once where it stands twice: seen from the centre of mass the line \
                 turns by twice the angle."
                    .into(),
            ),
        ],
    );
    let why = if e < 1.0 {
        format!(
            "k = sin θ₁ / (cos θ₂ sin(θ₁ + θ₂)) = {} is what the striker gives up along the line. \
             It is (1 + e) m₂ / (m₁ + m₂), so m₂ = {} g.",
            significant(k),
            significant(seen.coin_g)
        )
    } else {
        format!(
            "Without loss m₁ / m₂ = sin(θ₁ + 2 θ₂) / sin θ₁ = {}. So m₂ = {} / {0} = {} g.",
            significant(lossless),
            significant(STRIKER),
            significant(seen.coin_g)
        )
    };
    let asked = Asked {
        family: Family::Weigh,
        difficulty: Difficulty::Hard,
        topic: "mass-from-angles".into(),
        ask: if e < 1.0 {
            format!("e = {}. What is the coin's mass?", significant(e))
        } else {
            "No energy was lost. What is the coin's mass?".into()
        },
        form,
        beliefs,
        why,
        more: more([("asked", json!("angles"))]),
    };
    let striker = format!("A smooth striker of {} g", significant(STRIKER));
    Some(told(
        &seen.hit,
        &seen.words(&striker),
        seen.picture(),
        asked,
    ))
}
