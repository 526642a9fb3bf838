//! Shots from geometry alone: which strokes are worth simulating.
//!
//! A shot is built from its end. A [`PocketPath`] says how a coin has to leave for a pocket:
//! straight, off a cushion, or to drive another coin that has a course. A [`ProposedStroke`] says
//! how the striker has to leave to give a coin its course: straight or off a cushion. Each link
//! requires a speed of the one before it and uses a share of the tolerance that is left.
//!
//! Checking a path against every coin costs more than all the rest. So a link is [`Unchecked`] at
//! first, and only candidates that are good enough are checked.

mod course;
mod knock;
mod strike;
#[cfg(test)]
mod tests;

use super::sight::{Sight, Way};

pub(super) use course::{PocketPath, combinations, off_a_cushion, straight, to_the_pockets};
pub(super) use knock::knocks;
pub(super) use strike::{ProposedStroke, allowance, ghost, kicks, most_allowed, strike, strikes};

/// The thinnest hit that is considered, as the cosine of the impact angle: 78°.
const THINNEST: f64 = 0.2;

/// A link of a shot whose path a coin may still block.
#[derive(Debug, Clone, Copy)]
pub(super) struct Unchecked<T> {
    pub(super) link: T,
    way: Way,
    /// Radius of the disc on this path.
    radius: f64,
    /// That disc, if it is a coin, and the coin that it hits at the end.
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
