//! The meaning and range of numbers in files.

use std::fmt;

/// A kind of number with its unit and bounds, in the unit of the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NumberSpec {
    what: &'static str,
    unit: &'static str,
    bounds: Range,
}

impl NumberSpec {
    /// A kind of number: `what` describes it, such as "a mass"; `unit` is the text after the
    /// number, such as " g"; the bounds are inclusive.
    pub(crate) const fn new(what: &'static str, unit: &'static str, from: f64, to: f64) -> Self {
        let bounds = Range { from, to };
        Self { what, unit, bounds }
    }

    /// Whether a number is within the bounds; a number that is not finite never is.
    pub(crate) fn allows(&self, number: f64) -> bool {
        self.bounds.holds(number)
    }
}

impl fmt::Display for NumberSpec {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Range { from, to } = self.bounds;
        write!(f, "{} from {from} to {to}{}", self.what, self.unit)
    }
}

/// Two inclusive bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// The lower bound.
    pub from: f64,
    /// The upper bound.
    pub to: f64,
}

impl Range {
    /// Whether a number is within the bounds.
    pub(crate) fn holds(&self, number: f64) -> bool {
        (self.from..=self.to).contains(&number)
    }

    /// The nearest number within the bounds.
    pub(crate) fn nearest(&self, number: f64) -> f64 {
        number.max(self.from).min(self.to)
    }

    /// The number at a fraction `share`, from 0 to 1, of the way from the lower bound to the upper.
    pub(crate) fn at(&self, share: f64) -> f64 {
        self.from + share * (self.to - self.from)
    }

    /// Both bounds times a positive factor, for another unit.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        Self {
            from: self.from * factor,
            to: self.to * factor,
        }
    }
}
