//! The most a striker can be turned by one hit: whether there is a limit, where it lies,
//! and how to aim for it.

use serde_json::json;

use super::setting::{Asked, more, number, pair, told, unmarked, wrong, wrong_choices};
use crate::physics::RestingTarget;
use crate::physics::resting_target::LargestDeflection;
use crate::physics::units::deg_from_rad;
use crate::quiz::dice::Dice;
use crate::quiz::misconceptions::catalogue::{
    BEYOND_LARGEST, DOUBLE_ANGLE_FORGOTTEN, SINE_COSINE, UPSIDE_DOWN,
};
use crate::quiz::misconceptions::{
    ALWAYS_SQUARE, COPIED_ANGLE, HALF_AND_HALF, HEAVY_UNMOVED, LOSSLESS, OFF_A_WALL,
    OFFSET_AS_ANGLE,
};
use crate::quiz::words::{bare_degrees, degrees, millimetres, significant};
use crate::quiz::{
    Difficulty, Family, Form, Hit, Illustration, Measure, Placement, Question, WrongAnswer,
};

/// The choices, in their natural order.
const LIMITS: [&str; 3] = [
    "only by some angle well below 90°",
    "by anything up to just short of 90°",
    "by anything up to straight back",
];
const BELOW: usize = 0;
const SQUARE: usize = 1;
const BACK: usize = 2;

/// Masses in grams of a striker and a lighter coin.
const HEAVIER: [(u32, u32); 10] = [
    (15, 3),
    (15, 5),
    (15, 6),
    (20, 6),
    (20, 8),
    (20, 10),
    (20, 12),
    (24, 18),
    (25, 20),
    (30, 26),
];

/// Masses in grams of a striker and a coin as heavy or heavier.
const NOT_HEAVIER: [(u32, u32); 8] = [
    (12, 12),
    (15, 15),
    (18, 18),
    (20, 20),
    (10, 20),
    (12, 15),
    (15, 30),
    (20, 25),
];

/// Draws a question.
pub(in crate::quiz) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    match difficulty {
        Difficulty::Easy => limit(dice),
        Difficulty::Middle => how_much(10, difficulty, dice),
        Difficulty::Hard => match dice.below(3) {
            0 => how_much(*dice.pick(&[2, 4, 5, 6, 8])?, difficulty, dice),
            1 => where_by_angle(dice),
            _ => where_by_offset(dice),
        },
    }
}

/// A hit with these masses that turns the striker as far as can be, or one at 30° where
/// nothing does.
fn turned_most(
    (m1_g, m2_g): (u32, u32),
    e_tenths: u32,
    difficulty: Difficulty,
    dice: &mut Dice,
) -> Hit {
    let left = dice.coin();
    let turn = difficulty.turn_deg();
    let hit = Hit {
        pieces: pair(m1_g, m2_g),
        given: Placement::Angle { alpha_deg: 30.0 },
        restitution: f64::from(e_tenths) / 10.0,
        speed: f64::from(2 + dice.below(4)),
        direction_deg: f64::from(turn * dice.below(360 / turn)),
    };
    let alpha_deg = match most(&hit) {
        LargestDeflection::Turned { alpha, .. } => deg_from_rad(alpha),
        LargestDeflection::NearlyRight | LargestDeflection::Reversed => 30.0,
    };
    Hit {
        given: Placement::Angle {
            alpha_deg: if left { -alpha_deg } else { alpha_deg },
        },
        ..hit
    }
}

fn most(hit: &Hit) -> LargestDeflection {
    RestingTarget::from(&hit.collision()).largest_deflection()
}

/// The two masses and the loss in words.
fn setting((m1_g, m2_g): (u32, u32), hit: &Hit) -> String {
    let [m1, m2] = [m1_g, m2_g].map(|mass_g| significant(f64::from(mass_g)));
    let e = significant(hit.restitution);
    let loss = if hit.restitution < 1.0 {
        "Some energy is lost"
    } else {
        "No energy is lost"
    };
    format!("A smooth striker of {m1} g is shot at a resting coin of {m2} g. {loss}: e = {e}.")
}

/// Whether there is a limit, and which.
fn limit(dice: &mut Dice) -> Option<Question> {
    let pairs: &[(u32, u32)] = if dice.below(5) < 2 {
        &HEAVIER
    } else {
        &NOT_HEAVIER
    };
    let masses = *dice.pick(pairs)?;
    let hit = turned_most(masses, 10, Difficulty::Easy, dice);
    let (right, why) = match most(&hit) {
        LargestDeflection::Turned { theta1, .. } => (
            BELOW,
            format!(
                "The coin is too light to stop the striker, whatever the offset: some of its \
                 forward motion always stays. Here {} is the most, with sine m₂ / m₁.",
                degrees(theta1)
            ),
        ),
        LargestDeflection::NearlyRight => (
            SQUARE,
            "With equal masses the striker leaves square to the line of impact, at 90° - α. The \
             fuller the hit, the nearer to 90°; head-on it stops."
                .into(),
        ),
        LargestDeflection::Reversed => (
            BACK,
            "Head-on a lighter striker bounces straight back: 180°. The offset chooses anything \
             from there down to a graze at 0°."
                .into(),
        ),
    };
    let chosen = match right {
        BELOW => vec![
            (
                &BEYOND_LARGEST,
                BACK,
                "You set the heavier striker no limit. A light coin cannot throw it back.".into(),
            ),
            (
                &ALWAYS_SQUARE,
                SQUARE,
                "You took 90° - α from equal masses. A heavier striker is turned by less.".into(),
            ),
        ],
        SQUARE => vec![
            (
                &OFF_A_WALL,
                BACK,
                "You let it bounce back as off a wall. But an equal coin gives way, and takes all \
                 it has along the line."
                    .into(),
            ),
            (
                &HALF_AND_HALF,
                BELOW,
                "Did you take 45° for the most? That is only the hit that shares evenly.".into(),
            ),
        ],
        _ => vec![
            (
                &ALWAYS_SQUARE,
                SQUARE,
                "You took 90° - α from equal masses. A lighter striker bounces further.".into(),
            ),
            (
                &UPSIDE_DOWN,
                BELOW,
                "You had the masses the other way round: it is the heavier striker that has such \
                 a limit."
                    .into(),
            ),
        ],
    };
    let asked = Asked {
        family: Family::LargestDeflection,
        difficulty: Difficulty::Easy,
        topic: "limit-of-turn".into(),
        ask: "You choose the offset. How far can it be turned?".into(),
        form: Form::Choice {
            options: LIMITS.map(str::to_owned).into(),
            right,
        },
        beliefs: wrong_choices(right, chosen),
        why,
        more: more([("asked", json!("limit"))]),
    };
    Some(told(&hit, &setting(masses, &hit), unmarked(&hit), asked))
}

/// By how many degrees at most.
fn how_much(e_tenths: u32, difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let masses = *dice.pick(&HEAVIER)?;
    let hit = turned_most(masses, e_tenths, difficulty, dice);
    let LargestDeflection::Turned { theta1, .. } = most(&hit) else {
        return None;
    };
    let form = Form::Number {
        quantity: Measure::Angle,
        truth: deg_from_rad(theta1),
    };
    let lossy = hit.restitution < 1.0;
    let ratio = f64::from(masses.1) / f64::from(masses.0);
    let beliefs = wrong(
        &form,
        [
            number(
                &BEYOND_LARGEST,
                90.0,
                "You set the heavier striker no limit below 90°. A light coin cannot take all its \
                 forward motion."
                    .into(),
            ),
            number(
                &HEAVY_UNMOVED,
                0.0,
                "You sent it straight on. It is heavier, yet every hit off-centre turns it.".into(),
            ),
            number(
                &SINE_COSINE,
                deg_from_rad(theta1.sin().acos()),
                "You took a cosine. The lighter the coin, the smaller the turn: a sine.".into(),
            ),
            number(
                &LOSSLESS,
                deg_from_rad(ratio.asin()),
                format!(
                    "That is the most without loss. Here e = {}.",
                    significant(hit.restitution)
                ),
            ),
        ],
    );
    let asked = Asked {
        family: Family::LargestDeflection,
        difficulty,
        topic: "largest-turn".into(),
        ask: "By how many degrees can it be turned at most?".into(),
        form,
        beliefs,
        why: if lossy {
            lossy_most(&hit, theta1)
        } else {
            format!(
                "Whatever the offset, its velocity after ends on a circle, and the line that just \
                 touches it has the sine m₂ / m₁ = {}: {}.",
                significant(ratio),
                degrees(theta1)
            )
        },
        more: more([("asked", json!("theta1"))]),
    };
    Some(told(&hit, &setting(masses, &hit), unmarked(&hit), asked))
}

fn lossy_most(hit: &Hit, theta1: f64) -> String {
    let k = RestingTarget::from(&hit.collision()).k();
    format!(
        "It gives up k = (1 + e) m₂ / (m₁ + m₂) = {} of its speed along the line. Its velocity \
         after ends on a circle; the line that just touches it has the sine k / (2 - k): {}.",
        significant(k),
        degrees(theta1)
    )
}

/// A heavier striker without loss, with the largest θ₁ and the α that brings it.
fn aimed(dice: &mut Dice) -> Option<((u32, u32), Hit, f64, f64)> {
    let masses = *dice.pick(&HEAVIER)?;
    let hit = turned_most(masses, 10, Difficulty::Hard, dice);
    match most(&hit) {
        LargestDeflection::Turned { theta1, alpha } => Some((masses, hit, theta1, alpha)),
        LargestDeflection::NearlyRight | LargestDeflection::Reversed => None,
    }
}

/// What both ask about that ask where to aim.
const AIM: &str = "aim-for-largest-turn";

/// To aim head-on for the largest turn.
fn head_on() -> Option<WrongAnswer> {
    number(
        &BEYOND_LARGEST,
        0.0,
        "Head-on a heavier striker goes straight on: it is not turned at all.".into(),
    )
}

/// At which impact angle.
fn where_by_angle(dice: &mut Dice) -> Option<Question> {
    let (masses, hit, theta1, alpha) = aimed(dice)?;
    let form = Form::Number {
        quantity: Measure::Angle,
        truth: deg_from_rad(alpha),
    };
    let theta1_deg = deg_from_rad(theta1);
    let beliefs = wrong(
        &form,
        [
            number(
                &HALF_AND_HALF,
                45.0,
                "You took 45° for the best. That is so only for a very heavy striker.".into(),
            ),
            number(
                &COPIED_ANGLE,
                theta1_deg,
                "That is the turn itself. The impact angle is the coin's way.".into(),
            ),
            number(
                &DOUBLE_ANGLE_FORGOTTEN,
                90.0 - theta1_deg,
                format!(
                    "90 - {} is right for twice the angle. Take half of it.",
                    bare_degrees(theta1)
                ),
            ),
            head_on(),
        ],
    );
    let asked = Asked {
        family: Family::LargestDeflection,
        difficulty: Difficulty::Hard,
        topic: AIM.into(),
        ask: format!(
            "It can be turned by {} at most. At which impact angle?",
            degrees(theta1)
        ),
        form,
        beliefs,
        why: touching(theta1, alpha),
        more: more([("asked", json!("alpha"))]),
    };
    Some(told(
        &hit,
        &setting(masses, &hit),
        Illustration::Nothing,
        asked,
    ))
}

fn touching(theta1: f64, alpha: f64) -> String {
    format!(
        "Its velocity after ends on a circle, at twice the impact angle round it. At the most its \
         way touches the circle: 2 α + {} = 90, so α is {}.",
        bare_degrees(theta1),
        degrees(alpha)
    )
}

/// At which offset.
fn where_by_offset(dice: &mut Dice) -> Option<Question> {
    let (masses, hit, theta1, alpha) = aimed(dice)?;
    let reach_mm = hit.reach_mm();
    let form = Form::Number {
        quantity: Measure::Length,
        truth: reach_mm * alpha.sin(),
    };
    let beliefs: Vec<WrongAnswer> = wrong(
        &form,
        [
            number(
                &OFFSET_AS_ANGLE,
                reach_mm * deg_from_rad(alpha) / 90.0,
                format!(
                    "You took the offset in proportion to {}. It goes with the sine.",
                    degrees(alpha)
                ),
            ),
            number(
                &SINE_COSINE,
                reach_mm * alpha.cos(),
                "You took the cosine for the sine. Head-on the offset is 0: a sine.".into(),
            ),
            number(
                &COPIED_ANGLE,
                reach_mm * theta1.sin(),
                format!(
                    "You aimed with the turn itself, {}. The impact angle is the coin's way.",
                    degrees(theta1)
                ),
            ),
            head_on(),
        ],
    );
    let asked = Asked {
        family: Family::LargestDeflection,
        difficulty: Difficulty::Hard,
        topic: AIM.into(),
        ask: format!(
            "The radii make {} together. It is turned most, by {}, when the coin \
             leaves at {}. At which offset?",
            millimetres(reach_mm),
            degrees(theta1),
            degrees(alpha)
        ),
        form,
        beliefs,
        why: format!(
            "The coin leaves along the line of impact: α is {}. The offset is both radii together \
             times sin α = {}: {}.",
            degrees(alpha),
            significant(alpha.sin()),
            Measure::Length.print(reach_mm * alpha.sin())
        ),
        more: more([("asked", json!("offset"))]),
    };
    Some(told(
        &hit,
        &setting(masses, &hit),
        Illustration::Nothing,
        asked,
    ))
}
