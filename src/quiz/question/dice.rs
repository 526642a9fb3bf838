//! The random choices of a round.

use rand::Rng;
use rand_pcg::Pcg32;

/// The generator's stream number, on which the codes of rounds depend.
const STREAM: u64 = 0x0a02_bdbf_7bb3_c0a7;

/// A source of random choices that are determined by a seed and are the same on every machine.
///
/// The generator is PCG-XSH-RR 64/32 ("PCG32"; M. E. O'Neill, 2014), started with the seed as its
/// state and with a fixed stream. The library's `seed_from_u64` and its random ranges are not
/// used, because they may change; instead, a choice among n is the upper half of the product of n
/// and the generator's next 32 bits.
pub struct Dice(Pcg32);

impl Dice {
    /// The dice of a seed.
    pub fn new(seed: u64) -> Self {
        Self(Pcg32::new(seed, STREAM))
    }

    /// A random whole number below `n`; for practical purposes, all numbers are equally likely.
    /// Returns 0 if `n` is 0.
    pub fn below(&mut self, n: u32) -> u32 {
        ((u64::from(self.0.next_u32()) * u64::from(n)) >> 32) as u32
    }

    /// True or false, with equal probability.
    pub fn coin(&mut self) -> bool {
        self.below(2) == 1
    }

    /// A random item; `None` if there are no items.
    pub(crate) fn pick<'a, T>(&mut self, items: &'a [T]) -> Option<&'a T> {
        items.get(self.below(items.len() as u32) as usize)
    }

    /// `count` of these items in random order; every item comes once before any is repeated.
    pub(crate) fn in_turn<T: Clone>(&mut self, items: &[T], count: usize) -> Vec<T> {
        let mut order = Vec::new();
        while order.len() < count && !items.is_empty() {
            let mut all = items.to_vec();
            self.shuffle(&mut all);
            order.extend(all);
        }
        order.truncate(count);
        order
    }

    /// Shuffles `items` (Fisher and Yates).
    pub(crate) fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            items.swap(last, self.below(last as u32 + 1) as usize);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_generator_agrees_with_the_definition_of_pcg32() {
        // O'Neill's reference: state' = a·state + c, output = rotr(xorshift, state >> 59).
        const A: u64 = 6_364_136_223_846_793_005;
        let seed = 42;
        let c = (STREAM << 1) | 1;
        let mut state = u64::wrapping_add(seed, c).wrapping_mul(A).wrapping_add(c);
        let mut dice = Dice::new(seed);
        for _ in 0..100 {
            let old = state;
            state = state.wrapping_mul(A).wrapping_add(c);
            let output = ((((old >> 18) ^ old) >> 27) as u32).rotate_right((old >> 59) as u32);
            let expected = (u64::from(output) * 1000) >> 32;
            assert_eq!(u64::from(dice.below(1000)), expected);
        }
    }

    #[test]
    fn choices_are_in_range_and_equally_likely() {
        let mut dice = Dice::new(1);
        let mut counts = [0; 6];
        for _ in 0..60_000 {
            counts[dice.below(6) as usize] += 1;
        }
        // Each count may deviate from 10,000 by up to five standard deviations.
        assert!(
            counts.iter().all(|n| (9_540..10_460).contains(n)),
            "{counts:?}"
        );
        assert_eq!(dice.below(0), 0);
        assert_eq!(dice.pick::<u8>(&[]), None);
    }
}
