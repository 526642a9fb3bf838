//! Scene and level files: their format, loading, checking and judging.
//!
//! A **scene** is a board with discs on it, and a shot, in a TOML file. A **level** is a scene with
//! goals, settings that the player may change, hints, an explanation and an aim that wins; the aim
//! is stored so that the level can be checked by playing the shot. Every number in a file is
//! checked against its bounds while it is read; a [`FileError`] states the file, the line, the
//! field and what was expected.

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

pub use crate::files::FileError;
pub(crate) use crate::files::Range;
pub use aim::Dial;
pub(crate) use aim::LevelAim;
pub use check::{Trial, winning_share};
pub(crate) use judge::Judgement;
pub use judge::{Finding, judge};
pub(crate) use kind::DiscKind;
pub use level::Level;
pub use library::LevelLibrary;
pub(crate) use library::{Pack, order as pack_order};
pub use play::Patience;
pub(crate) use scene::PlacedDisc;
pub use scene::Scene;
pub use shelf::Shelf;
pub use stars::Starred;
pub(crate) use stars::{FEW_SHOTS, MOST_STARS, Win};
