//! Tapes: scripts that play carrom without a terminal, on simulated time.
//!
//! Each line has one instruction; `instructions.txt` lists all of them. `#` starts a comment, and
//! strings are in double quotes (with the escapes `\"`, `\\`, `\n` and `\t`). `Run` is optional and
//! must come first.
//!
//! Nothing in a run depends on the clock or on chance, so the same tape with the same stored data
//! always gives the same screens, byte for byte.

mod instruction;
mod line;
mod parse;
mod play;
mod screenshot;

pub use instruction::{Instruction, ScreenSetting};
pub use parse::ParseError;
pub use play::{PlayError, PlayFault, play};
pub use screenshot::Screenshot;

/// The instructions, for the help of the command.
pub(crate) const INSTRUCTIONS: &str = include_str!("instructions.txt");

/// A script: its instructions in order, each with the number of its line.
#[derive(Debug, Clone, PartialEq)]
pub struct Tape {
    /// The arguments after `carrom`, and the number of their line.
    run: Option<(usize, String)>,
    steps: Vec<(usize, Instruction)>,
}

impl Tape {
    /// The arguments after `carrom`.
    pub fn arguments(&self) -> &str {
        self.run.as_ref().map_or("", |(_, arguments)| arguments)
    }

    /// The instructions, in order.
    pub fn instructions(&self) -> impl Iterator<Item = &Instruction> {
        self.steps.iter().map(|(_, instruction)| instruction)
    }
}
