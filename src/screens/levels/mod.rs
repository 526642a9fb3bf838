//! The levels: the list, and playing one.

mod list;
mod play;
mod words;

pub(crate) use list::Levels;
pub(crate) use play::LevelPlay;
