//! The counts of Geiger and Marsden.

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

/// The counts of 1913, from the largest angle to the smallest: H. Geiger and E. Marsden, Phil. Mag.
/// 25 (1913) 604, Table II, first series. The second series, at smaller angles, has another
/// arbitrary scale, so it must not be joined to this one.
pub const GEIGER_MARSDEN: [Angle; 11] = [
    counts(150.0, 22.2, 33.1),
    counts(135.0, 27.4, 43.0),
    counts(120.0, 33.0, 51.9),
    counts(105.0, 47.3, 69.5),
    counts(75.0, 136.0, 211.0),
    counts(60.0, 320.0, 477.0),
    counts(45.0, 989.0, 1435.0),
    counts(37.5, 1760.0, 3300.0),
    counts(30.0, 5260.0, 7800.0),
    counts(22.5, 20_300.0, 27_300.0),
    counts(15.0, 105_400.0, 132_000.0),
];

const fn counts(angle_deg: f64, silver: f64, gold: f64) -> Angle {
    Angle {
        angle: angle_deg.to_radians(),
        silver,
        gold,
    }
}

impl Angle {
    /// 1/sin⁴(φ/2), to which the counts should be proportional.
    pub fn law(&self) -> f64 {
        (self.angle / 2.0).sin().powi(-4)
    }
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
    /// The series of one metal; `of` returns its count at an angle.
    pub fn new(of: impl Fn(&Angle) -> f64) -> Self {
        let points = GEIGER_MARSDEN.iter();
        let points = points.map(|angle| (angle.angle, angle.law(), of(angle)));
        let points: Vec<_> = points.collect();
        let level: f64 = points.iter().map(|(_, law, count)| count / law).sum();
        Self {
            scale: level / points.len() as f64,
            points,
        }
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
