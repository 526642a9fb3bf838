//! Counts by angle.

use std::f64::consts::PI;

use super::ScatteringLaw;

/// Bins of equal width from 0 to 180°.
pub const BINS: usize = 36;

/// Width of a bin in radians: 5°.
pub const BIN_WIDTH: f64 = PI / BINS as f64;

/// How many particles left at which angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Counts {
    /// Particles in each bin, from 0 to 180°. One that left exactly at the edge of two
    /// bins is in the lower one.
    pub bins: [u64; BINS],
}

impl Default for Counts {
    fn default() -> Self {
        Self { bins: [0; BINS] }
    }
}

impl Counts {
    /// All particles that were counted.
    pub fn total(&self) -> u64 {
        self.bins.iter().sum()
    }

    /// Those from the edge below bin `first` on.
    pub fn from_bin(&self, first: usize) -> u64 {
        self.bins.iter().skip(first).sum()
    }

    /// What a law leads one to expect of `particles`, bin by bin.
    pub fn expected(law: &ScatteringLaw, particles: u64) -> [f64; BINS] {
        std::array::from_fn(|bin| {
            let beyond = |edge: usize| law.share_beyond(edge as f64 * BIN_WIDTH);
            particles as f64 * (beyond(bin) - beyond(bin + 1))
        })
    }
}
