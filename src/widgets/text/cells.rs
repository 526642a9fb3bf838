//! The cells of a screen, as rows, symbols and text.

use ratatui::buffer::{Buffer, Cell};

use super::wrap::width;

/// The rows of a screen without trailing spaces, each followed by a line break.
pub fn text(buffer: &Buffer) -> String {
    let mut text = String::new();
    for cells in rows(buffer) {
        let start = text.len();
        for (_, cell) in symbols(cells) {
            text.push_str(cell.symbol());
        }
        let end = start + text[start..].trim_end().len();
        text.truncate(end);
        text.push('\n');
    }
    text
}

/// The cells of each row.
pub fn rows(buffer: &Buffer) -> impl Iterator<Item = &[Cell]> {
    let columns = usize::from(buffer.area.width).max(1);
    buffer.content.chunks(columns)
}

/// The cells of a row with their columns, without the cells hidden by a wide symbol before them.
pub(crate) fn symbols(cells: &[Cell]) -> impl Iterator<Item = (usize, &Cell)> {
    let mut next = 0;
    cells.iter().enumerate().filter(move |(column, cell)| {
        let shown = *column >= next;
        if shown {
            next = column + width(cell.symbol()).max(1);
        }
        shown
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use ratatui::layout::Rect;
    use ratatui::style::Style;

    #[test]
    fn a_wide_symbol_takes_two_cells() {
        let mut buffer = Buffer::empty(Rect::new(0, 0, 6, 1));
        buffer.set_string(0, 0, "a球b", Style::new());
        assert_eq!(text(&buffer), "a球b\n");
    }
}
