//! The numbers in a level, with their ranges.

use crate::files::NumberSpec;

// Within these bounds, which are far wider than any carrom board needs, f64 is precise enough.
pub(super) const SIDE: NumberSpec = NumberSpec::new("a side", " mm", 50.0, 100_000.0);
pub(super) const POCKET: NumberSpec = NumberSpec::new("a diameter", " mm", 0.0, 1000.0);
pub(super) const FRICTION: NumberSpec = NumberSpec::new("a coefficient of friction", "", 0.0, 10.0);
pub(super) const RESTITUTION: NumberSpec =
    NumberSpec::new("a coefficient of restitution", "", 0.0, 1.0);
pub(super) const MASS: NumberSpec = NumberSpec::new("a mass", " g", 0.001, 100_000.0);
pub(super) const RADIUS: NumberSpec = NumberSpec::new("a radius", " mm", 0.1, 1000.0);
pub(super) const COORDINATE: NumberSpec = NumberSpec::new("each", " mm", -50_000.0, 50_000.0);
pub(super) const DIRECTION: NumberSpec = NumberSpec::new("a direction", " degrees", -360.0, 360.0);
pub(super) const SPEED: NumberSpec = NumberSpec::new("a speed", " m/s", 0.0, 100.0);
pub(super) const ANGLE: NumberSpec = NumberSpec::new("an angle", " degrees", 0.0, 180.0);
pub(super) const PERCENT: NumberSpec = NumberSpec::new("a share", " percent", 0.0, 100.0);
