//! Lines of text one below the other, as the panels beside a picture have them.

use std::ops::Range;

use ratatui::{buffer::Buffer, layout::Rect};

use super::flow::{Run, flow};
use crate::widgets::{Charset, Look, Role, areas, text};

/// A column of text being written from the top of an area.
pub struct Lines<'a> {
    area: Rect,
    written: u16,
    scrolled: u16,
    /// The rows that can be pointed at, each with what it is.
    targets: Vec<(Range<u16>, usize)>,
    buf: &'a mut Buffer,
    look: Look,
}

/// Rows left over once all that is needed has its place. Rows of lesser worth are
/// shown only as far as they go.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Spare(u16);

impl Spare {
    /// Takes `rows`, if there are as many.
    pub fn take(&mut self, rows: u16) -> bool {
        let enough = rows <= self.0;
        if enough {
            self.0 -= rows;
        }
        enough
    }
}

impl<'a> Lines<'a> {
    /// Starts at the top of `area`, with a column of margin on the left.
    pub fn new(area: Rect, buf: &'a mut Buffer, look: Look) -> Self {
        let [_, area] = areas::left(area, 1);
        Self {
            area,
            written: 0,
            scrolled: 0,
            targets: Vec::new(),
            buf,
            look,
        }
    }

    /// Leaves the first `rows` out, so that those after them are seen.
    #[must_use]
    pub fn scrolled(mut self, rows: u16) -> Self {
        self.scrolled = rows;
        self
    }

    /// Columns of a row.
    pub fn width(&self) -> u16 {
        self.area.width
    }

    /// Rows written so far, seen or not.
    pub fn written(&self) -> u16 {
        self.written
    }

    /// The glyphs it is written in.
    pub fn charset(&self) -> Charset {
        self.look.charset
    }

    /// The glyphs and colours it is written in.
    pub(crate) fn look(&self) -> Look {
        self.look
    }

    /// The rows that a [`Lines::paragraph`] of this text would be.
    pub(crate) fn wrapped(&self, text: &str) -> Vec<String> {
        self.hung("", text).1
    }

    /// Rows that are left.
    pub fn left(&self) -> u16 {
        self.area.height.saturating_sub(self.written)
    }

    /// What is left beyond the rows that are `needed`.
    pub fn spare(&self, needed: u16) -> Spare {
        Spare(self.left().saturating_sub(needed))
    }

    /// Rows that a [`Lines::paragraph`] of this text takes.
    pub fn rows_of(&self, text: &str) -> u16 {
        self.rows_of_hanging("", text)
    }

    /// Writes rows that can be pointed at: they stand for the choice of this number.
    pub fn target(&mut self, choice: usize, write: impl FnOnce(&mut Self)) {
        let first = self.written;
        write(self);
        self.targets.push((first..self.written, choice));
    }

    /// The choice for which a row stands, the rows counted from 0 as they were written.
    pub fn target_at(&self, row: u16) -> Option<usize> {
        let mut targets = self.targets.iter();
        let (_, choice) = targets.find(|(rows, _)| rows.contains(&row))?;
        Some(*choice)
    }

    /// An empty row, unless there is nothing above it.
    pub fn gap(&mut self) {
        if self.written > 0 {
            self.written += 1;
        }
    }

    /// One row; cut at the edge.
    pub fn line(&mut self, text: &str, role: Role) {
        self.put(0, text, role);
        self.written += 1;
    }

    /// One row: a name on the left, its value flush right. A name too long for the room
    /// beside the value is cut, and dots tell of it.
    pub fn pair(&mut self, name: &str, value: &str, name_role: Role, value_role: Role) {
        let width = self.width_of(value) as u16;
        let column = self.area.width.saturating_sub(width + 1);
        let name = self.look.charset.text(name);
        let room = match value {
            "" => usize::from(self.area.width),
            _ => usize::from(column.saturating_sub(1)),
        };
        self.put(0, &text::clipped(&name, room), name_role);
        self.put(column, value, value_role);
        self.written += 1;
    }

    /// One row: a fact, as panels tell them: what it is, and its value flush right.
    pub fn fact(&mut self, name: &str, value: &str) {
        self.pair(name, value, Role::Dim, Role::Text);
    }

    /// One row: a name, and values flush right in columns of their own. The name has
    /// twice the room of a value; a value too wide for its column moves to the right
    /// rather than touch what is before it.
    pub fn columns(&mut self, name: (&str, Role), values: &[(&str, Role)]) {
        let width = usize::from(self.area.width);
        self.put(0, name.0, name.1);
        let mut free = self.width_of(name.0) + 1;
        for (i, &(value, role)) in values.iter().enumerate() {
            let end = (width * (i + 2) / (values.len() + 1)).min(width.saturating_sub(1));
            let start = end.saturating_sub(self.width_of(value)).max(free);
            self.put(start as u16, value, role);
            free = start + self.width_of(value) + 1;
        }
        self.written += 1;
    }

    /// Text over as many rows as it takes.
    pub fn paragraph(&mut self, text: &str, role: Role) {
        self.hanging("", text, role);
    }

    /// An equation over as many rows as it takes, those after the first set in by
    /// `indent`: the rest of an equation is no equation of its own.
    pub fn equation(&mut self, equation: &str, indent: u16, role: Role) {
        let text = self.look.charset.text(equation);
        let width = self.area.width.saturating_sub(1).into();
        let mut column = 0;
        for row in text::equation(&text, width, indent.into()) {
            self.put(column, &row, role);
            self.written += 1;
            column = indent;
        }
    }

    /// Text in several styles over as many rows as it takes, the rows after the first
    /// set in by `indent`; the first begins with `mark`.
    pub fn flowing(&mut self, mark: &str, indent: u16, runs: &[Run]) {
        let width = self.area.width.saturating_sub(1 + indent).into();
        self.put(0, mark, Role::Dim);
        for row in flow(runs, width, self.look.charset) {
            let mut column = indent;
            for run in row {
                self.put(column, &run.text, run.role);
                column += text::width(&run.text) as u16;
            }
            self.written += 1;
        }
    }

    /// Text over as many rows as it takes behind a mark, under which nothing else is
    /// written.
    pub fn hanging(&mut self, mark: &str, text: &str, role: Role) {
        let (indent, rows) = self.hung(mark, text);
        self.put(0, mark, role);
        for row in rows {
            self.put(indent, &row, role);
            self.written += 1;
        }
    }

    /// Rows that a [`Lines::hanging`] text takes.
    pub fn rows_of_hanging(&self, mark: &str, text: &str) -> u16 {
        self.hung(mark, text).1.len() as u16
    }

    /// Rows that what `write` writes takes, beginning with an empty area.
    pub fn rows_by(&self, write: impl FnOnce(&mut Lines)) -> u16 {
        let mut scratch = Buffer::empty(self.area);
        let mut lines = Lines {
            area: self.area,
            written: 0,
            scrolled: 0,
            targets: Vec::new(),
            buf: &mut scratch,
            look: self.look,
        };
        write(&mut lines);
        lines.written
    }

    /// The columns that a mark takes, and the rows of a text behind it.
    fn hung(&self, mark: &str, text: &str) -> (u16, Vec<String>) {
        let indent = self.width_of(mark) as u16;
        let width = self.area.width.saturating_sub(1 + indent).into();
        (indent, text::wrap(&self.look.charset.text(text), width))
    }

    /// Columns that a text takes as it is written.
    fn width_of(&self, text: &str) -> usize {
        text::width(&self.look.charset.text(text))
    }

    fn put(&mut self, column: u16, text: &str, role: Role) {
        let Some(row) = self.written.checked_sub(self.scrolled) else {
            return;
        };
        if row >= self.area.height || column >= self.area.width {
            return;
        }
        let text = self.look.charset.text(text);
        let room = (self.area.width - column).into();
        let style = self.look.theme.style(role);
        let (x, y) = (self.area.x + column, self.area.y + row);
        self.buf.set_stringn(x, y, text, room, style);
    }
}
