//! Beams of many particles, thrown one by one and counted by the angle they leave at;
//! and what Geiger and Marsden counted.
//!
//! [`ScatteringLaw`] says how a particle is turned, [`Sampler`] throws the particles, [`Counts`]
//! holds the counts by angle. Everything follows from a seed: the generator and the way
//! from its numbers to offsets are part of what a seed means.

mod counts;
mod foil;
mod law;
mod measured;
mod sampler;
#[cfg(test)]
mod tests;

pub use counts::{BIN_WIDTH, BINS, CountedFor, Counts};
pub(crate) use foil::Metal;
pub use foil::{Foil, METALS};
pub use law::{BeamTarget, ScatteringLaw};
pub use measured::{Angle, Fault, Series, geiger_marsden, read};
pub use sampler::Sampler;
