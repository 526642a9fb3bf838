//! The counts of a beam by scattering angle.

use std::f64::consts::PI;

use super::ScatteringLaw;

/// Bins of equal width from 0 to 180°.
pub const BINS: usize = 36;

/// Width of a bin in radians: 5°.
pub const BIN_WIDTH: f64 = PI / BINS as f64;

/// The unit of a count: particles per steradian or per ring.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CountedFor {
    /// A steradian of solid angle: the count on a small screen that is moved around the target, as
    /// in the experiment of Geiger and Marsden.
    #[default]
    Steradian,
    /// A whole ring of 5° around the beam; a ring is larger at 90° than near 0° or 180°.
    Ring,
}

impl CountedFor {
    /// The other unit.
    #[must_use]
    pub fn other(self) -> Self {
        match self {
            Self::Steradian => Self::Ring,
            Self::Ring => Self::Steradian,
        }
    }

    /// The size of a bin in this unit: 1 ring, or 2π (cos from − cos to) steradians.
    pub fn in_bin(self, bin: usize) -> f64 {
        let cosine = |edge: usize| (edge as f64 * BIN_WIDTH).cos();
        match self {
            Self::Steradian => 2.0 * PI * (cosine(bin) - cosine(bin + 1)),
            Self::Ring => 1.0,
        }
    }
}

/// The number of particles by angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Counts {
    /// Particles in each bin, from 0 to 180°. A particle exactly at the edge of two bins is in the
    /// lower one.
    pub bins: [u64; BINS],
}

impl Default for Counts {
    fn default() -> Self {
        Self { bins: [0; BINS] }
    }
}

impl Counts {
    pub(crate) fn total(&self) -> u64 {
        self.bins.iter().sum()
    }

    /// The number of particles in bin `first` and all later bins.
    pub(crate) fn beyond_bin(&self, first: usize) -> u64 {
        self.bins.iter().skip(first).sum()
    }

    /// The counts that a law predicts for `particles` particles, bin by bin.
    pub fn expected(law: &ScatteringLaw, particles: u64) -> [f64; BINS] {
        std::array::from_fn(|bin| {
            let beyond = |edge: usize| law.share_beyond(edge as f64 * BIN_WIDTH);
            particles as f64 * (beyond(bin) - beyond(bin + 1))
        })
    }
}
