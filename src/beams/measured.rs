//! The counts of Geiger and Marsden.

use thiserror::Error;

use crate::files::{NumberSpec, quoted};

/// H. Geiger and E. Marsden, Phil. Mag. 25 (1913) 604, Table II, first series.
const TABLE: &str = include_str!("../../assets/geiger-marsden-1913.csv");

/// The columns of a table of counts.
const HEADER: &str = "angle_deg,silver_count,gold_count";

/// The range of an angle, in degrees.
const DEGREES: NumberSpec = NumberSpec::new("a number", "", 0.1, 180.0);
/// The range of a count.
const COUNT: NumberSpec = NumberSpec::new("a number", "", 0.1, 1e12);

/// Counts at one angle. Counts are relative: only those for the same metal can be compared with
/// each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Angle {
    /// Scattering angle φ in radians.
    pub angle: f64,
    /// Scintillations with a silver foil.
    pub silver: f64,
    /// Scintillations with a gold foil.
    pub gold: f64,
}

impl Angle {
    /// 1/sin⁴(φ/2), to which the counts should be proportional.
    pub fn law(&self) -> f64 {
        (self.angle / 2.0).sin().powi(-4)
    }
}

/// An error in a table of counts.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{line}: {what}")]
pub struct CountsFault {
    /// The line number, from 1; one more than the last if the table ends too early.
    pub line: usize,
    /// The error.
    pub what: String,
}

/// The counts of 1913, from the largest angle to the smallest.
///
/// # Errors
/// Returns an error only if the built-in table is damaged.
pub fn geiger_marsden() -> Result<Vec<Angle>, CountsFault> {
    read(TABLE)
}

/// Reads a table of counts: comma-separated values under the heading
/// `angle_deg,silver_count,gold_count`; a line that begins with `#` is a comment. Angles are from
/// 0.1 to 180, each smaller than the previous one; counts are from 0.1 to 10¹².
///
/// # Errors
/// Returns the first error in the table.
pub fn read(table: &str) -> Result<Vec<Angle>, CountsFault> {
    let mut lines = table
        .lines()
        .enumerate()
        .map(|(i, line)| (i + 1, line.trim()))
        .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let end = table.lines().count() + 1;
    let fault = |line, what| Err(CountsFault { line, what });
    match lines.next() {
        Some((_, HEADER)) => {}
        Some((line, other)) => {
            return fault(line, format!("expected {HEADER}, found {}", quoted(other)));
        }
        None => return fault(end, format!("expected {HEADER}, found nothing")),
    }
    let mut angles: Vec<Angle> = Vec::new();
    for (line, text) in lines {
        let fields: Vec<&str> = text.split(',').collect();
        let [angle_deg, silver, gold] = fields[..] else {
            return fault(line, format!("expected 3 values, found {}", fields.len()));
        };
        let read = |name, text: &str, spec: &NumberSpec| {
            let value = text.trim().parse().ok();
            value.filter(|value| spec.allows(*value)).ok_or_else(|| {
                let what = format!("{name}: expected {spec}, found {}", quoted(text.trim()));
                CountsFault { line, what }
            })
        };
        let next = Angle {
            angle: read("angle_deg", angle_deg, &DEGREES)?.to_radians(),
            silver: read("silver_count", silver, &COUNT)?,
            gold: read("gold_count", gold, &COUNT)?,
        };
        if angles.last().is_some_and(|last| last.angle <= next.angle) {
            return fault(
                line,
                "angle_deg: expected a smaller angle than on the previous line".into(),
            );
        }
        angles.push(next);
    }
    if angles.is_empty() {
        return fault(end, "expected counts, found nothing".into());
    }
    Ok(angles)
}

/// The counts for one metal compared with the law, which determines the ratios of the counts but
/// not their scale.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Mean of count × sin⁴(φ/2): the scale at which the relative deviations have the mean 0.
    pub scale: f64,
    /// Angle φ in radians, 1/sin⁴(φ/2), and the count.
    pub points: Vec<(f64, f64, f64)>,
}

impl Series {
    /// The series of one metal; `of` returns its count at an angle. `None` if there are no angles.
    pub fn new(angles: &[Angle], of: impl Fn(&Angle) -> f64) -> Option<Self> {
        let points: Vec<_> = angles
            .iter()
            .map(|angle| (angle.angle, angle.law(), of(angle)))
            .collect();
        let level: f64 = points.iter().map(|(_, law, count)| count / law).sum();
        (!points.is_empty()).then(|| Self {
            scale: level / points.len() as f64,
            points,
        })
    }

    /// The relative deviation of a count from the law, positive if the count is above the law.
    pub(crate) fn excess(&self, (_, law, count): (f64, f64, f64)) -> f64 {
        count / (law * self.scale) - 1.0
    }

    /// The smallest and the largest relative deviation of a count from the law.
    pub fn band(&self) -> (f64, f64) {
        let excess = self.points.iter().map(|point| self.excess(*point));
        excess.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), excess| {
            (low.min(excess), high.max(excess))
        })
    }
}
