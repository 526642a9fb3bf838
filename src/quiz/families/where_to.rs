//! "Where will they go?": both rays of a hit on a resting target.

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};

use super::hit_kinds::Kind;
use crate::physics::units::{g_from_kg, mm_from_m};
use crate::quiz::dice::Dice;
use crate::quiz::misconceptions::OF_RAYS;
use crate::quiz::{
    Difficulty, Family, Form, Hit, Illustration, Markings, Placement, Question, Response,
    WrongAnswer, reasoning,
};

/// How many hits a round of this family has.
pub const LENGTH: usize = 10;

/// The ten hits of a seed, mixed in kind and rising in difficulty.
///
/// The seed is a code that players give each other, so the same seed must bring the
/// same hits on every machine and in every version. They follow from it alone: the
/// dice are PCG32 as described in the `dice` file, the kinds, their order and their
/// possible figures stand in the `hit_kinds` file, and all three are part of the
/// format.
pub fn hits(seed: u64) -> Vec<(Difficulty, Hit)> {
    let mut dice = Dice::new(seed);
    let mut hits: Vec<(Difficulty, Hit)> = Vec::with_capacity(LENGTH);
    for difficulty in Difficulty::ALL {
        let mut kinds = difficulty.kinds().to_vec();
        dice.shuffle(&mut kinds);
        for kind in kinds {
            let asked: Vec<Hit> = hits.iter().map(|(_, hit)| *hit).collect();
            let hit = kind.draw(difficulty, &asked, &mut dice);
            hits.extend(hit.map(|hit| (difficulty, hit)));
        }
    }
    hits
}

/// Any question of this family.
pub(in crate::quiz) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    of_kinds(Family::WhereTo, difficulty, difficulty.kinds(), dice)
}

/// A question about a hit of one of these kinds.
pub(super) fn of_kinds(
    family: Family,
    difficulty: Difficulty,
    kinds: &[Kind],
    dice: &mut Dice,
) -> Option<Question> {
    let hit = dice.pick(kinds)?.draw(difficulty, &[], dice)?;
    Some(Question {
        family,
        difficulty,
        ..question(&hit)
    })
}

/// The question where the two of this hit will go.
pub fn question(hit: &Hit) -> Question {
    Question {
        family: Family::WhereTo,
        difficulty: Difficulty::Middle,
        topic: hit.topic(),
        text: hit.text(),
        picture: Illustration::Before {
            collision: hit.collision(),
            shown: Markings::given(hit),
        },
        form: Form::Rays {
            truth: hit.truth(),
            side: hit.side(),
            target: hit.pieces.target_name(),
        },
        beliefs: beliefs(hit),
        replies: BTreeMap::new(),
        why: reasoning(hit),
        figures: figures(hit),
    }
}

/// What misconceptions make of a hit.
fn beliefs(hit: &Hit) -> Vec<WrongAnswer> {
    OF_RAYS
        .into_iter()
        .filter_map(|misconception| {
            let prediction = misconception.predict(hit)?;
            Some(WrongAnswer {
                misconception,
                said: Response::Rays(prediction.rays),
                telltale: prediction.telltale,
                says: misconception.say(hit),
            })
        })
        .collect()
}

/// All that fixes a hit.
pub(super) fn figures(hit: &Hit) -> Map<String, Value> {
    let (striker, target) = (hit.pieces.striker(), hit.pieces.target());
    let place = match hit.given {
        Placement::Angle { alpha_deg } => ("alpha_deg", alpha_deg),
        Placement::Offset { offset_mm } => ("offset_mm", offset_mm),
    };
    let figures = [
        ("m1_g", g_from_kg(striker.mass)),
        ("m2_g", g_from_kg(target.mass)),
        ("r1_mm", mm_from_m(striker.radius)),
        ("r2_mm", mm_from_m(target.radius)),
        ("restitution", hit.restitution),
        ("speed", hit.speed),
        ("direction_deg", hit.direction_deg),
        place,
    ];
    let figures = figures.map(|(name, value)| (name.to_owned(), json!(value)));
    figures.into_iter().collect()
}

impl From<&Hit> for Question {
    fn from(hit: &Hit) -> Self {
        question(hit)
    }
}
