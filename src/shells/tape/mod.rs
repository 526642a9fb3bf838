//! Tapes: scripts that play carrom without a terminal, on simulated time.
//!
//! Each line has one instruction. `#` starts a comment, and strings are in double quotes (with the
//! escapes `\"`, `\\`, `\n` and `\t`). `Run` is optional and must come first.
//!
//! ```text
//! Run "quiz --seed 7"          the arguments after carrom (default: none)
//! Set Size 100x30              columns x rows (default: 80x24)
//! Set Charset ascii            or unicode
//! Set Color none               or 16, 256, truecolor
//! Set Day 2026-01-05           sets the clock to noon on this day for everything that is saved
//!                              or opened from now on (default: no clock)
//! Type "60"                    one key per character
//! Right 5                      a key by its name, and how many times (default: 1): Up
//!                              Down Left Right Enter Escape Tab Shift+Tab Backspace
//!                              Delete Space PageUp PageDown Home End F1 Ctrl+C
//! Click 40,12                  column,row; the top left cell is 0,0
//! Drag 40,12 44,12             from, to
//! Hold 40,12 44,12             the same without releasing the button
//! Release 44,12                releases the button over this cell
//! Scroll down 3                or up; how many notches (default: 1); over the middle of the
//!                              screen, or over a cell: Scroll up 1 40,12
//! Sleep 1.5s                   or 200ms: simulated, so it takes no time
//! At "Ada"                     switches to the device of a pupil, who joins if necessary;
//!                              At "teacher" switches back
//! Lose "Ada"                   disconnects Ada's device; Reach "Ada" reconnects it
//! Screenshot impact            saves the screen under this name
//! Expect "90.0"                fails unless the screen shows this
//! Refuse "NaN"                 fails if the screen shows this
//! ```
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
pub use play::{PlayError, play};
pub use screenshot::Screenshot;

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
