//! What a tape can say.

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
    /// Press a key this many times.
    Press(Key, u32),
    /// Click on a cell (column, row).
    Click((u16, u16)),
    /// Drag from one cell to another.
    Drag((u16, u16), (u16, u16)),
    /// Press the button over one cell and move to another, without letting go.
    Hold((u16, u16), (u16, u16)),
    /// Let the button go over a cell.
    Release((u16, u16)),
    /// Turn the wheel this many notches, over a cell or over the middle.
    Scroll(MouseKind, u32, Option<(u16, u16)>),
    /// Let simulated time pass.
    Sleep(Duration),
    /// Go to a device in a class: by the name of a pupil, who joins if necessary, or back to the
    /// teacher's.
    At(Option<String>),
    /// A pupil's device loses the host, or reaches it again.
    Reach(String, bool),
    /// Keep the screen under a name.
    Screenshot(String),
    /// Fail unless the screen shows this.
    Expect(String),
    /// Fail if the screen shows this.
    Refuse(String),
}

/// What `Set` sets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ScreenSetting {
    /// Columns and rows of the screen.
    Size(u16, u16),
    /// The glyphs to draw with.
    Charset(Charset),
    /// How many colours there are.
    Color(Depth),
    /// What time it is, in seconds since 1970 began: noon of a day, UTC.
    Day(i64),
}
