//! The app in plain lines: for screen readers, Braille displays, dumb terminals and scripts.
//!
//! The blocks of the screen are recorded while it is drawn and then written line by line. An input
//! line replaces keys and clicks. The output never moves a cursor and never waits for a fixed time,
//! and symbols are written as they are read aloud.

mod by_words;
mod formula;
mod number;
mod page;
mod reader;
#[cfg(not(target_family = "wasm"))]
mod run;
mod solve;
mod spoken;
mod talk;
#[cfg(test)]
mod tests;
mod working;

pub use reader::PlainReader;
#[cfg(not(target_family = "wasm"))]
pub use run::run;
pub use solve::solve;
pub use spoken::spoken;
pub use talk::{Leave, Talk};
