//! Finds by geometry alone which strokes are worth simulating.
//!
//! A shot is built backwards from its end. A [`PocketPath`] describes how a coin must move to reach
//! a pocket: straight, off a cushion, or by driving another coin that has a course. A
//! [`ProposedStroke`] describes how the striker must move to give a coin its course: straight or
//! off a cushion. Each link requires a certain speed from the link before it and uses up part of
//! the remaining tolerance.
//!
//! Checking a path against every coin takes longer than everything else. So a link is [`Unchecked`]
//! at first, and only good candidates are checked.

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

/// A link of a shot, before its path is checked: a coin may be in the way.
#[derive(Debug, Clone, Copy)]
pub(super) struct Unchecked<T> {
    pub(super) link: T,
    way: Way,
    /// Radius of the disc that takes this path.
    radius: f64,
    /// The disc that takes this path, if it is a coin, and the coin that it hits at the end.
    part: [Option<usize>; 2],
}

impl<T> Unchecked<T> {
    /// Whether nothing is in the way.
    pub(super) fn is_clear(&self, sight: &Sight) -> bool {
        self.way.is_clear(sight, self.radius, self.part)
    }

    /// The link, if nothing is in the way.
    pub(super) fn if_clear(self, sight: &Sight) -> Option<T> {
        self.is_clear(sight).then_some(self.link)
    }
}
