//! Shots from geometry alone: which strokes are worth playing in the mind.
//!
//! A shot is put together from its end. A [`PocketPath`] says how a coin has to leave
//! for a pocket: straight, off a cushion, or to drive another coin that has a
//! course. A [`ProposedStroke`] says how the striker has to leave to give a coin its course:
//! straight or off a cushion. Each link asks a speed of the one before it and
//! takes its share of the error that is still allowed.

mod course;
mod knock;
mod strike;
#[cfg(test)]
mod tests;

pub(super) use course::{PocketPath, combinations, off_a_cushion, straight};
pub(super) use knock::knocks;
pub(super) use strike::{ProposedStroke, kicks, strikes};

/// The thinnest hit that is looked at, as the cosine of the impact angle: 78°.
const THINNEST: f64 = 0.2;
