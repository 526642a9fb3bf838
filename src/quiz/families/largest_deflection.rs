//! The greatest deflection of a striker in a single collision: whether the deflection has a limit,
//! how large the limit is, and where to aim to reach it.

use std::f64::consts::FRAC_PI_2;

use super::prelude::*;
use crate::numbers::millimetres;
use crate::physics::resting_target::LargestDeflection;

/// The choices, in their natural order.
const LIMITS: [&str; 3] = [
    "up to an angle well below 90°",
    "up to nearly 90°, but no further",
    "up to 180°, straight back",
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

/// The masses, in grams, of a striker and a coin of equal or greater mass.
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

/// A hit with these masses, at the impact angle of the greatest deflection if [`turned`] finds one,
/// otherwise at an impact angle of 30°.
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

/// The largest θ₁ and the α at which it occurs, if θ₁ has a maximum below 90°.
fn turned(hit: &Hit) -> Option<(f64, f64)> {
    match most(hit) {
        LargestDeflection::Turned { theta1, alpha } => Some((theta1, alpha)),
        LargestDeflection::NearlyRight | LargestDeflection::Reversed => None,
    }
}

/// Describes the two masses and the energy loss in words.
fn setting(hit: &Hit) -> String {
    let who = hit.who("smooth striker", "is shot at");
    format!("{who}. {}", hit.loss())
}

/// Asks whether the deflection has a limit, and how large it is.
fn limit(dice: &mut Dice) -> Option<Question> {
    let pairs = if dice.below(5) < 2 {
        HEAVIER.concat()
    } else {
        NOT_HEAVIER.concat()
    };
    let hit = turned_most(*dice.pick(&pairs)?, 10, Difficulty::Easy, dice);
    let draft = Outline::with_text(&hit, setting(&hit), unmarked(&hit))
        .named("limit", "limit-of-turn")
        .ask("You choose the offset. How far can the striker be deflected?");
    match most(&hit) {
        LargestDeflection::Turned { theta1, .. } => draft
            .options(LIMITS, BELOW)
            .chooses(BeyondLargest, BACK)
            .says(
                "You assumed no limit for the heavier striker. But a light coin cannot turn it \
                   back.",
            )
            .chooses(AlwaysSquare, SQUARE)
            .says(
                "You used 90° − α, which is right for equal masses. A heavier striker is \
                   deflected less.",
            )
            .why(format!(
                "The coin is too light to stop the striker at any offset: some of the striker's \
                 forward motion always remains. The greatest deflection is {}, with sin θ₁ = m₂ / \
                 m₁.",
                degrees(theta1)
            )),
        LargestDeflection::NearlyRight => draft
            .options(LIMITS, SQUARE)
            .chooses(OffAWall, BACK)
            .says(
                "You assumed that the striker bounces back as if off a wall. But an equal coin is \
                 free to move.",
            )
            .chooses(HalfAndHalf, BELOW)
            .says(
                "Did you assume that equal angles are the limit? They only mean that the energy is \
                 shared equally.",
            )
            .why(
                "With equal masses the striker leaves at right angles to the line of impact, at \
                 90° − α. The smaller α is, the closer the deflection is to 90°. But exactly \
                 head-on, the striker stops.",
            ),
        LargestDeflection::Reversed => draft
            .options(LIMITS, BACK)
            .chooses(AlwaysSquare, SQUARE)
            .says(
                "You used 90° − α, which is right for equal masses. A lighter striker is \
                   deflected further.",
            )
            .chooses(HeavyRebounds, BELOW)
            .says(
                "You gave the lighter striker the limit of a heavier one. A lighter striker can \
                   rebound.",
            )
            .why(
                "Head-on, a lighter striker bounces straight back: 180°. Other offsets give every \
                 deflection from 180° down to 0° at a graze.",
            ),
    }
}

/// Asks for the greatest deflection in degrees.
fn how_much(e_tenths: u32, difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let hit = turned_most(*dice.pick(&HEAVIER.concat())?, e_tenths, difficulty, dice);
    let (theta1, _) = turned(&hit)?;
    let lossless = turned(&hit.with_restitution(1.0));
    let k = RestingTarget::from(&hit.collision()).k();
    let arcsine = |x: f64| degrees(x.asin());
    let of_k = |k: f64| arcsine(k / (2.0 - k));
    let (sine, most) = if hit.restitution < 1.0 {
        let k = Intermediate::new(k, of_k);
        let sine = format!("k / (2 − k) = {k} / (2 − {k}) for k = (1 + e) m₂ / (m₁ + m₂)");
        (sine, of_k(k.value))
    } else {
        let ratio = Intermediate::new(hit.mass_ratio().recip(), arcsine);
        (format!("m₂ / m₁ = {ratio}"), arcsine(ratio.value))
    };
    let why = format!(
        "The tips of all final velocity vectors lie on one circle. The greatest deflection is \
         along its tangent: sin θ₁ = {sine}. So θ₁ = {most}."
    );
    Outline::with_text(&hit, setting(&hit), unmarked(&hit))
        .named("theta1", "largest-turn")
        .ask("What is the greatest angle by which the striker can be deflected?")
        .number(Measure::Angle, deg_from_rad(theta1))
        .wrong(BeyondLargest, 90.0)
        .says("Your answer is close to 90°. But a light coin cannot stop the forward motion.")
        .wrong(HeavyUnmoved, 0.0)
        .says("You assumed that the striker goes straight on. But off-centre it is deflected.")
        .wrong(SineCosine, 90.0 - deg_from_rad(theta1))
        .says("You used a cosine. But the lighter the coin, the smaller the deflection.")
        .wrong(Lossless, lossless.map(|(theta1, _)| deg_from_rad(theta1)))
        .says(here_e(
            "That is the greatest angle if no energy is lost.",
            hit.restitution,
        ))
        .why(why)
}

/// A question about where to aim a heavier striker in an elastic collision: the hit, the greatest
/// θ₁, the α at which it occurs, and the outline with the setting.
fn aimed(dice: &mut Dice) -> Option<(Hit, f64, f64, Outline)> {
    let hit = turned_most(*dice.pick(&HEAVIER.concat())?, 10, Difficulty::Hard, dice);
    let (theta1, alpha) = turned(&hit)?;
    let draft = Outline::with_text(&hit, setting(&hit), Illustration::Nothing);
    Some((hit, theta1, alpha, draft))
}

const HEAD_ON: &str = "Head-on, a heavier striker goes straight on: it is not deflected at all.";

fn where_by_angle(dice: &mut Dice) -> Option<Question> {
    let (_, theta1, alpha, draft) = aimed(dice)?;
    let theta1_deg = deg_from_rad(theta1);
    draft
        .named("alpha", "aim-for-largest-turn")
        .ask(format!(
            "The greatest angle by which the striker can be deflected is {}. At which impact \
             angle does this happen?",
            degrees(theta1)
        ))
        .number(Measure::Angle, deg_from_rad(alpha))
        .wrong(HalfAndHalf, 45.0)
        .says("Your answer is close to 45°. That is right only for a very heavy striker.")
        .wrong(CopiedAngle, theta1_deg)
        .says("That is the deflection itself. The impact angle is the coin's direction.")
        .wrong(DoubleAngleForgotten, 90.0 - theta1_deg)
        .says(format!(
            "90° − {}° is twice the impact angle. Take half of it.",
            bare_degrees(theta1)
        ))
        .wrong(BeyondLargest, 0.0)
        .says(HEAD_ON)
        .why(format!(
            "The tip of the final velocity lies on a circle, at an angle of 2α. At the \
             greatest deflection the vector is a tangent, so 2α + θ₁ = 90° and α = (90° − {}°) / 2 \
             = {}.",
            Intermediate::angle(theta1, |theta1| degrees((FRAC_PI_2 - theta1) / 2.0)),
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
            "r₁ + r₂ = {}. The striker is deflected most, by {}, when the coin leaves at {} to \
             the striker's original direction. What is the offset?",
            millimetres(reach_mm),
            degrees(theta1),
            degrees(alpha)
        ))
        .number(Measure::Length, offset_mm)
        .wrong(OffsetAsAngle, reach_mm * deg_from_rad(alpha) / 90.0)
        .says(format!(
            "You assumed that the offset is proportional to the angle {}. It is proportional to \
             the sine.",
            degrees(alpha)
        ))
        .wrong(SineCosine, reach_mm * alpha.cos())
        .says("You used the cosine instead of the sine. Head-on, the offset is 0, so use the sine.")
        .wrong(CopiedAngle, reach_mm * theta1.sin())
        .says(format!(
            "You used the deflection, {}, as the impact angle. The impact angle is the coin's \
             direction.",
            degrees(theta1)
        ))
        .wrong(BeyondLargest, 0.0)
        .says(HEAD_ON)
        .why(format!(
            "The coin leaves along the line of impact, so its angle is α. The offset is b = \
             (r₁ + r₂) sin α = {} mm × sin {}° = {}.",
            bare_millimetres(reach_mm),
            Intermediate::angle(alpha, |alpha| Measure::Length.print(reach_mm * alpha.sin())),
            Measure::Length.print(offset_mm)
        ))
}
