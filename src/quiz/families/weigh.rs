//! Comparing masses by what can be seen after a collision: which disc is heavier, and by what
//! factor.

use super::prelude::*;
use super::separation::FOLLOWS_OR_BOUNCES;
use crate::numbers::tenths;
use crate::physics::resting_target::{k_from_angles, mass_ratio_from_angles};

/// The choices, in their natural order.
const WEIGHTS: [&str; 3] = [
    "lighter than the striker",
    "as heavy as the striker",
    "heavier than the striker",
];
const LIGHTER: usize = 0;
const ALIKE: usize = 1;
const HEAVIER: usize = 2;

/// The masses, in grams, of coins that a striker of 15 g hits.
const COINS_G: [u32; 10] = [5, 6, 8, 10, 12, 18, 20, 25, 30, 40];
const STRIKER_G: u32 = 15;
const STRIKER: f64 = STRIKER_G as f64;

pub(super) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    match difficulty {
        Difficulty::Easy => which(dice),
        Difficulty::Middle => by_momentum(&SeenHit::draw(&COINS_G, NO_LOSS, difficulty, dice)?),
        Difficulty::Hard => {
            let restitutions = [1.0, 1.0, 0.8, 0.6, 0.5];
            by_angles(&SeenHit::draw(&COINS_G, &restitutions, difficulty, dice)?)
        }
    }
}

/// A collision and the angles that are observed after it.
struct SeenHit {
    hit: Hit,
    coin_g: f64,
    theta1: f64,
    theta2: f64,
}

impl SeenHit {
    fn draw(
        coins_g: &[u32],
        restitutions: &[f64],
        difficulty: Difficulty,
        dice: &mut Dice,
    ) -> Option<Self> {
        let coin_g = *dice.pick(coins_g)?;
        let pieces = [pair(STRIKER_G, coin_g)];
        let hit = HitDraws(&pieces, 20..=70, restitutions).draw(difficulty, dice)?;
        let outcome = hit.outcome();
        Some(Self {
            hit,
            coin_g: f64::from(coin_g),
            theta1: outcome.theta1?.abs(),
            theta2: outcome.theta2?.abs(),
        })
    }

    /// A question about the observed angles; its text begins with `striker`, the name of the
    /// striker.
    fn outline(&self, striker: &str) -> Outline {
        let text = format!(
            "{striker} hit a coin at rest. {}",
            seen_angles(self.theta1, self.theta2)
        );
        let collision = self.hit.collision();
        Outline::with_text(&self.hit, text, Illustration::After { collision })
    }
}

/// The sentence that gives the two observed angles.
pub(super) fn seen_angles(theta1: f64, theta2: f64) -> String {
    format!(
        "The striker was deflected by θ₁ = {}; the coin left at θ₂ = {} on the other side.",
        degrees(theta1),
        degrees(theta2)
    )
}

/// Asks which disc is heavier, given the angle between the paths.
fn which(dice: &mut Dice) -> Option<Question> {
    let alike = dice.below(3) == 0;
    let coins_g: &[u32] = if alike { &[STRIKER_G] } else { &COINS_G };
    let seen = SeenHit::draw(coins_g, NO_LOSS, Difficulty::Easy, dice)?;
    let right = place(seen.coin_g.total_cmp(&STRIKER));
    let turned_less = place(tenths(seen.theta1).cmp(&tenths(seen.theta2)));
    if right == ALIKE && turned_less == ALIKE {
        // For such a hit, merely comparing the two angles would give the right answer by accident.
        return None;
    }
    let why = match right {
        LIGHTER => {
            ", less than 90°: the striker still followed the coin along the line of impact. So \
             the striker is heavier."
        }
        ALIKE => ". If no energy is lost, a right angle means equal masses, whatever the offset.",
        _ => {
            ", more than 90°: the striker rebounded along the line of impact. So the coin is \
             heavier."
        }
    };
    seen.outline("A smooth striker")
        .named("which", "which-is-heavier")
        .ask("No energy was lost. How heavy is the coin?")
        .options(WEIGHTS, right)
        .chooses(HeavyUnmoved, turned_less)
        .says(
            "You assumed that the disc with the smaller angle is the heavier disc. But both angles \
             also depend on the offset.",
        )
        .chooses(HeavyRebounds, HEAVIER - right)
        .says(FOLLOWS_OR_BOUNCES)
        .why(format!(
            "The angle between the paths is {} + {} = {:.1}°{why}",
            degrees(seen.theta1),
            degrees(seen.theta2),
            (tenths(seen.theta1) + tenths(seen.theta2)) as f64 / 10.0
        ))
}

const RATIO_UPSIDE_DOWN: &str = "You inverted the ratio of the masses.";

/// Asks for the coin's mass, which follows from the momentum perpendicular to the striker's path,
/// given angles and speeds.
fn by_momentum(seen: &SeenHit) -> Option<Question> {
    let outcome = seen.hit.outcome();
    let (u, v1, v2) = (seen.hit.speed, outcome.v1.length(), outcome.v2.length());
    let (theta1, theta2) = (seen.theta1, seen.theta2);
    let [before, then, coin] = [u, v1, v2].map(significant);
    let [sin1, sin2] = [theta1, theta2].map(|angle| read_off_angle(angle).sin());
    let mass = |momentum: f64, speed: f64| Measure::Mass.print(momentum / speed);
    let read = [STRIKER * read_off(v1) * sin1, read_off(v2) * sin2];
    let [momentum, speed] = Intermediate::pair(read, mass);
    seen.outline(&format!("A striker of {} g", significant(STRIKER)))
        .named("momentum", "mass-from-momentum")
        .ask(format!(
            "The striker's speed was {before} m/s before and {then} m/s after; the coin left at \
             {coin} m/s. What is the coin's mass?"
        ))
        .number(Measure::Mass, seen.coin_g)
        .wrong(ScalarMomentum, STRIKER * (u - v1) / v2)
        .says("You added the momenta as plain numbers, but they are vectors.")
        .wrong(UpsideDown, STRIKER * STRIKER / seen.coin_g)
        .says(RATIO_UPSIDE_DOWN)
        .wrong(
            SineCosine,
            (STRIKER * v1 * theta1.cos() / (v2 * theta2.cos())).abs(),
        )
        .says("You used the components along the original direction.")
        .why(format!(
            "The momenta perpendicular to the striker's original path cancel: m₁v₁ sin θ₁ = m₂v₂ \
             sin θ₂. So m₂ = {momentum} g m/s / ({speed} m/s) = {}.",
            within_readings(
                &mass(momentum.value, speed.value),
                &Measure::Mass.print(seen.coin_g)
            )
        ))
}

/// Asks for the coin's mass, given only the two angles.
fn by_angles(seen: &SeenHit) -> Option<Question> {
    let (theta1, theta2) = (seen.theta1, seen.theta2);
    let e = seen.hit.restitution;
    let lossless = mass_ratio_from_angles(theta1, theta2, 1.0)?;
    let [read1, read2] = [theta1, theta2].map(read_off_angle);
    let found = |mass: f64| {
        within_readings(
            &Measure::Mass.print(mass),
            &Measure::Mass.print(seen.coin_g),
        )
    };
    let (loss, why) = if e < 1.0 {
        let k = k_from_angles(read1, read2).or(k_from_angles(theta1, theta2))?;
        let mass = |k: f64| STRIKER * k / (1.0 + e - k);
        let k = Intermediate::new(k, |k| significant(mass(k)));
        let why = format!(
            "Along the line of impact the striker loses the fraction k = sin θ₁ / \
             (cos θ₂ sin(θ₁ + θ₂)) = {k}. As k = (1 + e) m₂ / (m₁ + m₂), m₂ = {} × {k} / (1 + {} \
             − {k}) = {}.",
            significant(STRIKER),
            significant(e),
            found(mass(k.value))
        );
        (format!("e = {}.", significant(e)), why)
    } else {
        let ratio = mass_ratio_from_angles(read1, read2, 1.0).unwrap_or(lossless);
        let shown = Intermediate::new(ratio, |ratio| significant(STRIKER / ratio));
        let why = format!(
            "If no energy is lost, m₁ / m₂ = sin(θ₁ + 2θ₂) / sin θ₁ = {shown}. So m₂ = {} / {shown} = \
             {}.",
            significant(STRIKER),
            found(STRIKER / shown.value)
        );
        ("No energy was lost.".into(), why)
    };
    seen.outline(&format!("A smooth striker of {} g", significant(STRIKER)))
        .named("angles", "mass-from-angles")
        .ask(format!("{loss} What is the coin's mass?"))
        .number(Measure::Mass, seen.coin_g)
        .wrong(UpsideDown, STRIKER * STRIKER / seen.coin_g)
        .says(RATIO_UPSIDE_DOWN)
        .wrong(Lossless, STRIKER / lossless)
        .says(here_e("That is the mass if no energy is lost.", e))
        .wrong(
            DoubleAngleForgotten,
            STRIKER * theta1.sin() / (theta1 + theta2).sin(),
        )
        .says("You used θ₂, but the formula contains twice θ₂.")
        .why(why)
}
