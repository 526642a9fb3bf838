//! The levels: the list of them, and playing one.

mod list;
mod play;
mod words;

pub use list::Levels;
pub use play::LevelPlay;
