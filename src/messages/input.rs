//! What a shell tells the app.

use super::{Key, SearchResult, StoreAnswer};

/// One thing that happened outside.
#[derive(Debug, Clone, PartialEq)]
pub enum Input {
    /// A key was pressed.
    Key(Key),
    /// The mouse did something over a cell.
    Mouse(Mouse),
    /// Text was pasted.
    Paste(String),
    /// The screen now has this many columns and rows.
    Resize(u16, u16),
    /// What came of an [`Effect::Search`](super::Effect::Search).
    Searched(Box<SearchResult>),
    /// The [`Effect::Keep`](super::Effect::Keep) of this ticket takes long; what comes of
    /// it is still to come.
    Saving(u64),
    /// What came of an [`Effect::Keep`](super::Effect::Keep).
    Kept(Box<StoreAnswer>),
    /// What came of an [`Effect::Export`](super::Effect::Export): where the file is,
    /// or why there is none.
    Exported(Result<String, String>),
}

impl From<Key> for Input {
    fn from(key: Key) -> Self {
        Self::Key(key)
    }
}

/// The mouse over a cell, counted from 0 at the top left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mouse {
    /// What it did.
    pub kind: MouseKind,
    /// Column of the cell.
    pub column: u16,
    /// Row of the cell.
    pub row: u16,
}

impl Mouse {
    /// The column and the row of the cell.
    pub const fn cell(&self) -> (u16, u16) {
        (self.column, self.row)
    }

    /// Whether the button is down, just now or for some time.
    pub fn is_held(&self) -> bool {
        matches!(self.kind, MouseKind::Down | MouseKind::Drag)
    }

    /// A step of the wheel, if it turned: 1 away from the hand, −1 towards it.
    pub const fn wheel(&self) -> Option<i8> {
        match self.kind {
            MouseKind::ScrollUp => Some(1),
            MouseKind::ScrollDown => Some(-1),
            _ => None,
        }
    }
}

/// What the mouse did; only the main button counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MouseKind {
    /// The button went down.
    Down,
    /// It moved with the button down.
    Drag,
    /// The button went up.
    Up,
    /// The wheel turned away from the hand.
    ScrollUp,
    /// The wheel turned towards the hand.
    ScrollDown,
}
