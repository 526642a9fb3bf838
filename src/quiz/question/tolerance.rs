//! The tolerances for every kind of answer.

/// The largest error, in degrees, with which an angle counts as right.
pub const RIGHT_DEG: f64 = 4.0;

/// The probability that two guessed rays fit two given rays: about 8° out of 90°, twice.
pub(super) const RAYS_BY_CHANCE: f64 = 0.01;
/// The probability that a guessed number, or a single guessed ray, fits a given one: about 8° out
/// of 90°, or a tenth of the range in which people guess, which spans a factor of two.
pub(super) const NUMBER_BY_CHANCE: f64 = 0.08;

/// The largest relative error that a conversion between two units can cause.
pub(super) const ROUNDING: f64 = 1e-9;

/// Whether a number is in a range, or beyond the range by no more than the rounding error of a unit
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
