//! The replay of a shot on the board: its clock, and its impacts, which can be examined
//! individually.

mod clock;
mod impact;
mod player;
mod prediction;

pub(crate) use clock::{ShotClock, WatchRate};
pub(crate) use impact::{ShotImpact, impacts};
pub(crate) use player::{ShotAction, ShotPlayer};
pub(crate) use prediction::ImpactPrediction;
