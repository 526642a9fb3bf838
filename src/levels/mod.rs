//! Scene and level files: their format, loading, checking and judging.
//!
//! A **scene** is a board, the discs on it and a shot, as a TOML file. A **level**
//! is a scene with a goal, what the player may set, hints, an explanation and an
//! aim that wins; the aim is stored so that it can be checked by playing it. Every
//! number of a file is checked against its bounds while it is read; a [`FileError`] says
//! file, line, field and what was expected.

mod aim;
mod check;
mod goal;
mod judge;
mod kind;
mod level;
mod library;
mod play;
mod quantity;
mod scene;
mod shelf;
mod stars;

pub use crate::files::{FileError, Range};
pub use aim::{Adjust, Dial, LevelAim};
pub use check::{Trial, winning_share};
pub use goal::{Goal, GoalCircle, HitMeasure};
pub use judge::{Finding, Judgement, judge};
pub use kind::DiscKind;
pub use level::{FORMAT, Level};
pub use library::{LevelLibrary, Pack};
pub use play::Patience;
pub use scene::{Launch, MOST_DISCS, PlacedDisc, Scene};
pub use shelf::Shelf;
pub use stars::{FEW_SHOTS, MOST_STARS, Starred, Win};
