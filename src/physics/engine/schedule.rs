//! The schedule of events, with one forecast for each disc.

use wide::f64x2;

use super::frame::SlideEnd;

/// Contacts that share a disc and occur within this time, in seconds, are treated as one event: in
/// a symmetric break, the contacts on the two sides have times that differ only by rounding errors.
pub(super) const SAME_TIME: f64 = 1e-12;

/// The number of discs for which a common earliest time is stored. The discs of a carrom board fit
/// into a single block; if there are thousands of discs, the search for the first event has to
/// check the discs of only a few blocks.
const BLOCK: usize = 24;

/// The forecast of a disc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Forecast {
    /// The disc's slide ends by itself.
    Alone(SlideEnd),
    /// The disc meets a partner, provided that the partner's motion still has this version.
    Meet { partner: usize, version: u32 },
}

/// The earliest forecast of each disc.
///
/// A forecast becomes outdated if the motion of the partner changes. An outdated forecast is too
/// early, never too late, and is repeated when its time comes.
#[derive(Debug, Default, Clone)]
pub(super) struct Schedule {
    /// The time for each disc, padded with infinities to whole blocks.
    pub(super) times: Vec<f64>,
    forecasts: Vec<Forecast>,
    /// The earliest time in each block; `None` if a time in the block has changed.
    earliest: Vec<Option<f64>>,
}

impl Schedule {
    pub(super) fn begin(&mut self, discs: usize) {
        let blocks = discs.div_ceil(BLOCK);
        self.times.clear();
        self.times.resize(blocks * BLOCK, f64::INFINITY);
        self.earliest.clear();
        self.earliest.resize(blocks, None);
        self.forecasts.clear();
        self.forecasts
            .resize(discs, Forecast::Alone(SlideEnd::Never));
    }

    #[inline]
    pub(super) fn set(&mut self, disc: usize, time: f64, forecast: Forecast) {
        self.times[disc] = time;
        self.forecasts[disc] = forecast;
        self.earliest[disc / BLOCK] = None;
    }

    #[inline]
    pub(super) fn time(&self, disc: usize) -> f64 {
        self.times[disc]
    }

    #[inline]
    pub(super) fn forecast(&self, disc: usize) -> Forecast {
        self.forecasts[disc]
    }

    /// The disc with the earliest forecast, and the time of this forecast; if several forecasts are
    /// equally early, the disc with the lowest number.
    #[inline]
    pub(super) fn first(&mut self) -> Option<(usize, f64)> {
        let blocks = self.times.as_chunks::<BLOCK>().0;
        let mut least = f64::INFINITY;
        let mut first = None;
        for (b, earliest) in self.earliest.iter_mut().enumerate() {
            let time = *earliest.get_or_insert_with(|| minimum(&blocks[b]));
            if time < least {
                least = time;
                first = Some(b);
            }
        }
        let b = first?;
        Some((b * BLOCK + first_up_to(&blocks[b], least), least))
    }

    /// The number of discs whose forecast is not later than this time.
    #[inline]
    pub(super) fn due(&self, time: f64) -> usize {
        let blocks = self.times.as_chunks::<BLOCK>().0;
        let may = |&(_, earliest): &(_, &Option<f64>)| earliest.is_none_or(|t| t <= time);
        let count = |block: &[f64; BLOCK]| block.iter().filter(|&&t| t <= time).count();
        let blocks = blocks.iter().zip(&self.earliest).filter(may);
        blocks.map(|(block, _)| count(block)).sum()
    }
}

/// The earliest time in a block, which is found by comparing four times at once.
#[inline]
fn minimum(block: &[f64; BLOCK]) -> f64 {
    let mut least = [f64x2::splat(f64::INFINITY); 2];
    for &[a, b, c, d] in block.as_chunks().0 {
        least[0] = least[0].fast_min(f64x2::new([a, b]));
        least[1] = least[1].fast_min(f64x2::new([c, d]));
    }
    let [a, b] = least[0].fast_min(least[1]).to_array();
    a.min(b)
}

/// The index of the first time in a block that is not later than `time`. There is no branch,
/// because a processor could not predict the index.
#[inline]
fn first_up_to(block: &[f64; BLOCK], time: f64) -> usize {
    let mut found = 0;
    for (n, &two) in block.as_chunks().0.iter().enumerate() {
        let up_to = f64x2::new(two).simd_le(f64x2::splat(time));
        found |= up_to.to_bitmask() << (2 * n);
    }
    found.trailing_zeros() as usize
}
