//! "Where will they go?": both rays after a collision with a target at rest.

use std::collections::BTreeMap;

use serde_json::json;

use super::hit_kinds::HitKind::{self, *};
use super::hit_kinds::KINDS;
use crate::physics::ImpactPoint;
use crate::physics::units::mm_from_m;
use crate::quiz::misconceptions::{OF_RAYS, reasoning};
use crate::quiz::question::{
    Dice, Difficulty, Family, Figures, Form, Hit, Illustration, Markings, Question, Response,
    WrongAnswer,
};

/// The number of hits in a round of this family.
pub(crate) const LENGTH: usize = 10;

/// The ten hits of a seed, of mixed kinds and rising difficulty.
///
/// The seed is a code that players share, so the same seed must give the same hits on every machine
/// and in every version. The hits depend only on the seed: the file `dice` defines the generator,
/// PCG32, and the file `hit_kinds` defines the kinds of hit, their order and their possible
/// figures. None of these may change.
pub fn hits(seed: u64) -> Vec<(Difficulty, Hit)> {
    let mut dice = Dice::new(seed);
    let mut hits: Vec<(Difficulty, Hit)> = Vec::with_capacity(LENGTH);
    for difficulty in Difficulty::ALL {
        let mut kinds = KINDS[difficulty as usize].to_vec();
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
pub(super) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    of_kinds(KINDS, difficulty, dice)
}

/// Asks for both rays, given the impact angle: equal masses, with and without loss.
pub(super) fn from_angle(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let kinds: [&[HitKind]; 3] = [&[EqualAngle], &[EqualAngle], &[LossyAngle]];
    of_kinds(kinds, difficulty, dice)
}

/// Asks for both rays, given the offset, from which the angle has to be found first.
pub(super) fn from_offset(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let unequal = &[TournamentOffset, MarblesOffset];
    of_kinds([&[EqualOffset], &[EqualOffset], unequal], difficulty, dice)
}

/// Asks for both rays, with a heavier striker or a heavier target; easy head-on hits may also be
/// between equal masses.
pub(super) fn unequal_masses(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let kinds: [&[HitKind]; 3] = [
        &[TournamentAngle, MarblesAngle, HeadOn],
        &[TournamentAngle, MarblesAngle],
        &[LossyMarbles],
    ];
    of_kinds(kinds, difficulty, dice)
}

/// Asks for both rays, given only the picture without numbers.
pub(super) fn from_picture(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let hit = dice.pick(&[EqualAngle])?.draw(difficulty, &[], dice)?;
    let (angle, eye) = match difficulty {
        Difficulty::Easy => (
            true,
            "The dashed line is the line of impact. Look at the picture:",
        ),
        Difficulty::Middle | Difficulty::Hard => (
            false,
            "In the picture, find where the two will touch, and the line of impact:",
        ),
    };
    let shown = Markings {
        angle,
        ..Markings::default()
    };
    Some(Question {
        topic: "from-the-picture".into(),
        text: format!(
            "One of two equal discs is at rest, and no energy is lost. {eye} where will they go?"
        ),
        picture: Illustration::before(hit.collision(), shown),
        ..Question::from(&hit)
    })
}

/// A question about a hit of one of these kinds, which are listed for each difficulty.
fn of_kinds(kinds: [&[HitKind]; 3], difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let kind = dice.pick(kinds[difficulty as usize])?;
    let hit = kind.draw(difficulty, &[], dice)?;
    Some(Question::from(&hit))
}

/// The wrong answers that misconceptions lead to for this hit.
fn beliefs(hit: &Hit) -> Vec<WrongAnswer> {
    OF_RAYS
        .into_iter()
        .filter_map(|misconception| {
            let (rays, telltale) = misconception.predict(hit)?;
            Some(WrongAnswer {
                misconception,
                said: Response::Rays(rays),
                telltale,
                says: misconception.say(hit),
            })
        })
        .collect()
}

/// All figures that define a hit.
pub(super) fn figures(hit: &Hit) -> Figures {
    let [striker, target] = hit.pieces.discs();
    let [m1_g, m2_g] = hit.masses_g();
    let place = match hit.given {
        ImpactPoint::Angle { alpha_deg } => ("alpha_deg", alpha_deg),
        ImpactPoint::Offset { offset_mm } => ("offset_mm", offset_mm),
    };
    let figures = [
        ("m1_g", m1_g),
        ("m2_g", m2_g),
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

/// The question that asks where the two discs will go.
impl From<&Hit> for Question {
    fn from(hit: &Hit) -> Self {
        Self {
            family: Family::WhereTo,
            difficulty: Difficulty::Middle,
            topic: hit.topic(),
            text: format!("{} Where will they go?", hit.setting()),
            picture: Illustration::before(hit.collision(), Markings::given(hit)),
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
}
