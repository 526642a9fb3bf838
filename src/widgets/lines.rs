//! Lines of text one below the other, as the panels beside a picture have them.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Look, Role, text};

/// A column of text being written from the top of an area.
pub struct Lines<'a> {
    area: Rect,
    next: u16,
    buf: &'a mut Buffer,
    look: Look,
}

impl<'a> Lines<'a> {
    /// Starts at the top of `area`, with a column of margin on the left.
    pub fn new(area: Rect, buf: &'a mut Buffer, look: Look) -> Self {
        let margin = 1.min(area.width);
        let area = Rect {
            x: area.x + margin,
            width: area.width - margin,
            ..area
        };
        Self {
            area,
            next: area.y,
            buf,
            look,
        }
    }

    /// Rows that are left.
    pub fn left(&self) -> u16 {
        self.area.bottom().saturating_sub(self.next)
    }

    /// Rows that a [`Lines::paragraph`] of this text takes.
    pub fn rows_of(&self, text: &str) -> u16 {
        self.wrapped(text).len() as u16
    }

    /// An empty row, unless there is nothing above it.
    pub fn gap(&mut self) {
        if self.next > self.area.y {
            self.next += 1;
        }
    }

    /// One row; cut at the edge.
    pub fn line(&mut self, text: &str, role: Role) {
        self.put(0, text, role);
        self.next += 1;
    }

    /// One row: a name on the left, its value flush right.
    pub fn pair(&mut self, name: &str, value: &str, name_role: Role, value_role: Role) {
        self.put(0, name, name_role);
        let value = self.look.charset.text(value).into_owned();
        let width = text::width(&value) as u16;
        let column = self.area.width.saturating_sub(width + 1);
        self.put(column, &value, value_role);
        self.next += 1;
    }

    /// One row of three: a name and two values in columns of their own.
    pub fn triple(&mut self, cells: [&str; 3], roles: [Role; 3]) {
        let width = self.area.width;
        let ends = [width * 2 / 3, width.saturating_sub(1)];
        self.put(0, cells[0], roles[0]);
        for i in 0..2 {
            let value = self.look.charset.text(cells[i + 1]).into_owned();
            let start = ends[i].saturating_sub(text::width(&value) as u16);
            self.put(start, &value, roles[i + 1]);
        }
        self.next += 1;
    }

    /// Text over as many rows as it takes.
    pub fn paragraph(&mut self, text: &str, role: Role) {
        for line in self.wrapped(text) {
            self.line(&line, role);
        }
    }

    fn wrapped(&self, text: &str) -> Vec<String> {
        let width = self.area.width.saturating_sub(1).into();
        text::wrap(&self.look.charset.text(text), width)
    }

    fn put(&mut self, column: u16, text: &str, role: Role) {
        if self.next >= self.area.bottom() || column >= self.area.width {
            return;
        }
        let text = self.look.charset.text(text);
        let room = (self.area.width - column).into();
        let style = self.look.theme.style(role);
        self.buf
            .set_stringn(self.area.x + column, self.next, text, room, style);
    }
}
