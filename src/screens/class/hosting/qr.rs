//! A QR code in half blocks, black on white whatever the theme, so that phones can read it.

use qrcode::{Color as Module, EcLevel, QrCode};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Color, Style};

use crate::widgets::{Charset, Depth, Look};

/// The width of the white margin around the code, in modules.
const MARGIN: usize = 2;

/// A QR code that can be drawn.
pub(super) struct Qr {
    code: QrCode,
    /// White and black.
    colours: [Color; 2],
    /// The width of a module, in columns.
    scale: usize,
}

impl Qr {
    /// The QR code of a string; `None` if a phone could not read it, because the charset has no
    /// half blocks or the theme has no colours.
    pub(super) fn of(text: &str, look: &Look) -> Option<Self> {
        let has_cells = look.charset == Charset::Unicode && look.theme.depth != Depth::None;
        let code = QrCode::with_error_correction_level(text, EcLevel::L).ok()?;
        has_cells.then_some(Self {
            // Terminals let users redefine the first sixteen colours, so later ones, which are
            // fixed, are used if there are any.
            colours: match look.theme.depth {
                Depth::None | Depth::Ansi16 => [Color::White, Color::Black],
                Depth::Indexed256 | Depth::True => [Color::Indexed(231), Color::Indexed(16)],
            },
            scale: 1,
            code,
        })
    }

    /// The same code enlarged, so that phones can read it from farther away.
    pub(super) fn scaled(self, scale: usize) -> Self {
        Self { scale, ..self }
    }

    /// The size in columns and rows.
    pub(super) fn size(&self) -> (u16, u16) {
        let side = (self.scale * (self.code.width() + 2 * MARGIN)) as u16;
        (side, side.div_ceil(2))
    }

    fn is_dark(&self, column: usize, row: usize) -> bool {
        let inside = |at: usize| (at / self.scale).checked_sub(MARGIN);
        let inside = |at: usize| inside(at).filter(|at| *at < self.code.width());
        let module = inside(column).zip(inside(row));
        module.is_some_and(|place| self.code[place] == Module::Dark)
    }

    /// Draws the code in the upper left corner of an area, on white.
    pub(super) fn draw(&self, place: Rect, buf: &mut Buffer) {
        let (columns, rows) = self.size();
        let colour = |dark: bool| self.colours[usize::from(dark)];
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::widgets::{Palette, Theme};

    #[test]
    fn each_module_is_drawn_in_its_half_of_a_cell_within_a_white_margin() {
        let look = Look {
            charset: Charset::Unicode,
            theme: Theme::new(Palette::Dark, Depth::True),
            ..Look::default()
        };
        let text = "http://192.168.43.117:8090/#code=BCDFGH";
        for scale in [1, 2] {
            check(text, scale, &look);
        }
    }

    fn check(text: &str, scale: usize, look: &Look) {
        let qr = Qr::of(text, look).unwrap().scaled(scale);
        let (columns, rows) = qr.size();
        assert_eq!((columns, rows), [(33, 17), (66, 33)][scale - 1]);
        let mut buf = Buffer::empty(Rect::new(0, 0, columns, rows));
        qr.draw(buf.area, &mut buf);
        let code = QrCode::with_error_correction_level(text, EcLevel::L).unwrap();
        for (y, x) in (0..2 * rows).flat_map(|y| (0..columns).map(move |x| (y, x))) {
            let cell = &buf[(x, y / 2)];
            let colour = if y % 2 == 0 { cell.fg } else { cell.bg };
            let inside = |at: u16| {
                let at = (usize::from(at) / scale).checked_sub(MARGIN);
                at.filter(|at| *at < code.width())
            };
            let dark = match (inside(x), inside(y)) {
                (Some(x), Some(y)) => code[(x, y)] == Module::Dark,
                _ => false,
            };
            let expected = if dark { 16 } else { 231 };
            assert_eq!((cell.symbol(), colour), ("▀", Color::Indexed(expected)));
        }
    }
}
