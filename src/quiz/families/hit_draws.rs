//! Draws hits for several families.

use std::cmp::Ordering;
use std::ops::RangeInclusive;

use crate::numbers::{Intermediate, bare_millimetres, degrees, significant};
use crate::physics::{Disc, ImpactPoint};
use crate::quiz::question::{Dice, Difficulty, Hit, Illustration, Markings, Measure, Pieces};

pub(super) const EQUAL: &[Pieces] = &[Pieces::Equal];
pub(super) const UNEQUAL: &[Pieces] = &[Pieces::Tournament, Pieces::Marbles];
pub(super) const ALL: &[Pieces] = &[Pieces::Equal, Pieces::Tournament, Pieces::Marbles];

pub(super) const NO_LOSS: &[f64] = &[1.0];

/// The values from which a hit on a target at rest is drawn: sets of pieces, a range of impact
/// angles in degrees (the angles are multiples of five), and values of e.
pub(super) struct HitDraws<'a>(
    pub(super) &'a [Pieces],
    pub(super) RangeInclusive<u32>,
    pub(super) &'a [f64],
);

impl HitDraws<'_> {
    /// Draws the pieces, α, e, a speed from 2 to 5 m/s, the side and a direction; for harder
    /// questions there are more possible directions.
    pub(super) fn draw(&self, difficulty: Difficulty, dice: &mut Dice) -> Option<Hit> {
        let Self(pieces, fives_deg, restitutions) = self;
        let pieces = *dice.pick(pieces)?;
        let (from, to) = (fives_deg.start() / 5, fives_deg.end() / 5);
        let alpha_deg = f64::from(5 * (from + dice.below((to + 1).saturating_sub(from))));
        let restitution = *dice.pick(restitutions)?;
        let speed = f64::from(2 + dice.below(4));
        let left = dice.coin();
        Some(Hit {
            pieces,
            given: ImpactPoint::Angle {
                // This is 0.0 - x, because -x would be -0.0 for a head-on hit, which has no side.
                alpha_deg: if left { 0.0 - alpha_deg } else { alpha_deg },
            },
            restitution,
            speed,
            direction_deg: direction_deg(difficulty, dice),
        })
    }
}

/// Draws an off-centre hit with these discs and this e.
pub(super) fn drawn(
    pieces: Pieces,
    restitution: f64,
    difficulty: Difficulty,
    dice: &mut Dice,
) -> Option<Hit> {
    HitDraws(&[pieces], 20..=70, &[restitution]).draw(difficulty, dice)
}

/// Draws the direction of the striker in the picture, in degrees: a multiple of 360°, 90° or 30°;
/// the harder the question, the smaller the step.
pub(super) fn direction_deg(difficulty: Difficulty, dice: &mut Dice) -> f64 {
    let turn = match difficulty {
        Difficulty::Easy => 360,
        Difficulty::Middle => 90,
        Difficulty::Hard => 30,
    };
    f64::from(turn * dice.below(360 / turn))
}

/// Two discs of the same size with these masses in grams.
pub(super) fn pair(m1_g: u32, m2_g: u32) -> Pieces {
    let disc = |mass_g| Disc::from_g_mm(f64::from(mass_g), 15.0);
    Pieces::Own {
        striker: disc(m1_g),
        target: disc(m2_g),
    }
}

/// The picture before the collision, without marks at the point where the discs will meet.
pub(super) fn unmarked(hit: &Hit) -> Illustration {
    Illustration::before(hit.collision(), Markings::FIGURES)
}

/// Describes the masses, the speed and the point of impact in words, but not the loss.
pub(super) fn in_short(hit: &Hit) -> String {
    let place = match hit.given {
        ImpactPoint::Angle { .. } => format!(
            "the line of impact is at {} to the striker's path",
            degrees(hit.alpha().abs())
        ),
        ImpactPoint::Offset { offset_mm } => format!(
            "the offset is {} mm, and r₁ + r₂ = {} mm",
            bare_millimetres(offset_mm.abs()),
            bare_millimetres(hit.reach_mm())
        ),
    };
    format!("{}; {place}.", hit.who("striker", &hit.hits()))
}

/// Describes the masses of smooth discs and the striker's speed in words, but not the point of
/// impact.
pub(super) fn off_centre(hit: &Hit) -> String {
    format!("{}, off-centre.", hit.who("smooth striker", &hit.hits()))
}

/// An angle in degrees, as printed.
pub(super) fn in_degrees(deg: impl Into<f64>) -> String {
    Measure::Angle.print(deg.into())
}

/// A number as the player reads it: rounded as it is printed.
pub(super) fn read_off(x: f64) -> f64 {
    Intermediate::new(x, |_| ()).value
}

pub(super) fn read_off_angle(angle: f64) -> f64 {
    Intermediate::angle(angle, |_| ()).value
}

/// The result calculated from rounded readings, followed by the exact result if the two differ.
pub(super) fn within_readings(found: &str, exact: &str) -> String {
    match found == exact {
        true => exact.to_owned(),
        false => format!("{found}, or {exact} within the reading error"),
    }
}

/// The index of a comparison among choices in the order less, the same, more.
pub(super) const fn place(compared: Ordering) -> usize {
    (compared as i8 + 1) as usize
}

/// Feedback for an answer that ignores the loss, including the actual value of e.
pub(super) fn here_e(says: &str, e: f64) -> String {
    format!("{says} Here e = {}.", significant(e))
}
