//! The most a striker can be turned by one hit: whether there is a limit, where it lies,
//! and how to aim for it.

use super::prelude::*;
use crate::numbers::millimetres;
use crate::physics::resting_target::LargestDeflection;

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
const HEAVIER: [&[(u32, u32)]; 3] = [
    &[(15, 3), (15, 5), (15, 6)],
    &[(20, 6), (20, 8), (20, 10), (20, 12)],
    &[(24, 18), (25, 20), (30, 26)],
];

/// Masses in grams of a striker and a coin as heavy or heavier.
const NOT_HEAVIER: [&[(u32, u32)]; 2] = [
    &[(12, 12), (15, 15), (18, 18), (20, 20)],
    &[(10, 20), (12, 15), (15, 30), (20, 25)],
];

pub(super) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
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
    let hit = Hit {
        pieces: pair(m1_g, m2_g),
        given: ImpactPoint::Angle { alpha_deg: 30.0 },
        restitution: f64::from(e_tenths) / 10.0,
        speed: f64::from(2 + dice.below(4)),
        direction_deg: direction_deg(difficulty, dice),
    };
    let alpha_deg = turned(&hit).map_or(30.0, |(_, alpha)| deg_from_rad(alpha));
    hit.at_angle(if left { -alpha_deg } else { alpha_deg })
}

fn most(hit: &Hit) -> LargestDeflection {
    RestingTarget::from(&hit.collision()).largest_deflection()
}

/// The largest θ₁ and the α that brings it, where a limit lies well below 90°.
fn turned(hit: &Hit) -> Option<(f64, f64)> {
    match most(hit) {
        LargestDeflection::Turned { theta1, alpha } => Some((theta1, alpha)),
        LargestDeflection::NearlyRight | LargestDeflection::Reversed => None,
    }
}

/// The two masses and the loss in words.
fn setting(hit: &Hit) -> String {
    let who = hit.who("smooth striker", "is shot at");
    format!("{who}. {}", hit.loss())
}

/// Whether there is a limit, and which.
fn limit(dice: &mut Dice) -> Option<Question> {
    let pairs = if dice.below(5) < 2 {
        HEAVIER.concat()
    } else {
        NOT_HEAVIER.concat()
    };
    let hit = turned_most(*dice.pick(&pairs)?, 10, Difficulty::Easy, dice);
    let draft = Outline::told(&hit, setting(&hit), unmarked(&hit))
        .named("limit", "limit-of-turn")
        .ask("You choose the offset. How far can it be turned?");
    match most(&hit) {
        LargestDeflection::Turned { theta1, .. } => draft
            .options(LIMITS, BELOW)
            .chooses(BeyondLargest, BACK)
            .says("You set the heavier striker no limit. A light coin cannot throw it back.")
            .chooses(AlwaysSquare, SQUARE)
            .says("You took 90° - α from equal masses. A heavier striker is turned by less.")
            .why(format!(
                "The coin is too light to stop the striker, whatever the offset: some of its \
                 forward motion always stays. Here {} is the most, with sine m₂ / m₁.",
                degrees(theta1)
            )),
        LargestDeflection::NearlyRight => draft
            .options(LIMITS, SQUARE)
            .chooses(OffAWall, BACK)
            .says(
                "You let it bounce back as off a wall. But an equal coin gives way, and takes all \
                 it has along the line.",
            )
            .chooses(HalfAndHalf, BELOW)
            .says("Did you take 45° for the most? That is only the hit that shares evenly.")
            .why(
                "With equal masses the striker leaves at right angles to the line of impact, at \
                 90° - α. The fuller the hit, the nearer to 90°; head-on it stops.",
            ),
        LargestDeflection::Reversed => draft
            .options(LIMITS, BACK)
            .chooses(AlwaysSquare, SQUARE)
            .says("You took 90° - α from equal masses. A lighter striker bounces further.")
            .chooses(UpsideDown, BELOW)
            .says(
                "You had the masses the other way round: it is the heavier striker that has such \
                 a limit.",
            )
            .why(
                "Head-on a lighter striker bounces straight back: 180°. With the offset you can \
                 choose anything from there down to a graze at 0°.",
            ),
    }
}

/// By how many degrees at most.
fn how_much(e_tenths: u32, difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let hit = turned_most(*dice.pick(&HEAVIER.concat())?, e_tenths, difficulty, dice);
    let (theta1, _) = turned(&hit)?;
    let lossless = turned(&hit.with_restitution(1.0));
    let why = if hit.restitution < 1.0 {
        format!(
            "It gives up k = (1 + e) m₂ / (m₁ + m₂) = {} of its speed along the line. Its velocity \
             after ends on a circle; the line that just touches it has the sine k / (2 - k): {}.",
            significant(RestingTarget::from(&hit.collision()).k()),
            degrees(theta1)
        )
    } else {
        format!(
            "Whatever the offset, its velocity after ends on a circle, and the line that just \
             touches it has the sine m₂ / m₁ = {}: {}.",
            significant(hit.mass_ratio().recip()),
            degrees(theta1)
        )
    };
    Outline::told(&hit, setting(&hit), unmarked(&hit))
        .named("theta1", "largest-turn")
        .ask("By how many degrees can it be turned at most?")
        .number(Measure::Angle, deg_from_rad(theta1))
        .wrong(BeyondLargest, 90.0)
        .says(
            "You set the heavier striker no limit below 90°. A light coin cannot take all its \
             forward motion.",
        )
        .wrong(HeavyUnmoved, 0.0)
        .says("You sent it straight on. It is heavier, yet every hit off-centre turns it.")
        .wrong(SineCosine, 90.0 - deg_from_rad(theta1))
        .says(
            "You took a cosine. The lighter the coin, the smaller the turn, so it goes with a \
               sine.",
        )
        .wrong(Lossless, lossless.map(|(theta1, _)| deg_from_rad(theta1)))
        .says(here_e("That is the most without loss.", hit.restitution))
        .why(why)
}

/// A question where to aim a heavier striker without loss: the hit, the largest θ₁, the α
/// that brings it, and what is told.
fn aimed(dice: &mut Dice) -> Option<(Hit, f64, f64, Outline)> {
    let hit = turned_most(*dice.pick(&HEAVIER.concat())?, 10, Difficulty::Hard, dice);
    let (theta1, alpha) = turned(&hit)?;
    let draft = Outline::told(&hit, setting(&hit), Illustration::Nothing);
    Some((hit, theta1, alpha, draft))
}

const HEAD_ON: &str = "Head-on a heavier striker goes straight on: it is not turned at all.";

fn where_by_angle(dice: &mut Dice) -> Option<Question> {
    let (_, theta1, alpha, draft) = aimed(dice)?;
    let theta1_deg = deg_from_rad(theta1);
    draft
        .named("alpha", "aim-for-largest-turn")
        .ask(format!(
            "It can be turned by {} at most. At which impact angle?",
            degrees(theta1)
        ))
        .number(Measure::Angle, deg_from_rad(alpha))
        .wrong(HalfAndHalf, 45.0)
        .says("You took 45° for the best. That would be so for a very heavy striker only.")
        .wrong(CopiedAngle, theta1_deg)
        .says("That is the turn itself. The impact angle is the coin's direction.")
        .wrong(DoubleAngleForgotten, 90.0 - theta1_deg)
        .says(format!(
            "90 - {} is right for twice the angle. Take half of it.",
            bare_degrees(theta1)
        ))
        .wrong(BeyondLargest, 0.0)
        .says(HEAD_ON)
        .why(format!(
            "Its velocity after ends on a circle, at twice the impact angle around it. At the \
             largest turn its direction touches the circle: 2 α + {} = 90, so α is {}.",
            bare_degrees(theta1),
            degrees(alpha)
        ))
}

fn where_by_offset(dice: &mut Dice) -> Option<Question> {
    let (hit, theta1, alpha, draft) = aimed(dice)?;
    let reach_mm = hit.reach_mm();
    let offset_mm = reach_mm * alpha.sin();
    draft
        .named("offset", "aim-for-largest-turn")
        .ask(format!(
            "The radii make {} together. It is turned most, by {}, when the coin leaves at \
                 {}. At which offset?",
            millimetres(reach_mm),
            degrees(theta1),
            degrees(alpha)
        ))
        .number(Measure::Length, offset_mm)
        .wrong(OffsetAsAngle, reach_mm * deg_from_rad(alpha) / 90.0)
        .says(format!(
            "You took the offset in proportion to {}. It goes with the sine.",
            degrees(alpha)
        ))
        .wrong(SineCosine, reach_mm * alpha.cos())
        .says("You took the cosine for the sine. Head-on the offset is 0, so it goes with a sine.")
        .wrong(CopiedAngle, reach_mm * theta1.sin())
        .says(format!(
            "You aimed with the turn itself, {}. The impact angle is the coin's direction.",
            degrees(theta1)
        ))
        .wrong(BeyondLargest, 0.0)
        .says(HEAD_ON)
        .why(format!(
            "The coin leaves along the line of impact: α is {}. The offset is both radii together \
             times sin α = {}: {}.",
            degrees(alpha),
            significant(alpha.sin()),
            Measure::Length.print(offset_mm)
        ))
}
