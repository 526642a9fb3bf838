//! The layout of a picture and a panel of text in separate frames, side by side or, on a portrait
//! screen, one above the other.

use ratatui::buffer::Buffer;
use ratatui::layout::{Margin, Rect};

use super::draw_panel;
use crate::widgets::{Look, Room, areas};

/// The width of the panel, including its frame, in columns.
const PANEL: u16 = 30;
/// The minimum width of a panel beside a square picture, including the panel's frame.
const LEAST: u16 = 24;
/// The number of additional columns of the panel on a wide screen.
const MORE: u16 = 8;
/// The maximum width of a panel without a picture, including its frame.
const TEXT: u16 = 76;
/// The maximum size of a card, including its frame: columns, rows.
const CARD: (u16, u16) = (68, 22);
/// The number of columns from which a screen is considered wide.
const WIDE: u16 = 110;

/// The areas of a picture and its panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SplitLayout {
    /// The inside of the picture's frame.
    pub picture: Rect,
    /// The inside of the panel's frame.
    pub panel: Rect,
    frames: [Rect; 2],
}

impl SplitLayout {
    /// Lays out a picture and a panel in the available area.
    pub fn new(room: impl Into<Room>) -> Self {
        let room = room.into();
        let area = room.area;
        let more = if area.width >= WIDE { MORE } else { 0 };
        Self::with_panel(room, (PANEL + more).min(area.width / 2))
    }

    /// Lays out a picture just wide enough for a square board of the same height, and gives the
    /// remaining width to the panel.
    pub fn square(room: impl Into<Room>) -> Self {
        let room = room.into();
        let area = room.area;
        if let Some(sizes) = room.pictures {
            return Self::of(areas::sized_picture_and_panel(area, sizes.square));
        }
        let needed = (2 * area.height.saturating_sub(2)).saturating_sub(1) + 2;
        let panel_width = area.width.saturating_sub(needed);
        Self::with_panel(room, panel_width.max(LEAST.min(area.width / 2)))
    }

    /// Lays out a centred panel of text without a picture.
    pub(crate) fn text_alone(room: impl Into<Room>) -> Self {
        Self::text_of(room, TEXT)
    }

    /// Lays out a centred panel of text without a picture, at most `columns` columns wide.
    pub(crate) fn text_of(room: impl Into<Room>, columns: u16) -> Self {
        let frame = areas::middle(room.into().area, columns);
        Self::alone(frame, inside(frame))
    }

    /// Lays out a centred card of text without a picture, with a margin if there is room.
    pub fn card(room: impl Into<Room>) -> Self {
        let room = room.into();
        let area = room.area;
        let rows = match room.pictures {
            // A web page uses all rows instead of showing a card.
            Some(_) => area.height,
            None => area.height.min(CARD.1),
        };
        let card = Rect {
            y: area.y + (area.height - rows) / 2,
            height: rows,
            ..areas::middle(area, CARD.0)
        };
        let across = 2 * u16::from(card.width == CARD.0);
        let down = u16::from(card.height == CARD.1);
        Self::alone(card, inside(card).inner(Margin::new(across, down)))
    }

    fn alone(frame: Rect, panel: Rect) -> Self {
        let picture = Rect { width: 0, ..frame };
        Self {
            picture,
            panel,
            frames: [picture, frame],
        }
    }

    /// Lays out a picture, and a panel that is `panel_width` columns wide including its frame.
    pub(crate) fn with_panel(room: impl Into<Room>, panel_width: u16) -> Self {
        Self::of(areas::picture_and_panel(room.into(), panel_width))
    }

    /// Lays out a picture, and a panel without a frame that is `panel_width` columns wide.
    pub(crate) fn with_open_panel(room: impl Into<Room>, panel_width: u16) -> Self {
        let [picture, panel] = areas::picture_and_panel(room.into(), panel_width);
        Self {
            picture: inside(picture),
            panel,
            frames: [picture, Rect { width: 0, ..panel }],
        }
    }

    /// Places a picture and text in these areas, without frames.
    pub fn open(picture: Rect, panel: Rect) -> Self {
        let [no_picture, no_panel] = [picture, panel].map(|it| Rect { width: 0, ..it });
        Self {
            picture,
            panel,
            frames: [no_picture, no_panel],
        }
    }

    fn of([picture, panel]: [Rect; 2]) -> Self {
        Self {
            picture: inside(picture),
            panel: inside(panel),
            frames: [picture, panel],
        }
    }

    /// Draws both frames with their titles.
    pub fn draw(&self, buf: &mut Buffer, look: &Look, picture: &str, panel: &str) {
        draw_panel(buf, self.frames[0], picture, look);
        draw_panel(buf, self.frames[1], panel, look);
    }
}

fn inside(frame: Rect) -> Rect {
    Rect {
        x: frame.x + 1,
        y: frame.y + 1,
        width: frame.width.saturating_sub(2),
        height: frame.height.saturating_sub(2),
    }
}
