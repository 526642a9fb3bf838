//! The random particles of a beam.

use std::ops::Range;

use rand::Rng;
use rand_pcg::Pcg64;

use super::{BIN_WIDTH, BINS, Counts, ScatteringLaw};

/// Stream of the generator; part of the meaning of a seed.
const STREAM: u128 = 0x0a02_bdbf_7bb3_c0a7;

/// The number of cells of the index table, a power of two. 4096 bytes fit in the fastest cache.
const CELLS: usize = 4096;

/// Length of the tables of bins: a power of two, so that `% PLACES`, which keeps every index in
/// range, is fast.
const PLACES: usize = 64;

/// The number of particles that are computed in parallel, so that no step has to wait for the
/// result of the step before.
const LANES: usize = 4;

/// Draws the particles of a beam and counts them by angle.
///
/// Particle i uses the i-th 64-bit number w of PCG64 (M. E. O'Neill, 2014; the seed is its state,
/// the stream is fixed). In a plane, w/2⁶⁴ is the nearness b/b_max; in space it is the square of
/// the nearness, so that offsets are uniform over a line or over a disc. Because each particle has
/// its own number, a beam can be computed in batches of any size and in any order.
///
/// No angle is ever computed for a particle. The values of w that separate the bins are calculated
/// in advance, so comparisons give the bin: an index table gives the lowest possible bin for the
/// upper 12 bits of w, and w is compared with the edges from that bin on. The counts are exactly
/// the same as if each angle were computed.
#[derive(Debug, Clone)]
pub struct Sampler {
    /// A particle with w below `edges[k]` is scattered beyond the lower edge of bin k.
    edges: [u64; PLACES],
    /// The lowest bin in a cell of w.
    lowest: [u8; CELLS],
}

impl Sampler {
    /// A sampler for a law.
    pub fn new(law: &ScatteringLaw) -> Self {
        let mut edges = [0; PLACES];
        for (bin, edge) in edges.iter_mut().enumerate().take(BINS) {
            // The cast truncates, and it clamps 2⁶⁴, the value for the whole beam, to `u64::MAX`.
            let share = law.share_beyond(bin as f64 * BIN_WIDTH);
            *edge = (share * 2_f64.powi(64)) as u64;
        }
        let mut sampler = Self {
            edges,
            lowest: [0; CELLS],
        };
        let cell = u64::MAX / CELLS as u64 + 1;
        for i in 0..CELLS {
            let last = (i as u64).wrapping_mul(cell).wrapping_add(cell - 1);
            sampler.lowest[i] = sampler.search(0, last) as u8;
        }
        sampler
    }

    /// The bin of `w`, which is bin `from` or a later one.
    fn search(&self, from: usize, w: u64) -> usize {
        let mut bin = from;
        // The edges end with zeros, and no `w` is below 0.
        while w < self.edges[(bin + 1) % PLACES] {
            bin += 1;
        }
        bin
    }

    fn bin(&self, w: u64) -> usize {
        let cell = (w >> (u64::BITS - CELLS.ilog2())) as usize % CELLS;
        self.search(usize::from(self.lowest[cell]), w) % PLACES
    }

    /// Computes the particles with these numbers in a seed's beam and adds them to `counts`.
    pub fn throw(&self, seed: u64, particles: Range<u64>, counts: &mut Counts) {
        let mut tallies = [[0_u64; PLACES]; LANES];
        let length = particles.end.saturating_sub(particles.start);
        let share = length / LANES as u64;
        let mut generators: [Pcg64; LANES] =
            std::array::from_fn(|lane| generator(seed, particles.start + lane as u64 * share));
        for _ in 0..share {
            for (generator, tally) in generators.iter_mut().zip(&mut tallies) {
                tally[self.bin(generator.next_u64())] += 1;
            }
        }
        let mut rest = generator(seed, particles.start + LANES as u64 * share);
        for _ in LANES as u64 * share..length {
            tallies[0][self.bin(rest.next_u64())] += 1;
        }
        for tally in tallies {
            for (count, new) in counts.bins.iter_mut().zip(tally) {
                *count += new;
            }
        }
    }
}

/// The generator for a seed, advanced so that its next number belongs to this particle.
pub(super) fn generator(seed: u64, particle: u64) -> Pcg64 {
    let mut generator = Pcg64::new(u128::from(seed), STREAM);
    generator.advance(u128::from(particle));
    generator
}
