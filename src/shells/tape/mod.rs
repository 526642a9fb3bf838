//! Tapes: scripts that play carrom without a terminal, on simulated time.
//!
//! One instruction a line, `#` starts a comment, text stands in double quotes (with
//! `\"`, `\\`, `\n` and `\t` in it). `Run`, if it is there, comes first.
//!
//! ```text
//! Run "quiz --seed 7"          the arguments after carrom (default none)
//! Set Size 100x30              columns x rows (default 80x24)
//! Set Charset ascii            or unicode
//! Set Color none               or 16, 256, truecolor
//! Set Day 2026-01-05           its clock stands at noon of this day, for all that is kept
//!                              or opened from here on (default: it has none)
//! Type "60"                    one key a character
//! Right 5                      a key by its name, with how often (default 1): Up
//!                              Down Left Right Enter Escape Tab Shift+Tab Backspace
//!                              Delete Space PageUp PageDown Home End F1 Ctrl+C
//! Click 40,12                  column,row from the top left, which is 0,0
//! Drag 40,12 44,12             from, to
//! Hold 40,12 44,12             the same without letting go
//! Release 44,12                and where that is done
//! Scroll down 3                or up; how far (default 1); over the middle of the
//!                              screen, or over a cell: Scroll up 1 40,12
//! Sleep 1.5s                   or 200ms: simulated, so it takes no time
//! At "Ada"                     from here on on the device of a pupil, who comes to the class;
//!                              At "teacher" goes back
//! Lose "Ada"                   her device loses the class; Reach "Ada" finds it again
//! Screenshot impact            keeps the screen under this name
//! Expect "90.0"                fails unless the screen shows this
//! Refuse "NaN"                 fails if the screen shows this
//! ```
//!
//! Nothing in a run depends on the clock or on chance, so the same tape gives the
//! same screens, byte for byte.

mod instruction;
mod line;
mod parse;
mod play;
mod screenshot;

pub use instruction::{Instruction, ScreenSetting};
pub use parse::ParseError;
pub use play::{PlayError, play};
pub use screenshot::Screenshot;

/// A script: its instructions in order, each with the number of its line.
#[derive(Debug, Clone, PartialEq)]
pub struct Tape {
    /// The arguments after `carrom`, and the line they stand in.
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
