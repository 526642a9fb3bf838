//! A QR code in half blocks, black on white whatever the theme: so a phone reads it.

use qrcode::{Color as Module, EcLevel, QrCode};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Color, Style};

use crate::widgets::{Charset, Depth, Look};

/// White modules around the code.
const MARGIN: usize = 2;

/// A QR code that can be drawn.
pub(super) struct Qr {
    modules: Vec<Module>,
    side: usize,
}

impl Qr {
    /// The code of a text; `None` where it cannot be drawn so that a phone reads it: without
    /// half blocks, or without black and white.
    pub(super) fn of(text: &str, look: &Look) -> Option<Self> {
        let has_cells = look.charset == Charset::Unicode && look.theme.depth != Depth::None;
        let code = QrCode::with_error_correction_level(text, EcLevel::L).ok()?;
        has_cells.then(|| Self {
            side: code.width(),
            modules: code.to_colors(),
        })
    }

    /// Columns and rows.
    pub(super) fn size(&self) -> (u16, u16) {
        let side = (self.side + 2 * MARGIN) as u16;
        (side, side.div_ceil(2))
    }

    fn is_dark(&self, column: usize, row: usize) -> bool {
        let inside = |at: usize| at.checked_sub(MARGIN).filter(|at| *at < self.side);
        let module = |column, row: usize| self.modules.get(row * self.side + column);
        match (inside(column), inside(row)) {
            (Some(column), Some(row)) => module(column, row) == Some(&Module::Dark),
            _ => false,
        }
    }

    /// Draws it into the upper left corner of a place.
    pub(super) fn draw(&self, place: Rect, buf: &mut Buffer) {
        let (columns, rows) = self.size();
        let colour = |dark| if dark { Color::Black } else { Color::White };
        for (x, y) in (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y))) {
            let (column, row) = (usize::from(x), 2 * usize::from(y));
            let style = Style::reset()
                .fg(colour(self.is_dark(column, row)))
                .bg(colour(self.is_dark(column, row + 1)));
            if let Some(cell) = buf.cell_mut((place.x + x, place.y + y)) {
                cell.set_char('▀').set_style(style);
            }
        }
    }
}
