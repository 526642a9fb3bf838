//! How fast one of the two leaves, from the speed before and the impact angle.

use serde_json::json;

use super::setting::{Asked, Setting, about, more, number, sine_for_cosine, wrong};
use crate::quiz::dice::Dice;
use crate::quiz::misconceptions::LOSSLESS;
use crate::quiz::misconceptions::catalogue::{
    LOSS_ON_EVERYTHING, ONE_LINE_FORMULA, SINE_COSINE, SPEEDS_ADD, UPSIDE_DOWN,
};
use crate::quiz::words::{bare_degrees, significant};
use crate::quiz::{Difficulty, Family, Form, Hit, Measure, Pieces, Question};

const UNEQUAL: [Pieces; 2] = [Pieces::Tournament, Pieces::Marbles];

/// Draws a question.
pub(in crate::quiz) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let (pieces, restitutions): (&[Pieces], &[f64]) = match difficulty {
        Difficulty::Easy => (&[Pieces::Equal], &[1.0]),
        Difficulty::Middle => (&UNEQUAL, &[1.0]),
        Difficulty::Hard => (&UNEQUAL, &[0.4, 0.5, 0.6, 0.8]),
    };
    let setting = Setting {
        pieces,
        fives_deg: 15..=75,
        restitutions,
    };
    let hit = setting.draw(difficulty, dice)?;
    Some(match difficulty {
        Difficulty::Easy if dice.coin() => striker(&hit, difficulty),
        _ => target(&hit, difficulty),
    })
}

/// The struck disc's speed: the head-on formula, for the part along the line of impact.
fn target(hit: &Hit, difficulty: Difficulty) -> Question {
    let name = hit.pieces.target_name();
    let (u, alpha, e) = (hit.speed, hit.alpha().abs(), hit.restitution);
    let (m1, m2) = (hit.pieces.striker().mass, hit.pieces.target().mass);
    // (1 + e) m₁ / (m₁ + m₂)
    let gain = |m: f64, e: f64| (1.0 + e) * m / (m1 + m2);
    let along = u * alpha.cos();
    let truth = gain(m1, e) * along;
    let form = Form::Number {
        quantity: Measure::Speed,
        truth,
    };
    let lossless = gain(m1, 1.0) * along;
    let equal = hit.mass_ratio().total_cmp(&1.0).is_eq();
    let beliefs = wrong(
        &form,
        [
            sine_for_cosine(gain(m1, e) * u * alpha.sin(), name),
            number(
                &ONE_LINE_FORMULA,
                gain(m1, e) * u,
                format!(
                    "You used the formula of a head-on hit on the whole {} m/s. Only the part \
                     along the line of impact takes part.",
                    significant(u)
                ),
            ),
            equal.then_some(()).and_then(|()| {
                number(
                    &SPEEDS_ADD,
                    u * (1.0 - alpha.sin()),
                    "You took what the striker keeps off the speed before. Speeds do not add \
                     up so: they are the sides of a triangle."
                        .into(),
                )
            }),
            number(
                &UPSIDE_DOWN,
                gain(m2, e) * along,
                "You had the masses the other way round: a heavier striker gives the more \
                 speed."
                    .into(),
            ),
            number(
                &LOSSLESS,
                lossless,
                format!(
                    "That is the speed without loss. Here e = {}.",
                    significant(e)
                ),
            ),
            number(
                &LOSS_ON_EVERYTHING,
                e * lossless,
                "You multiplied the speed without loss by e. But e makes them part more \
                 slowly; it does not shrink each speed."
                    .into(),
            ),
        ],
    );
    let part = format!(
        "Along the line of impact the striker brings {} cos {} = {} m/s.",
        significant(u),
        bare_degrees(alpha),
        significant(along)
    );
    let share = if equal && e >= 1.0 {
        format!("With equal masses and no loss the {name} takes all of it.")
    } else {
        format!(
            "The {name} leaves with (1 + e) m₁ / (m₁ + m₂) = {} times that: {} m/s.",
            significant(gain(m1, e)),
            significant(truth)
        )
    };
    let asked = Asked {
        family: Family::Speeds,
        difficulty,
        topic: "target-speed".into(),
        ask: format!("How fast does the {name} leave?"),
        form,
        beliefs,
        why: format!("{part} {share}"),
        more: more([("asked", json!("target"))]),
    };
    about(hit, asked)
}

/// The striker's speed, equal masses: the part across the line of impact, which is all
/// that it keeps.
fn striker(hit: &Hit, difficulty: Difficulty) -> Question {
    let (u, alpha) = (hit.speed, hit.alpha().abs());
    let truth = u * alpha.sin();
    let form = Form::Number {
        quantity: Measure::Speed,
        truth,
    };
    let beliefs = wrong(
        &form,
        [
            number(
                &SINE_COSINE,
                u * alpha.cos(),
                "You took the cosine for the sine. Head-on the striker keeps nothing.".into(),
            ),
            number(
                &SPEEDS_ADD,
                u * (1.0 - alpha.cos()),
                "You took the coin's speed off the speed before. Speeds do not add up so: they \
                 are the sides of a triangle."
                    .into(),
            ),
            number(
                &ONE_LINE_FORMULA,
                0.0,
                "You stopped the striker as in a head-on hit. Its part across the line of impact \
                 is not touched."
                    .into(),
            ),
        ],
    );
    let asked = Asked {
        family: Family::Speeds,
        difficulty,
        topic: "striker-speed".into(),
        ask: "How fast does the striker go on?".into(),
        form,
        beliefs,
        why: format!(
            "With equal masses and no loss the striker gives up all it had along the line of \
             impact. It keeps the part across: {} sin {} = {} m/s.",
            significant(u),
            bare_degrees(alpha),
            significant(truth)
        ),
        more: more([("asked", json!("striker"))]),
    };
    about(hit, asked)
}
