//! The tolerance of every kind of answer.

/// The largest error in degrees with which an angle counts as right.
pub const RIGHT_DEG: f64 = 4.0;

/// The chance that two guessed rays fit two given ones: about 8° out of 90°, twice.
pub(super) const RAYS_BY_CHANCE: f64 = 0.01;
/// The chance that a guessed number, or one guessed ray, fits a given one: about 8° out of 90°, or
/// a tenth of the range within which people guess, which is a factor of two.
pub(super) const NUMBER_BY_CHANCE: f64 = 0.08;

/// The relative error from converting between two units.
pub(super) const ROUNDING: f64 = 1e-9;

/// Whether a number lies within a range, or beyond one of its ends by no more than the rounding
/// error of a unit conversion.
pub(super) fn is_within(x: f64, least: f64, most: f64) -> bool {
    let spare = ROUNDING * most;
    (least - spare..=most + spare).contains(&x)
}

/// The angle between two directions in degrees, 0 to 180.
pub(super) fn apart_deg(a: f64, b: f64) -> f64 {
    let turn = (a - b).rem_euclid(360.0);
    turn.min(360.0 - turn)
}
