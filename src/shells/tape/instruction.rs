//! The instructions of a tape.

use std::time::Duration;

use crate::messages::{Key, MouseKind};
use crate::widgets::{Charset, Depth};

/// One instruction of a tape.
#[derive(Debug, Clone, PartialEq)]
pub enum Instruction {
    /// Change how the app is shown.
    Set(ScreenSetting),
    /// Press the key of each character.
    Type(String),
    /// Press a key the given number of times.
    Press(Key, u32),
    /// Click on a cell (column, row).
    Click((u16, u16)),
    /// Drag from one cell to another.
    Drag((u16, u16), (u16, u16)),
    /// Press the button over one cell and move to another without releasing the button.
    Hold((u16, u16), (u16, u16)),
    /// Release the button over a cell.
    Release((u16, u16)),
    /// Turn the wheel by a number of notches, over a cell or over the middle of the screen.
    Scroll(MouseKind, u32, Option<(u16, u16)>),
    /// Advance simulated time.
    Sleep(Duration),
    /// Switch to a device in a class: that of the pupil with this name, who joins if necessary,
    /// or, with `None`, the teacher's.
    At(Option<String>),
    /// Disconnect a pupil's device from the host (`false`), or connect it again.
    Reach(String, bool),
    /// Save the screen under a name.
    Screenshot(String),
    /// Fail unless the screen shows this.
    Expect(String),
    /// Fail if the screen shows this.
    Refuse(String),
}

/// A setting that `Set` changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ScreenSetting {
    /// Columns and rows of the screen.
    Size(u16, u16),
    /// The glyphs to draw with.
    Charset(Charset),
    /// The number of colours.
    Color(Depth),
    /// Noon (UTC) on a day, in seconds since the start of 1970.
    Day(i64),
}
