//! What the coefficient of restitution e does: speeds of parting, the corner, and where the
//! right angle is found again.

use serde_json::json;

use super::setting::{
    Asked, Setting, about, more, number, pair, told, unmarked, wrong, wrong_choices,
};
use crate::physics::units::deg_from_rad;
use crate::quiz::dice::Dice;
use crate::quiz::misconceptions::catalogue::{
    E_AS_ENERGY, LOSS_FORBIDS_SQUARE, LOSS_ON_EVERYTHING, UPSIDE_DOWN,
};
use crate::quiz::misconceptions::{ALWAYS_SQUARE, COPIED_ANGLE, LOSSLESS};
use crate::quiz::words::{bare_degrees, degrees, significant};
use crate::quiz::{
    Difficulty, Family, Form, Hit, Illustration, Measure, Pieces, Placement, Question,
};

/// Masses in grams and e in tenths, with m₁ = e m₂: m₁, m₂, e.
const SQUARE: [(u32, u32, u32); 12] = [
    (4, 20, 2),
    (6, 20, 3),
    (6, 15, 4),
    (8, 20, 4),
    (10, 20, 5),
    (12, 24, 5),
    (15, 30, 5),
    (9, 15, 6),
    (12, 20, 6),
    (18, 30, 6),
    (14, 20, 7),
    (16, 20, 8),
];

/// Draws a question.
pub(in crate::quiz) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    match difficulty {
        Difficulty::Easy if dice.coin() => square_again(dice),
        Difficulty::Easy => parting(dice),
        Difficulty::Middle if dice.coin() => striker_for_square(dice),
        Difficulty::Middle => e_for_square(dice),
        Difficulty::Hard if dice.coin() => corner(dice),
        Difficulty::Hard => e_from_angles(dice),
    }
}

/// A hit between two discs of these masses.
fn drawn(pieces: Pieces, restitution: f64, difficulty: Difficulty, dice: &mut Dice) -> Option<Hit> {
    let setting = Setting {
        pieces: &[pieces],
        fives_deg: 20..=70,
        restitutions: &[restitution],
    };
    setting.draw(difficulty, dice)
}

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
    let right = place(0);
    let chosen = [
        (
            &ALWAYS_SQUARE,
            place(1),
            format!(
                "The right angle of equal masses needs that nothing is lost. Here e = {}.",
                significant(e)
            ),
        ),
        (
            &UPSIDE_DOWN,
            place(2),
            "You had it the other way round: a heavier striker closes the corner, and so does \
             loss."
                .into(),
        ),
        (
            &LOSS_FORBIDS_SQUARE,
            place(3),
            "You took it that loss forbids the right angle. It only asks for other masses.".into(),
        ),
    ];
    let square_g = significant(e * f64::from(coin_g));
    let asked = Asked {
        family: Family::Restitution,
        difficulty: Difficulty::Easy,
        topic: "square-in-spite-of-loss".into(),
        ask: "With which striker do the two part at exactly 90°?".into(),
        form: Form::Choice {
            options: order.iter().map(|i| STRIKERS[*i].to_owned()).collect(),
            right,
        },
        beliefs: wrong_choices(right, chosen),
        why: format!(
            "The corner is square when the striker stops along the line of impact. With loss it \
             still follows an equal coin; one of m₁ = e m₂ = {square_g} g just stops."
        ),
        more: more([("asked", json!("striker"))]),
    };
    let text = format!(
        "Smooth discs meet off-centre, the coin of {} g at rest. Some energy is lost: e = {}.",
        significant(f64::from(coin_g)),
        significant(e)
    );
    Some(told(&hit, &text, Illustration::Nothing, asked))
}

/// An e from 0.2 to 0.8.
fn tenths(dice: &mut Dice) -> Option<f64> {
    let tenths = *dice.pick(&[2, 3, 4, 5, 6, 7, 8])?;
    Some(f64::from(tenths) / 10.0)
}

/// e is asked for.
fn asks_e(e: f64) -> Form {
    Form::Number {
        quantity: Measure::Restitution,
        truth: e,
    }
}

/// e from the speeds after a head-on hit of equal masses.
fn parting(dice: &mut Dice) -> Option<Question> {
    let e = tenths(dice)?;
    let hit = Hit {
        given: Placement::Angle { alpha_deg: 0.0 },
        ..drawn(Pieces::Equal, e, Difficulty::Easy, dice)?
    };
    let outcome = hit.outcome();
    let (u, v1, v2) = (hit.speed, outcome.v1.length(), outcome.v2.length());
    let form = asks_e(e);
    let beliefs = wrong(
        &form,
        [
            number(
                &E_AS_ENERGY,
                (v1 * v1 + v2 * v2) / (u * u),
                "That is the share of the energy that is left. e compares speeds: how they part \
                 and how they met."
                    .into(),
            ),
            number(
                &LOSS_ON_EVERYTHING,
                v2 / u,
                "You compared the coin's speed with the striker's before. e compares how fast the \
                 two part from each other."
                    .into(),
            ),
            number(
                &LOSSLESS,
                1.0,
                "e = 1 is a hit without loss: the striker would have stopped.".into(),
            ),
        ],
    );
    let [u_words, v1_words, v2_words] = [u, v1, v2].map(significant);
    let asked = Asked {
        family: Family::Restitution,
        difficulty: Difficulty::Easy,
        topic: "e-head-on".into(),
        ask: "What is e?".into(),
        form,
        beliefs,
        why: format!(
            "They part at {v2_words} - {v1_words} = {} m/s and met at {u_words} m/s. e is the \
             one over the other: {}.",
            significant(v2 - v1),
            significant(e)
        ),
        more: more([("asked", json!("e head-on"))]),
    };
    let text = format!(
        "A striker hits a resting coin of the same mass head-on at {u_words} m/s. After it the \
         striker goes on at {v1_words} m/s, the coin at {v2_words} m/s."
    );
    Some(told(&hit, &text, unmarked(&hit), asked))
}

/// The striker's mass that brings the right angle back.
fn striker_for_square(dice: &mut Dice) -> Option<Question> {
    let &(m1_g, m2_g, e_tenths) = dice.pick(&SQUARE)?;
    let (m1, m2, e) = (f64::from(m1_g), f64::from(m2_g), f64::from(e_tenths) / 10.0);
    let hit = drawn(pair(m1_g, m2_g), e, Difficulty::Middle, dice)?;
    let form = Form::Number {
        quantity: Measure::Mass,
        truth: m1,
    };
    let [e_words, m2_words] = [e, m2].map(significant);
    let beliefs = wrong(
        &form,
        [
            number(
                &ALWAYS_SQUARE,
                m2,
                format!("Equal masses part at 90° when nothing is lost. Here e = {e_words}."),
            ),
            number(
                &UPSIDE_DOWN,
                m2 / e,
                "You had it the other way round: a heavier striker closes the corner, and so does \
                 loss."
                    .into(),
            ),
            number(
                &E_AS_ENERGY,
                e.sqrt() * m2,
                "You took the root of e, as if it were a share of energy. e compares speeds."
                    .into(),
            ),
        ],
    );
    let asked = Asked {
        family: Family::Restitution,
        difficulty: Difficulty::Middle,
        topic: "square-in-spite-of-loss".into(),
        ask: "With which mass of the striker do they part at exactly 90°?".into(),
        form,
        beliefs,
        why: format!(
            "Square means that the striker stops along the line of impact, where it is left with \
             m₁ - e m₂. So m₁ = e m₂ = {} g.",
            significant(m1)
        ),
        more: more([("asked", json!("striker mass"))]),
    };
    let text = format!(
        "Smooth discs meet off-centre, the coin of {m2_words} g at rest. Some energy is lost: \
         e = {e_words}."
    );
    Some(told(&hit, &text, Illustration::Nothing, asked))
}

/// The e that brings the right angle to two masses.
fn e_for_square(dice: &mut Dice) -> Option<Question> {
    let &(m1_g, m2_g, e_tenths) = dice.pick(&SQUARE)?;
    let e = f64::from(e_tenths) / 10.0;
    let hit = drawn(pair(m1_g, m2_g), e, Difficulty::Middle, dice)?;
    let form = asks_e(e);
    let beliefs = wrong(
        &form,
        [
            number(
                &LOSS_FORBIDS_SQUARE,
                1.0,
                "You took it that only a hit without loss can be square. With a lighter striker \
                 it needs some loss."
                    .into(),
            ),
            number(
                &E_AS_ENERGY,
                e * e,
                "You squared the ratio, as if e were a share of energy. e compares speeds.".into(),
            ),
            number(
                &LOSS_ON_EVERYTHING,
                1.0 - e,
                "That is what is missing of the ratio of masses. e is the ratio itself.".into(),
            ),
        ],
    );
    let [m1, m2] = [m1_g, m2_g].map(|mass_g| significant(f64::from(mass_g)));
    let asked = Asked {
        family: Family::Restitution,
        difficulty: Difficulty::Middle,
        topic: "e-for-square".into(),
        ask: "They part at exactly 90°. What is e?".into(),
        form,
        beliefs,
        why: format!(
            "Square means that the striker stops along the line of impact, where it is left with \
             m₁ - e m₂. So e = m₁ / m₂ = {}.",
            significant(e)
        ),
        more: more([("asked", json!("e square"))]),
    };
    let text = format!(
        "A smooth striker of {m1} g hits a resting coin of {m2} g off-centre at {} m/s.",
        significant(hit.speed)
    );
    Some(told(&hit, &text, unmarked(&hit), asked))
}

/// How far loss closes the corner of equal masses.
fn corner(dice: &mut Dice) -> Option<Question> {
    let e = f64::from(*dice.pick(&[2, 3, 4, 5, 6, 7])?) / 10.0;
    let hit = drawn(Pieces::Equal, e, Difficulty::Hard, dice)?;
    let alpha = hit.alpha().abs();
    let separation = |e: f64| {
        let hit = Hit {
            restitution: e,
            ..hit
        };
        hit.outcome().separation.map(deg_from_rad)
    };
    let form = Form::Number {
        quantity: Measure::Angle,
        truth: separation(e)?,
    };
    let beliefs = wrong(
        &form,
        [
            number(
                &ALWAYS_SQUARE,
                90.0,
                format!(
                    "The right angle of equal masses needs that nothing is lost. Here e = {}.",
                    significant(e)
                ),
            ),
            number(
                &LOSS_ON_EVERYTHING,
                90.0 * e,
                "You multiplied the right angle itself by e. But e works along the line of \
                 impact alone."
                    .into(),
            ),
            number(
                &COPIED_ANGLE,
                2.0 * deg_from_rad(alpha),
                format!(
                    "You took twice {}. But only the coin leaves at the impact angle.",
                    degrees(alpha)
                ),
            ),
            number(
                &UPSIDE_DOWN,
                180.0 - separation(e)?,
                "You opened the corner by as much as loss closes it.".into(),
            ),
        ],
    );
    let left = 0.5 * (1.0 - e) * alpha.cos();
    let asked = Asked {
        family: Family::Restitution,
        difficulty: Difficulty::Hard,
        topic: "corner-with-loss".into(),
        ask: "How many degrees apart do they leave?".into(),
        form,
        beliefs,
        why: format!(
            "Of its speed the striker keeps sin {} = {} across the line and (1 - e) / 2 cos {0} = \
             {} along it, the coin's way. The one over the other is the tangent of {}.",
            bare_degrees(alpha),
            significant(alpha.sin()),
            significant(left),
            degrees(separation(e)?.to_radians())
        ),
        more: more([("asked", json!("separation"))]),
    };
    Some(about(&hit, asked))
}

/// e from the two angles after a hit, the masses being known.
fn e_from_angles(dice: &mut Dice) -> Option<Question> {
    let e = tenths(dice)?;
    let (m1_g, m2_g) = *dice.pick(&[(15, 15), (20, 20), (15, 10), (20, 15), (10, 15), (15, 20)])?;
    let hit = drawn(pair(m1_g, m2_g), e, Difficulty::Hard, dice)?;
    let outcome = hit.outcome();
    let (theta1, theta2) = (outcome.theta1?.abs(), outcome.theta2?.abs());
    let (m1, m2) = (f64::from(m1_g), f64::from(m2_g));
    let k = (1.0 + e) * m2 / (m1 + m2);
    let form = asks_e(e);
    let beliefs = wrong(
        &form,
        [
            number(
                &E_AS_ENERGY,
                outcome.energy_after / outcome.energy_before,
                "That is the share of the energy that is left. e compares speeds along the line \
                 of impact."
                    .into(),
            ),
            number(
                &UPSIDE_DOWN,
                k * (m1 + m2) / m1 - 1.0,
                "You had the two masses the other way round.".into(),
            ),
            number(
                &LOSSLESS,
                1.0,
                "Without loss these masses would part at another angle.".into(),
            ),
        ],
    );
    let [m1_words, m2_words] = [m1, m2].map(significant);
    let asked = Asked {
        family: Family::Restitution,
        difficulty: Difficulty::Hard,
        topic: "e-from-angles".into(),
        ask: "What is e?".into(),
        form,
        beliefs,
        why: format!(
            "Along the line the striker gives up k = sin θ₁ / (cos θ₂ sin(θ₁ + θ₂)) = {} of its \
             speed. k is (1 + e) m₂ / (m₁ + m₂), so e = {}.",
            significant(k),
            significant(e)
        ),
        more: more([("asked", json!("e angles"))]),
    };
    let text = format!(
        "A smooth striker of {m1_words} g hit a resting coin of {m2_words} g. It left {} off its \
         way (θ₁), the coin {} off to the other side (θ₂).",
        degrees(theta1),
        degrees(theta2)
    );
    let seen = Illustration::After {
        collision: hit.collision(),
    };
    Some(told(&hit, &text, seen, asked))
}
