//! The tolerance of an angle, and the probability that a guess fits an answer.

/// The largest error, in degrees, with which an angle counts as right.
pub const RIGHT_DEG: f64 = 4.0;

/// The probability that two guessed rays fit two given rays: about 8° out of 90°, twice.
pub(super) const RAYS_BY_CHANCE: f64 = 0.01;
/// The probability that a guessed number, or a single guessed ray, fits a given one: about 8° out
/// of 90°, or ln 1.05 / ln 2 ≈ 0.07 if people guess within a factor of two.
pub(super) const NUMBER_BY_CHANCE: f64 = 0.08;

/// The relative error that is allowed for conversions between units.
pub(super) const ROUNDING: f64 = 1e-9;

/// Whether a number is in a range, or beyond the range by no more than the error allowed for a unit
/// conversion.
pub(super) fn is_within(x: f64, least: f64, most: f64) -> bool {
    let spare = ROUNDING * most;
    (least - spare..=most + spare).contains(&x)
}

/// The angle between two directions, in degrees from 0 to 180.
pub(super) fn apart_deg(a: f64, b: f64) -> f64 {
    let turn = (a - b).rem_euclid(360.0);
    turn.min(360.0 - turn)
}
