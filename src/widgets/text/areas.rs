//! Parts of an area of the screen.

use ratatui::layout::Rect;

/// The upper rows of an area, as far as it has so many, and what is left below them.
pub(crate) fn upper(area: Rect, rows: u16) -> [Rect; 2] {
    let height = rows.min(area.height);
    let below = Rect {
        y: area.y + height,
        height: area.height - height,
        ..area
    };
    [Rect { height, ..area }, below]
}

/// The columns on the left of an area, as far as it has so many, and what is left beside
/// them.
pub(crate) fn left(area: Rect, columns: u16) -> [Rect; 2] {
    let width = columns.min(area.width);
    let beside = Rect {
        x: area.x + width,
        width: area.width - width,
        ..area
    };
    [Rect { width, ..area }, beside]
}

/// So many columns in the middle of an area, as far as it has them.
pub(crate) fn middle(area: Rect, columns: u16) -> Rect {
    let width = columns.min(area.width);
    let x = area.x + (area.width - width) / 2;
    Rect { x, width, ..area }
}
