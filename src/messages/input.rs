//! The inputs that a shell passes to the app.

use glam::{DVec2, dvec2};
use ratatui::layout::Rect;
use strum::EnumString;

use super::{HostNews, JoinNews, Key, StoreAnswer};

/// An event from outside the app.
#[derive(Debug, Clone, PartialEq)]
pub enum Input {
    /// A key has been pressed.
    Key(Key),
    /// The mouse has done something over a cell.
    Mouse(Mouse),
    /// Text has been pasted.
    Paste(String),
    /// The screen now has this many columns and rows.
    Resize(u16, u16),
    /// The [`Effect::Keep`](super::Effect::Keep) with this ticket is taking a long time; the result
    /// will follow.
    Saving(u64),
    /// The result of an [`Effect::Keep`](super::Effect::Keep).
    Kept(Box<StoreAnswer>),
    /// The result of an [`Effect::Export`](super::Effect::Export) or
    /// [`Effect::ExportPage`](super::Effect::ExportPage): the path of the file, or the reason why
    /// it could not be written.
    Exported(Result<String, String>),
    /// The events from a class on the pupils' devices since the last such input, in order.
    Hosted(Vec<HostNews>),
    /// An event from the host of the class.
    Joined(JoinNews),
}

impl From<Key> for Input {
    fn from(key: Key) -> Self {
        Self::Key(key)
    }
}

/// A mouse event over a cell; cells are counted from 0 at the top left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mouse {
    /// What the mouse did.
    pub kind: MouseKind,
    /// The column of the cell.
    pub column: u16,
    /// The row of the cell.
    pub row: u16,
    /// The position within the cell, in 256ths of its width and height, because whole cells are too
    /// coarse for touch input. A terminal reports only the cell, so the position is then the middle
    /// of the cell.
    pub within: (u8, u8),
}

impl Mouse {
    /// A mouse event in the middle of a cell (column, row).
    pub const fn over(kind: MouseKind, (column, row): (u16, u16)) -> Self {
        Self {
            kind,
            column,
            row,
            within: (128, 128),
        }
    }

    /// A mouse event at a position on the screen, in columns and rows from the upper left corner; a
    /// position to the left of the screen or above it is moved to the edge.
    pub fn at(kind: MouseKind, place: DVec2) -> Self {
        let place = place.max(DVec2::ZERO);
        let within = 256.0 * place.fract();
        Self {
            within: (within.x as u8, within.y as u8),
            ..Self::over(kind, (place.x as u16, place.y as u16))
        }
    }

    /// The position on the screen, in columns and rows from the upper left corner.
    pub fn place(&self) -> DVec2 {
        let (x, y) = self.within;
        dvec2(self.column.into(), self.row.into()) + dvec2(x.into(), y.into()) / 256.0
    }

    /// The column and the row of the cell.
    pub const fn cell(&self) -> (u16, u16) {
        (self.column, self.row)
    }

    /// Whether the button has just been pressed inside an area.
    pub fn presses(&self, area: Rect) -> bool {
        self.kind == MouseKind::Down && area.contains(self.cell().into())
    }

    /// Whether the button is down, either because it has just been pressed or because it is being
    /// held.
    pub(crate) fn is_held(&self) -> bool {
        matches!(self.kind, MouseKind::Down | MouseKind::Drag)
    }

    /// The direction in which the wheel was turned, if it was: 1 away from the user, −1 towards the
    /// user.
    pub const fn wheel(&self) -> Option<i8> {
        match self.kind {
            MouseKind::ScrollUp => Some(1),
            MouseKind::ScrollDown => Some(-1),
            _ => None,
        }
    }
}

/// What the mouse did; only the main button is used. A page sends its name, such as "scroll-up".
#[derive(Debug, Clone, Copy, PartialEq, Eq, EnumString)]
#[strum(serialize_all = "kebab-case")]
pub enum MouseKind {
    /// The button was pressed.
    Down,
    /// The mouse was moved with the button down.
    Drag,
    /// The button was released.
    Up,
    /// The wheel was turned away from the user.
    ScrollUp,
    /// The wheel was turned towards the user.
    ScrollDown,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_position_is_accurate_to_a_small_part_of_a_cell() {
        let over = Mouse::over(MouseKind::Down, (3, 4));
        assert_eq!(over.place(), dvec2(3.5, 4.5));
        for place in [dvec2(0.0, 0.0), dvec2(60.99, 7.25), dvec2(12.5, 300.0)] {
            let mouse = Mouse::at(MouseKind::Drag, place);
            assert!(mouse.place().distance(place) < 0.01, "{mouse:?}");
        }
        assert_eq!(Mouse::at(MouseKind::Up, dvec2(-3.0, 2.5)).cell(), (0, 2));
    }
}
