//! Shots from geometry alone: which strokes are worth playing in the mind.
//!
//! A shot is put together from its end. A [`PocketPath`] says how a coin has to leave
//! for a pocket: straight, off a cushion, or to drive another coin that has a
//! course. A [`ProposedStroke`] says how the striker has to leave to give a coin its course:
//! straight or off a cushion. Each link asks a speed of the one before it and
//! takes its share of the error that is still allowed.
//!
//! To look along a way past every coin costs more than all the rest. So a link comes
//! [`Unchecked`], and only what is good enough to be chosen is looked along.

mod course;
mod knock;
mod strike;
#[cfg(test)]
mod tests;

use super::sight::{Sight, Way};

pub(super) use course::{PocketPath, combinations, off_a_cushion, straight, to_the_pockets};
pub(super) use knock::knocks;
pub(super) use strike::{ProposedStroke, allowance, ghost, kicks, most_allowed, strike, strikes};

/// The thinnest hit that is looked at, as the cosine of the impact angle: 78°.
const THINNEST: f64 = 0.2;

/// A link of a shot whose way may still be barred by a coin.
#[derive(Debug, Clone, Copy)]
pub(super) struct Unchecked<T> {
    pub(super) link: T,
    way: Way,
    /// Radius of the disc that goes it.
    radius: f64,
    /// That disc, if it is a coin, and the coin that it is to meet at the end.
    part: [Option<usize>; 2],
}

impl<T> Unchecked<T> {
    /// Whether nothing is in the way.
    pub(super) fn is_clear(&self, sight: &Sight) -> bool {
        let [own, target] = self.part;
        self.way.is_clear(sight, self.radius, own, target)
    }

    /// The link, if nothing is in the way.
    pub(super) fn if_clear(self, sight: &Sight) -> Option<T> {
        self.is_clear(sight).then_some(self.link)
    }
}
