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

/// A picture, and so many columns for a panel on its right. In an upright area, such as a
/// phone's, the panel is below it, and the picture as high as a square one needs.
pub(crate) fn picture_and_panel(area: Rect, panel_columns: u16) -> [Rect; 2] {
    let is_upright = 4 * u32::from(area.height) >= 3 * u32::from(area.width);
    if is_upright && panel_columns < area.width {
        let square = (area.width.saturating_sub(2) / 2).saturating_add(2);
        return upper(area, square.min(area.height / 5 * 3));
    }
    left(area, area.width.saturating_sub(panel_columns))
}

/// So many columns in the middle of an area, as far as it has them.
pub(crate) fn middle(area: Rect, columns: u16) -> Rect {
    let width = columns.min(area.width);
    let x = area.x + (area.width - width) / 2;
    Rect { x, width, ..area }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panel_is_beside_a_picture_or_below_it_where_the_area_is_upright() {
        let wide = picture_and_panel(Rect::new(0, 1, 80, 22), 30);
        assert_eq!(wide, [Rect::new(0, 1, 50, 22), Rect::new(50, 1, 30, 22)]);
        let phone = picture_and_panel(Rect::new(0, 1, 61, 50), 30);
        assert_eq!(phone, [Rect::new(0, 1, 61, 30), Rect::new(0, 31, 61, 20)]);
        let text_alone = picture_and_panel(Rect::new(0, 1, 61, 50), 61);
        assert_eq!(text_alone[1], Rect::new(0, 1, 61, 50));
    }
}
