//! Beams of many particles, scattered one by one and counted by angle, and the counts of Geiger and
//! Marsden.
//!
//! [`ScatteringLaw`] gives the angle of a particle, [`Sampler`] draws the particles, [`Counts`]
//! contains the counts by angle. Everything follows from a seed: the generator and the mapping from
//! its numbers to offsets are part of the meaning of a seed.

mod counts;
mod foil;
mod law;
mod measured;
mod sampler;
#[cfg(test)]
mod tests;

pub use counts::{BIN_WIDTH, BINS, CountedFor, Counts};
pub use foil::{METALS, Metal};
pub use law::{BeamTarget, ScatteringLaw};
pub use measured::{Angle, GEIGER_MARSDEN, Series};
pub use sampler::Sampler;
