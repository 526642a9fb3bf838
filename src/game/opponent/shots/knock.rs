//! Strokes that are not aimed at a pocket: they break the pack, open a cluster or leave the
//! opponent a difficult position.

use std::ops::Range;

use glam::DVec2;
use rand::RngExt;
use rand_pcg::Pcg64;

use super::super::sight::Sight;
use crate::physics::Motion;

/// `count` strokes at coins. Each starts from one of `places`, is aimed at a random coin with a
/// random offset of at most r₁ + r₂, and has a speed in m/s from `speeds`. If there is no coin,
/// the strokes are aimed near the centre of the board.
pub(in super::super) fn knocks(
    sight: &Sight,
    places: &[DVec2],
    count: usize,
    speeds: &Range<f64>,
    chance: &mut Pcg64,
) -> Vec<Motion> {
    let reach = sight.striker() + sight.coin();
    let mut any = |n: usize| chance.random_range(0..n.max(1) as u64) as usize;
    let picks: Vec<(usize, usize)> = (0..count)
        .map(|_| (any(places.len()), any(sight.coins.len())))
        .collect();
    picks
        .into_iter()
        .filter_map(|(place, coin)| {
            let position = *places.get(place)?;
            let target = sight.coins.get(coin).map_or(DVec2::ZERO, |coin| coin.at);
            let way = (target - position).try_normalize().unwrap_or(DVec2::Y);
            let offset = reach * (2.0 * chance.random::<f64>() - 1.0);
            let toward = (target + way.perp() * offset - position).try_normalize()?;
            let speed = speeds.start + (speeds.end - speeds.start) * chance.random::<f64>();
            Some(Motion::new(position, toward * speed))
        })
        .collect()
}
