//! Numbers of a file: what they stand for and how large they may be.

use std::fmt;

/// A kind of number with its unit and bounds, in the unit of the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NumberSpec {
    what: &'static str,
    unit: &'static str,
    /// The bounds, both allowed.
    bounds: Range,
}

impl NumberSpec {
    const fn new(what: &'static str, unit: &'static str, from: f64, to: f64) -> Self {
        let bounds = Range { from, to };
        Self { what, unit, bounds }
    }

    /// Whether a number lies within the bounds; one that is not finite never does.
    pub fn allows(&self, number: f64) -> bool {
        self.bounds.holds(number)
    }
}

impl fmt::Display for NumberSpec {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Range { from, to } = self.bounds;
        write!(f, "{} from {from} to {to}{}", self.what, self.unit)
    }
}

// The bounds keep every number where f64 has room to spare; they are far wider
// than anything that is still carrom.
pub(super) const SIDE: NumberSpec = NumberSpec::new("a side", " mm", 50.0, 100_000.0);
pub(super) const POCKET: NumberSpec = NumberSpec::new("a diameter", " mm", 0.0, 1000.0);
pub(super) const FRICTION: NumberSpec = NumberSpec::new("a coefficient of friction", "", 0.0, 10.0);
pub(super) const RESTITUTION: NumberSpec = NumberSpec::new("a restitution", "", 0.0, 1.0);
pub(super) const MASS: NumberSpec = NumberSpec::new("a mass", " g", 0.001, 100_000.0);
pub(super) const RADIUS: NumberSpec = NumberSpec::new("a radius", " mm", 0.1, 1000.0);
pub(super) const COORDINATE: NumberSpec = NumberSpec::new("each", " mm", -50_000.0, 50_000.0);
pub(super) const DIRECTION: NumberSpec = NumberSpec::new("a direction", " degrees", -360.0, 360.0);
pub(super) const SPEED: NumberSpec = NumberSpec::new("a speed", " m/s", 0.0, 100.0);
pub(super) const ANGLE: NumberSpec = NumberSpec::new("an angle", " degrees", 0.0, 180.0);
pub(super) const PERCENT: NumberSpec = NumberSpec::new("a share", " percent", 0.0, 100.0);

/// Two bounds, both included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// The lower bound.
    pub from: f64,
    /// The upper bound.
    pub to: f64,
}

impl Range {
    /// Whether a number lies between the bounds.
    pub fn holds(&self, number: f64) -> bool {
        (self.from..=self.to).contains(&number)
    }

    /// The number between the bounds that is nearest.
    pub fn nearest(&self, number: f64) -> f64 {
        number.max(self.from).min(self.to)
    }

    /// The number that divides the range as `share`, 0 to 1, says.
    pub fn at(&self, share: f64) -> f64 {
        self.from + share * (self.to - self.from)
    }

    /// Distance between the bounds.
    pub fn width(&self) -> f64 {
        self.to - self.from
    }

    /// Both bounds times a factor above 0: the change of a unit.
    pub(super) fn scaled(&self, factor: f64) -> Self {
        Self {
            from: self.from * factor,
            to: self.to * factor,
        }
    }
}
