//! An axis: its quantity, range and scale.

use super::ticks::{Tick, decades, even};

/// An axis of a plot.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Axis {
    /// The name of the quantity, with its unit.
    pub(super) name: String,
    from: f64,
    to: f64,
    scale: AxisScale,
    /// The preferred distance between ticks, if there is one.
    step: Option<f64>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum AxisScale {
    Linear,
    Log,
}

impl Axis {
    /// A linear axis. `name` should contain the unit, and `from` should be below `to`.
    pub(crate) fn linear(name: impl Into<String>, from: f64, to: f64) -> Self {
        Self {
            name: name.into(),
            from,
            to,
            scale: AxisScale::Linear,
            step: None,
        }
    }

    /// A logarithmic axis, for 0 < `from` < `to`. Values of 0 and below have no position on this
    /// axis.
    pub(crate) fn log(name: impl Into<String>, from: f64, to: f64) -> Self {
        Self {
            scale: AxisScale::Log,
            ..Self::linear(name, from, to)
        }
    }

    /// This axis with ticks at the multiples of `step`, if there is room; `step` has no effect on a
    /// logarithmic axis.
    #[must_use]
    pub(crate) fn every(mut self, step: f64) -> Self {
        self.step = Some(step);
        self
    }

    /// The position of a value, in units in which the axis is linear; `None` if the value has no
    /// position on any axis with this scale.
    pub(crate) fn place(&self, value: f64) -> Option<f64> {
        let place = match self.scale {
            AxisScale::Linear => value,
            AxisScale::Log => value.log10(),
        };
        place.is_finite().then_some(place)
    }

    /// The value at a position.
    pub(super) fn value(&self, place: f64) -> f64 {
        match self.scale {
            AxisScale::Linear => place,
            AxisScale::Log => 10_f64.powf(place),
        }
    }

    /// The positions of the two ends, in ascending order even if `from` and `to` are not.
    pub(crate) fn ends(&self) -> (f64, f64) {
        match (self.place(self.from), self.place(self.to)) {
            (Some(from), Some(to)) if from < to => (from, to),
            (Some(from), _) => (from, from + 1.0),
            (None, _) => (0.0, 1.0),
        }
    }

    /// The ticks of this axis: no more than about `most` of them.
    pub(crate) fn ticks(&self, most: usize) -> Vec<Tick> {
        let ends = self.ends();
        match self.scale {
            AxisScale::Linear => even(ends, self.step, most),
            AxisScale::Log => decades(ends, most),
        }
    }
}
