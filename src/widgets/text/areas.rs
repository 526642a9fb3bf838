//! Ways to divide an area of the screen.

use ratatui::layout::Rect;
use serde::Deserialize;

/// The area that a screen may fill, and the sizes of its pictures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Room {
    /// The cells that the screen may fill.
    pub area: Rect,
    /// The sizes of pictures if they do not follow from the area, as on a web page, which lays out
    /// the recorded contents in its own way.
    pub pictures: Option<PictureSizes>,
}

/// The sizes of pictures, without their frames: columns, rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub struct PictureSizes {
    /// The size of a picture that fills the available area.
    pub any: [u16; 2],
    /// The size of a picture that has to be square, such as a board.
    pub square: [u16; 2],
}

/// The room for a screen that consists only of cells.
impl From<Rect> for Room {
    fn from(area: Rect) -> Self {
        let pictures = None;
        Self { area, pictures }
    }
}

/// The area of a framed picture with this size, in the upper left corner of `area`, and the columns
/// beside it.
pub(crate) fn sized_picture_and_panel(area: Rect, [columns, rows]: [u16; 2]) -> [Rect; 2] {
    let [picture, panel] = left(area, columns.saturating_add(2));
    let [picture, _] = upper(picture, rows.saturating_add(2));
    [picture, panel]
}

/// The top of an area (at most `rows` rows), and the rest of the area below it.
pub(crate) fn upper(area: Rect, rows: u16) -> [Rect; 2] {
    let height = rows.min(area.height);
    let below = Rect {
        y: area.y + height,
        height: area.height - height,
        ..area
    };
    [Rect { height, ..area }, below]
}

/// The left part of an area (at most `columns` columns), and the rest of the area to its right.
pub(crate) fn left(area: Rect, columns: u16) -> [Rect; 2] {
    let width = columns.min(area.width);
    let beside = Rect {
        x: area.x + width,
        width: area.width - width,
        ..area
    };
    [Rect { width, ..area }, beside]
}

/// The area of a picture, and the area of a panel on its right that is `panel_columns` columns
/// wide. In a portrait area, such as on a phone, the panel is below the picture, which is just high
/// enough to be square, but takes at most three fifths of the rows. If `room` gives the sizes of
/// pictures, the picture has one of these, and the panel fills the columns beside it.
pub(crate) fn picture_and_panel(room: Room, panel_columns: u16) -> [Rect; 2] {
    let area = room.area;
    if let Some(sizes) = room.pictures {
        return sized_picture_and_panel(area, sizes.any);
    }
    if is_portrait(area) && panel_columns < area.width {
        let square = (area.width.saturating_sub(2) / 2).saturating_add(2);
        return upper(area, square.min(area.height / 5 * 3));
    }
    left(area, area.width.saturating_sub(panel_columns))
}

/// Whether an area is so narrow that text belongs below a picture rather than beside it.
pub(crate) fn is_portrait(area: Rect) -> bool {
    4 * u32::from(area.height) >= 3 * u32::from(area.width)
}

/// The middle of an area, at most `columns` columns wide.
pub(crate) fn middle(area: Rect, columns: u16) -> Rect {
    let width = columns.min(area.width);
    let x = area.x + (area.width - width) / 2;
    Rect { x, width, ..area }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panel_is_beside_a_picture_or_below_it_in_a_portrait_area() {
        let wide = picture_and_panel(Rect::new(0, 1, 80, 22).into(), 30);
        assert_eq!(wide, [Rect::new(0, 1, 50, 22), Rect::new(50, 1, 30, 22)]);
        let phone = picture_and_panel(Rect::new(0, 1, 61, 50).into(), 30);
        assert_eq!(phone, [Rect::new(0, 1, 61, 30), Rect::new(0, 31, 61, 20)]);
        let text_alone = picture_and_panel(Rect::new(0, 1, 61, 50).into(), 61);
        assert_eq!(text_alone[1], Rect::new(0, 1, 61, 50));
    }

    #[test]
    fn a_picture_has_the_size_given_by_a_web_page_and_the_panel_has_all_rows() {
        let room = Room {
            area: Rect::new(0, 1, 90, 98),
            pictures: Some(PictureSizes {
                any: [40, 15],
                square: [40, 20],
            }),
        };
        let sized = picture_and_panel(room, 30);
        assert_eq!(sized, [Rect::new(0, 1, 42, 17), Rect::new(42, 1, 48, 98)]);
    }
}
