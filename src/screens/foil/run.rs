//! A running beam.

use crate::beams::{BINS, Counts, Sampler, ScatteringLaw};

/// The number of frames that a beam lasts, unless [`MOST`] makes it longer: about four seconds, so
/// that the counts grow visibly.
const PICTURES: u64 = 240;

/// The maximum number of particles per frame; computing them takes less than ten milliseconds.
const MOST: u64 = 2_000_000;

/// A beam and its progress.
#[derive(Debug, Clone)]
pub(super) struct BeamRun {
    pub(super) law: ScatteringLaw,
    sampler: Sampler,
    seed: u64,
    pub(super) particles: u64,
    pub(super) counts: Counts,
    /// Whether the player has stopped the beam.
    pub(super) halted: bool,
    /// The player's prediction of the share, if there is one.
    pub(super) said: Option<f64>,
}

impl BeamRun {
    /// A beam of `particles` that has not started yet.
    pub(super) fn new(law: ScatteringLaw, seed: u64, particles: u64, said: Option<f64>) -> Self {
        Self {
            law,
            sampler: Sampler::new(&law),
            seed,
            particles,
            counts: Counts::default(),
            halted: false,
            said,
        }
    }

    /// Particles sent so far.
    pub(super) fn thrown(&self) -> u64 {
        self.counts.total()
    }

    /// Whether all particles have been computed.
    pub(super) fn is_over(&self) -> bool {
        self.thrown() >= self.particles
    }

    /// Whether there are particles left to compute and the beam has not been stopped.
    pub(super) fn is_running(&self) -> bool {
        !self.halted && !self.is_over()
    }

    /// Computes the particles for the next frame.
    pub(super) fn advance(&mut self) {
        if self.is_running() {
            let thrown = self.thrown();
            let slice = self.particles.div_ceil(PICTURES).min(MOST);
            let end = self.particles.min(thrown + slice);
            self.sampler.throw(self.seed, thrown..end, &mut self.counts);
        }
    }

    /// The share deflected by more than 90° so far; `None` before the first particle.
    pub(super) fn share_turned_back(&self) -> Option<f64> {
        let back = self.counts.beyond_bin(BINS / 2);
        (self.thrown() > 0).then(|| back as f64 / self.thrown() as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::super::setup::FoilSetup;
    use super::*;

    #[test]
    fn a_beam_of_any_size_sends_all_its_particles() {
        for particles in [1, 239, 1000, 1_000_000] {
            let law = FoilSetup::default().law();
            let mut run = BeamRun::new(law, 3, particles, None);
            while run.is_running() {
                run.advance();
            }
            assert_eq!(run.thrown(), particles);
            let mut whole = Counts::default();
            Sampler::new(&law).throw(3, 0..particles, &mut whole);
            assert_eq!(run.counts, whole);
            run.advance();
            assert_eq!(run.thrown(), particles);
        }
    }

    #[test]
    fn a_halted_beam_sends_no_particles() {
        let mut run = BeamRun::new(FoilSetup::default().law(), 3, 100_000_000, None);
        run.advance();
        let thrown = run.thrown();
        assert!(thrown > 0 && thrown <= MOST);
        run.halted = true;
        run.advance();
        assert_eq!(run.thrown(), thrown);
        run.halted = false;
        run.advance();
        assert!(run.thrown() > thrown);
    }
}
