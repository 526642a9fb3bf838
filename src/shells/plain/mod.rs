//! The quiz and the lessons in plain lines: for screen readers, Braille displays, dumb
//! terminals and scripts.
//!
//! Nothing here draws, moves a cursor or waits for a time. A line is said, a line is
//! heard, and what a picture would show is said in words: all that is needed to answer,
//! and no more than the picture gives. Signs are spelt as they are read aloud.

mod answering;
mod figure;
mod formula;
mod keeper;
mod learn;
mod number;
mod picture;
mod quiz;
mod solve;
mod spoken;
mod talk;

pub use keeper::Keeper;
pub use learn::learn;
pub use quiz::quiz;
pub use solve::solve;
pub use spoken::spoken;
pub use talk::{Leave, Talk};
