//! What share of the striker's energy each one has after the hit, and what share is lost.

use serde_json::json;

use super::setting::{Asked, Setting, about, more, number, pair, sine_for_cosine, wrong};
use crate::physics::RestingTarget;
use crate::quiz::dice::Dice;
use crate::quiz::misconceptions::catalogue::{
    E_AS_ENERGY, ENERGY_AS_SPEED, HEAVY_TAKES_ENERGY, LOSS_ON_EVERYTHING, SINE_COSINE,
};
use crate::quiz::misconceptions::{HALF_AND_HALF, LOSSLESS};
use crate::quiz::words::{bare_degrees, significant};
use crate::quiz::{Difficulty, Family, Form, Hit, Measure, Pieces, Question};

/// Draws a question.
pub(in crate::quiz) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let unequal = [
        Pieces::Tournament,
        Pieces::Marbles,
        pair(20, 10),
        pair(10, 30),
    ];
    let (pieces, restitutions): (&[Pieces], &[f64]) = match difficulty {
        Difficulty::Easy => (&[Pieces::Equal], &[1.0]),
        Difficulty::Middle => (&unequal, &[1.0]),
        Difficulty::Hard => (
            &[Pieces::Equal, Pieces::Tournament, Pieces::Marbles],
            &[0.2, 0.3, 0.4, 0.5, 0.6],
        ),
    };
    let setting = Setting {
        pieces,
        fives_deg: 15..=75,
        restitutions,
    };
    let hit = setting.draw(difficulty, dice)?;
    match difficulty {
        Difficulty::Easy if dice.coin() => kept(&hit, difficulty),
        Difficulty::Hard if dice.coin() => lost(&hit, difficulty),
        _ => passed(&hit, difficulty),
    }
}

const PERCENT: f64 = 100.0;

/// A share asked for.
fn share(truth: f64) -> Form {
    Form::Number {
        quantity: Measure::Share,
        truth: PERCENT * truth,
    }
}

/// A share of a belief, in percent.
fn percent(x: f64) -> String {
    Measure::Share.print(PERCENT * x)
}

/// What the striker keeps, equal masses.
fn kept(hit: &Hit, difficulty: Difficulty) -> Option<Question> {
    let alpha = hit.alpha().abs();
    let (sin, cos) = alpha.sin_cos();
    let truth = RestingTarget::from(&hit.collision())
        .energy_shares(alpha)
        .kept;
    let form = share(truth);
    let beliefs = wrong(
        &form,
        [
            number(
                &ENERGY_AS_SPEED,
                PERCENT * sin,
                format!(
                    "{} is its share of the speed. Energy goes with the square.",
                    percent(sin)
                ),
            ),
            number(
                &SINE_COSINE,
                PERCENT * cos * cos,
                "That is the coin's share. Head-on the striker keeps nothing: a sine.".into(),
            ),
            half(),
        ],
    );
    let asked = Asked {
        family: Family::EnergyShare,
        difficulty,
        topic: "energy-of-striker".into(),
        ask: "What share of its energy does it keep?".into(),
        form,
        beliefs,
        why: format!(
            "The striker keeps the part of its speed across the line of impact, sin {} = {}. \
             Squared, that is {} of the energy.",
            bare_degrees(alpha),
            significant(sin),
            percent(truth)
        ),
        more: more([("asked", json!("kept"))]),
    };
    Some(about(hit, asked))
}

/// Half of the energy to each.
fn half() -> Option<crate::quiz::WrongAnswer> {
    number(
        &HALF_AND_HALF,
        50.0,
        "You shared it out in halves. That is so at 45° alone, and with equal masses.".into(),
    )
}

/// What the struck disc takes.
fn passed(hit: &Hit, difficulty: Difficulty) -> Option<Question> {
    let name = hit.pieces.target_name();
    let collision = hit.collision();
    let alpha = hit.alpha().abs();
    let masses = RestingTarget::from(&collision);
    let truth = masses.energy_shares(alpha).passed;
    let lossless = RestingTarget {
        restitution: 1.0,
        ..masses
    };
    let without_loss = lossless.energy_shares(alpha).passed;
    let (e, speed) = (hit.restitution, masses.target_speed(alpha));
    let equal = hit.mass_ratio().total_cmp(&1.0).is_eq();
    let form = share(truth);
    let beliefs = wrong(
        &form,
        [
            number(
                &ENERGY_AS_SPEED,
                PERCENT * speed,
                format!(
                    "{} is its speed against the striker's. Energy goes with the square, and with \
                     the mass.",
                    percent(speed)
                ),
            ),
            sine_for_cosine(PERCENT * truth * alpha.tan().powi(2), name),
            if equal {
                half()
            } else {
                number(
                    &HEAVY_TAKES_ENERGY,
                    PERCENT * masses.m2 / (masses.m1 + masses.m2),
                    "You shared the energy out by mass. The hit shares out momentum, not energy."
                        .into(),
                )
            },
            number(
                &LOSSLESS,
                PERCENT * without_loss,
                format!("That is so without loss. Here e = {}.", significant(e)),
            ),
            number(
                &E_AS_ENERGY,
                PERCENT * e * without_loss,
                "You took e as a share of energy. It compares speeds of parting and of meeting."
                    .into(),
            ),
            number(
                &LOSS_ON_EVERYTHING,
                PERCENT * e * e * without_loss,
                "You multiplied the speed without loss by e. But e makes them part more \
                 slowly; it does not shrink each speed."
                    .into(),
            ),
        ],
    );
    let ratio = significant(masses.m2 / masses.m1);
    let sum = if equal {
        format!("Squared, that is {} of the energy.", percent(truth))
    } else {
        format!(
            "Squared, and times m₂ / m₁ = {ratio}, that is {} of the energy.",
            percent(truth)
        )
    };
    let asked = Asked {
        family: Family::EnergyShare,
        difficulty,
        topic: "energy-of-target".into(),
        ask: format!("What share of its energy does the {name} get?"),
        form,
        beliefs,
        why: format!(
            "The {name} leaves with (1 + e) m₁ / (m₁ + m₂) cos {} = {} times the striker's speed. \
             {sum}",
            bare_degrees(alpha),
            significant(speed)
        ),
        more: more([("asked", json!("passed"))]),
    };
    Some(about(hit, asked))
}

/// What is lost: only of what the two have against each other along the line of impact.
fn lost(hit: &Hit, difficulty: Difficulty) -> Option<Question> {
    let alpha = hit.alpha().abs();
    let masses = RestingTarget::from(&hit.collision());
    let truth = masses.energy_shares(alpha).lost;
    let e = hit.restitution;
    let missing = (1.0 - e) * (1.0 + e);
    // The share of the energy that is at stake.
    let stake = masses.m2 / (masses.m1 + masses.m2) * alpha.cos().powi(2);
    let form = share(truth);
    let beliefs = wrong(
        &form,
        [
            number(
                &E_AS_ENERGY,
                PERCENT * (1.0 - e),
                format!(
                    "You took e = {} as the share that is kept. e compares speeds, not energies.",
                    significant(e)
                ),
            ),
            number(
                &LOSS_ON_EVERYTHING,
                PERCENT * missing,
                "You took the loss off all of the motion. Only the part along the line of impact \
                 is at stake."
                    .into(),
            ),
            number(
                &SINE_COSINE,
                PERCENT * truth * alpha.tan().powi(2),
                "You took the sine for the cosine. Head-on the most is lost.".into(),
            ),
        ],
    );
    let asked = Asked {
        family: Family::EnergyShare,
        difficulty,
        topic: "energy-lost".into(),
        ask: "What share of its energy is lost?".into(),
        form,
        beliefs,
        why: format!(
            "At stake is m₂ / (m₁ + m₂) cos² {} = {} of the energy: what they have against each \
             other along the line. Of that 1 - e² = {} is lost.",
            bare_degrees(alpha),
            percent(stake),
            percent(missing)
        ),
        more: more([("asked", json!("lost"))]),
    };
    Some(about(hit, asked))
}
