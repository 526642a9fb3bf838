//! The quantity that a number in an answer measures.

use super::tolerance::{RIGHT_DEG, ROUNDING, apart_deg, is_within};
use crate::numbers;

/// The quantity that a number in an answer measures, with its unit, its printed form and its
/// tolerance.
#[derive(Debug, Clone, PartialEq)]
pub enum Measure {
    /// An angle in degrees.
    Angle,
    /// A fraction of a whole, in percent.
    Share,
    /// A speed in m/s.
    Speed,
    /// A mass in grams.
    Mass,
    /// A length in millimetres.
    Length,
    /// A factor, without a unit.
    Times,
    /// A coefficient of restitution.
    Restitution,
    /// A number in the answer to a chapter's question, in any unit and with its own tolerance.
    Own {
        /// The symbol in formulas, such as "θ₁".
        sign: String,
        /// The unit of the number.
        unit: String,
        /// The largest error with which a number counts as right.
        tolerance: f64,
        /// The smallest and the largest permitted number.
        range: (f64, f64),
    },
}

/// The largest permitted number of a measure without a natural limit.
const LARGEST: f64 = 99_999.0;

impl Measure {
    /// The tolerances in words; for the rules see [`distance`](Self::distance).
    pub(crate) const RIGHT: &str = "an angle, a share or e within a tenth of the true value, but \
                                    never more than 4°, 4 percentage points or 0.04 off; any other \
                                    number within a twentieth";

    /// The unit printed after a number; empty for a pure number.
    pub fn unit(&self) -> &str {
        self.row().0
    }

    /// The name in files under which a number is stored: "angle_deg".
    pub fn id(&self) -> &'static str {
        self.row().1
    }

    /// The measure with this [`id`](Self::id).
    pub fn with_id(id: &str) -> Option<Self> {
        let mut all = [
            Self::Angle,
            Self::Share,
            Self::Speed,
            Self::Mass,
            Self::Length,
            Self::Times,
            Self::Restitution,
        ]
        .into_iter();
        all.find(|measure| measure.id() == id)
    }

    /// The unit, the name in files, the largest permitted number, and the limits of the tolerance.
    fn row(&self) -> (&str, &'static str, f64, Option<[f64; 2]>) {
        match self {
            Self::Angle => ("°", "angle_deg", 180.0, Some([1.0, RIGHT_DEG])),
            Self::Share => ("%", "share_percent", 100.0, Some([0.2, 4.0])),
            Self::Speed => ("m/s", "speed", LARGEST, None),
            Self::Mass => ("g", "mass_g", LARGEST, None),
            Self::Length => ("mm", "length_mm", LARGEST, None),
            Self::Times => ("times", "times", LARGEST, None),
            Self::Restitution => ("", "restitution", 1.0, Some([0.01, 0.04])),
            Self::Own { unit, range, .. } => (unit, "number", range.1, None),
        }
    }

    /// The smallest and the largest tolerance of a measure whose tolerance is a tenth of the true
    /// value.
    fn limits(&self) -> Option<[f64; 2]> {
        self.row().3
    }

    /// A number as printed, with its unit: "63.4°", "25.0 %", "2.12 m/s".
    pub fn print(&self, x: f64) -> String {
        let bare = match self {
            Self::Angle => numbers::bare_degrees(x.to_radians()),
            Self::Length => numbers::bare_millimetres(x + 0.0),
            Self::Own { tolerance, .. } => {
                // The number of decimal places depends on the tolerance.
                let decimals = (1.0 - tolerance.log10()).clamp(0.0, 6.0) as usize;
                numbers::true_minus(&numbers::fixed(x, decimals))
            }
            _ => numbers::significant(x + 0.0),
        };
        numbers::with_unit(&bare, self.unit())
    }

    /// The distance of `said` from `truth` in units of the tolerance.
    ///
    /// The tolerance of an angle, a share or e is a tenth of the true value, but at most 4°, 4
    /// percentage points or 0.04, because a large value can be read or calculated more accurately
    /// than that, and at least 1°, a fifth of a point or 0.01. A number with its own tolerance uses
    /// that. For all other quantities the larger of the two numbers may exceed the smaller by up to
    /// a twentieth of the smaller; if they differ and their ratio is not a positive number, the
    /// distance is infinite.
    pub fn distance(&self, said: f64, truth: f64) -> f64 {
        self.spacing(said, truth) / self.width(truth)
    }

    /// The tolerance for this `truth`, as a fraction of the largest tolerance.
    pub(in crate::quiz) fn width(&self, truth: f64) -> f64 {
        let near = |[least, most]: [f64; 2]| (truth.abs() / 10.0).clamp(least, most) / most;
        self.limits().map_or(1.0, near)
    }

    /// The largest error with which a number counts as `truth`. If numbers are compared by their
    /// ratio, this is the upward error, which is larger than the downward one.
    pub(crate) fn tolerance(&self, truth: f64) -> f64 {
        let largest = match (self, self.limits()) {
            (_, Some([_, most])) => most,
            (Self::Own { tolerance, .. }, _) => *tolerance,
            _ => truth.abs() / 20.0,
        };
        largest * self.width(truth)
    }

    /// The difference between two numbers in units of the largest tolerance. It is never more than
    /// their [`distance`](Self::distance). This value is used to choose questions whose answers are
    /// clearly different, so the codes of rounds depend on it and it must not change.
    pub(crate) fn spacing(&self, a: f64, b: f64) -> f64 {
        match (self, self.limits()) {
            (Self::Angle, _) => apart_deg(a, b) / RIGHT_DEG,
            (_, Some([_, most])) => (a - b).abs() / most,
            // A number exactly at the limit is right, in spite of rounding errors.
            (Self::Own { tolerance, .. }, _) => ((a - b).abs() / tolerance - ROUNDING).max(0.0),
            _ => {
                let ratio = a / b;
                if a == b {
                    0.0
                } else if ratio > 0.0 && ratio.is_finite() {
                    ratio.ln().abs() / 1.05_f64.ln()
                } else {
                    f64::INFINITY
                }
            }
        }
    }

    /// The largest permitted number.
    pub fn largest(&self) -> f64 {
        self.row().2
    }

    /// The smallest permitted number.
    pub fn smallest(&self) -> f64 {
        match self {
            Self::Angle => -self.largest(),
            Self::Own { range, .. } => range.0,
            _ => 0.0,
        }
    }

    /// Whether a number is permitted.
    pub(crate) fn allows(&self, x: f64) -> bool {
        is_within(x, self.smallest(), self.largest())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_printed_with_sensible_precision() {
        for (quantity, x, text) in [
            (Measure::Angle, 63.434_948, "63.4°"),
            (Measure::Share, 25.0, "25.0 %"),
            (Measure::Speed, 2.121_32, "2.12 m/s"),
            (Measure::Mass, 5.5, "5.50 g"),
            (Measure::Length, 15.0, "15.0 mm"),
            (Measure::Times, 16.0, "16.0 times"),
            (Measure::Restitution, 0.5, "0.500"),
        ] {
            assert_eq!(quantity.print(x), text);
        }
    }

    #[test]
    fn the_limit_is_at_distance_one_and_ratios_are_symmetric() {
        assert!((Measure::Angle.distance(64.0, 60.0) - 1.0).abs() < 1e-12);
        assert!((Measure::Angle.distance(-179.0, 179.0) - 0.5).abs() < 1e-12);
        assert!((Measure::Speed.distance(2.1, 2.0) - 1.0).abs() < 1e-12);
        let (up, down) = (
            Measure::Times.distance(2.0, 1.0),
            Measure::Times.distance(0.5, 1.0),
        );
        assert!((up - down).abs() < 1e-12);
        assert!(Measure::Mass.distance(0.0, 15.0).is_infinite());
        assert!(Measure::Mass.distance(-1.0, 15.0).is_infinite());
        assert!(Measure::Speed.distance(0.0, 0.0) <= 0.0);
    }

    #[test]
    fn the_tolerance_is_relative_for_small_numbers_and_absolute_for_large_ones() {
        for (quantity, said, truth, right) in [
            (Measure::Angle, 14.0, 10.2, false),
            (Measure::Angle, 11.0, 10.2, true),
            (Measure::Angle, -177.0, 180.0, true),
            (Measure::Share, 4.0, 6.7, false),
            (Measure::Share, 7.0, 6.7, true),
            (Measure::Share, 6.0, 6.7, false),
            (Measure::Share, 22.0, 25.0, false),
            (Measure::Share, 72.0, 75.0, true),
            (Measure::Share, 90.0, 93.3, true),
            (Measure::Share, 70.5, 75.0, false),
            (Measure::Share, 0.1, 0.0, true),
            (Measure::Restitution, 0.22, 0.2, true),
            (Measure::Restitution, 0.24, 0.2, false),
            (Measure::Restitution, 0.77, 0.8, true),
            (Measure::Restitution, 0.75, 0.8, false),
        ] {
            let distance = quantity.distance(said, truth);
            assert_eq!(distance < 1.0 + 1e-9, right, "{quantity:?} {said} {truth}");
        }
    }

    /// Because the distance is never less than the spacing, an answer that fits the right answer or
    /// that of a misconception fits none of the others, provided that these are far enough apart.
    #[test]
    fn the_distance_is_never_less_than_the_spacing() {
        for quantity in [Measure::Angle, Measure::Share, Measure::Restitution] {
            for (said, truth) in (0..=100).flat_map(|a| (0..=100).map(move |b| (a, b))) {
                let scale = quantity.largest().min(100.0) / 100.0;
                let (said, truth) = (scale * f64::from(said), scale * f64::from(truth));
                assert!(quantity.distance(said, truth) >= quantity.spacing(said, truth));
            }
        }
    }
}
