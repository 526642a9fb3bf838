//! What a number that is asked for measures.

use super::words;

/// What a number that is asked for measures: its unit, how it is printed, and how near
/// is near enough.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// An angle in degrees.
    Angle,
    /// A share of a whole in percent.
    Share,
    /// A speed in m/s.
    Speed,
    /// A mass in grams.
    Mass,
    /// A length in millimetres.
    Length,
    /// How many times as much.
    Times,
    /// A coefficient of restitution.
    Restitution,
}

impl Quantity {
    /// The unit behind a number, as typed beside it; empty for a pure number.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Angle => "°",
            Self::Share => "%",
            Self::Speed => "m/s",
            Self::Mass => "g",
            Self::Length => "mm",
            Self::Times => "times",
            Self::Restitution => "",
        }
    }

    /// Its name in files, with which a number is kept: "angle_deg".
    pub const fn id(self) -> &'static str {
        match self {
            Self::Angle => "angle_deg",
            Self::Share => "share_percent",
            Self::Speed => "speed",
            Self::Mass => "mass_g",
            Self::Length => "length_mm",
            Self::Times => "times",
            Self::Restitution => "restitution",
        }
    }

    /// A number as printed, with its unit: "63.4°", "25.0 %", "2.12 m/s".
    pub fn print(self, x: f64) -> String {
        let bare = self.print_bare(x);
        match self {
            Self::Angle => format!("{bare}°"),
            Self::Restitution => bare,
            _ => format!("{bare} {}", self.unit()),
        }
    }

    /// The same without its unit.
    pub fn print_bare(self, x: f64) -> String {
        match self {
            Self::Angle => words::bare_degrees(x.to_radians()),
            Self::Length => words::bare_millimetres(x + 0.0),
            _ => words::significant(x + 0.0),
        }
    }

    /// How far `said` is from `truth`, counted in what still counts as right: 1 is the
    /// edge. Angles count by 4°, shares by 4 percentage points, e by 0.04, all others
    /// by a twentieth of the truth either way, as a ratio; infinite where a ratio says
    /// nothing.
    pub fn distance(self, said: f64, truth: f64) -> f64 {
        match self {
            Self::Angle => {
                let turn = (said - truth).rem_euclid(360.0);
                turn.min(360.0 - turn) / super::grade::RIGHT_DEG
            }
            Self::Share => (said - truth).abs() / 4.0,
            Self::Restitution => (said - truth).abs() / 0.04,
            Self::Speed | Self::Mass | Self::Length | Self::Times => {
                let ratio = said / truth;
                if said == truth {
                    0.0
                } else if ratio > 0.0 && ratio.is_finite() {
                    ratio.ln().abs() / 1.05_f64.ln()
                } else {
                    f64::INFINITY
                }
            }
        }
    }

    /// The largest number that makes sense and can be typed; the smallest is 0, but for
    /// angles its opposite.
    pub const fn largest(self) -> f64 {
        match self {
            Self::Angle => 180.0,
            Self::Share => 100.0,
            Self::Restitution => 1.0,
            Self::Speed | Self::Mass | Self::Length | Self::Times => 99_999.0,
        }
    }

    /// The smallest number that makes sense.
    pub const fn smallest(self) -> f64 {
        match self {
            Self::Angle => -180.0,
            _ => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_printed_with_sense() {
        for (quantity, x, text) in [
            (Quantity::Angle, 63.434_948, "63.4°"),
            (Quantity::Share, 25.0, "25.0 %"),
            (Quantity::Speed, 2.121_32, "2.12 m/s"),
            (Quantity::Mass, 5.5, "5.50 g"),
            (Quantity::Length, 15.0, "15.0 mm"),
            (Quantity::Times, 16.0, "16.0 times"),
            (Quantity::Restitution, 0.5, "0.500"),
        ] {
            assert_eq!(quantity.print(x), text);
        }
    }

    #[test]
    fn near_enough_is_one_and_ratios_count_both_ways_alike() {
        assert!((Quantity::Angle.distance(64.0, 60.0) - 1.0).abs() < 1e-12);
        assert!((Quantity::Angle.distance(-179.0, 179.0) - 0.5).abs() < 1e-12);
        assert!((Quantity::Speed.distance(2.1, 2.0) - 1.0).abs() < 1e-12);
        let (up, down) = (
            Quantity::Times.distance(2.0, 1.0),
            Quantity::Times.distance(0.5, 1.0),
        );
        assert!((up - down).abs() < 1e-12);
        assert!(Quantity::Mass.distance(0.0, 15.0).is_infinite());
        assert!(Quantity::Mass.distance(-1.0, 15.0).is_infinite());
        assert!(Quantity::Speed.distance(0.0, 0.0) <= 0.0);
    }
}
