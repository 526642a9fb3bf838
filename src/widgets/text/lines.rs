//! Lines of text, one below the other, for the panels beside a picture.

use ratatui::{buffer::Buffer, layout::Rect};

use super::bar::bar;
use super::big::{Align, Big};
use super::flow::{Run, flow};
use super::sheet::{self, Item, Words};
use crate::widgets::{Charset, Look, Role, areas, text};

/// The maximum height of large type, in rows: for a single line, and for larger letters or two
/// lines.
const LARGE: [u16; 2] = [4, 8];
/// The minimum number of rows in a panel with larger letters.
const LARGER_FROM: u16 = 34;

/// A column of text that is being written from the top of an area.
pub(crate) struct Lines<'a> {
    area: Rect,
    written: u16,
    scrolled: u16,
    /// The number of rows in the panel to which this text belongs, which determines the size of
    /// large type.
    whole: u16,
    buf: &'a mut Buffer,
    look: Look,
    /// Whether text is being recorded with its meaning.
    is_recorded: bool,
    /// The cells that can be clicked, in rows from the top of the text and columns from the left,
    /// each with the index of its action in the current block.
    pub(in crate::widgets) targets: Vec<(Rect, usize)>,
    /// Whether the text being written can be clicked.
    can_be_clicked: bool,
    /// Whether the text being written is the selected item of several; `None` if it cannot be
    /// selected.
    chosen: Option<bool>,
}

impl<'a> Lines<'a> {
    /// Starts at the top of `area`, with a margin of one column on the left.
    pub(crate) fn new(area: Rect, buf: &'a mut Buffer, look: Look) -> Self {
        let [_, area] = areas::left(area, 1);
        Self {
            area,
            written: 0,
            scrolled: 0,
            whole: area.height,
            buf,
            look,
            is_recorded: true,
            targets: Vec::new(),
            can_be_clicked: false,
            chosen: None,
        }
    }

    /// Like [`Self::new`], but records nothing; this is used, for example, to count the rows that a
    /// text needs.
    pub(crate) fn unseen(area: Rect, buf: &'a mut Buffer, look: Look) -> Self {
        Self {
            is_recorded: false,
            ..Self::new(area, buf, look)
        }
    }

    /// Marks the text as part of a panel that has `whole` rows, and skips the first `scrolled` rows
    /// of the text.
    #[must_use]
    pub(crate) fn of_panel(self, whole: u16, scrolled: u16) -> Self {
        Self {
            whole,
            scrolled,
            ..self
        }
    }

    /// The number of rows in the panel to which this text belongs.
    pub(crate) fn whole(&self) -> u16 {
        self.whole
    }

    /// The number of columns of a row.
    pub(crate) fn width(&self) -> u16 {
        self.area.width
    }

    /// The number of rows written so far, visible or not.
    pub(crate) fn written(&self) -> u16 {
        self.written
    }

    pub(crate) fn charset(&self) -> Charset {
        self.look.charset
    }

    /// The number of rows left.
    pub(crate) fn left(&self) -> u16 {
        self.area.height.saturating_sub(self.written)
    }

    /// Writes an item that may be the selected one of several. All cells of its rows trigger the
    /// action with this index, if there is one.
    pub(crate) fn item(
        &mut self,
        chosen: Option<bool>,
        action: Option<usize>,
        write: impl FnOnce(&mut Self),
    ) {
        let top = self.written;
        (self.can_be_clicked, self.chosen) = (true, chosen);
        write(self);
        (self.can_be_clicked, self.chosen) = (false, None);
        let cells = Rect::new(0, top, self.area.width + 1, self.written - top);
        self.targets.extend(action.map(|action| (cells, action)));
    }

    /// Writes something that is recorded as `words`, regardless of how its rows are written.
    pub(crate) fn written_as(
        &mut self,
        words: impl FnOnce(Charset) -> Words,
        write: impl FnOnce(&mut Self),
    ) {
        self.record(words);
        self.unrecorded(write);
    }

    /// Writes something that is recorded separately, or not at all.
    pub(crate) fn unrecorded(&mut self, write: impl FnOnce(&mut Self)) {
        let was_recorded = std::mem::replace(&mut self.is_recorded, false);
        write(self);
        self.is_recorded = was_recorded;
    }

    /// Records a possible next action and its key, with the position at which the action is
    /// written: the column, and the row counted from the top.
    pub(crate) fn record_prompt(&self, words: &str, key: Option<String>, cell: Option<(u16, u16)>) {
        let words = |charset: Charset| Words::Prompt {
            words: charset.text(words).into_owned(),
            key,
        };
        self.note(words, cell.and_then(|cell| self.seen(cell)), None);
    }

    /// Records the text that is about to be written in the next row.
    fn record(&self, words: impl FnOnce(Charset) -> Words) {
        let press = self.seen((0, self.written)).filter(|_| self.can_be_clicked);
        self.note(words, press, self.chosen);
    }

    fn note(
        &self,
        words: impl FnOnce(Charset) -> Words,
        press: Option<[u16; 2]>,
        chosen: Option<bool>,
    ) {
        if self.is_recorded {
            sheet::note(self.area, || Item {
                words: words(self.look.charset),
                press,
                chosen,
            });
        }
    }

    /// The cell of the screen at a column and a row counted from the top; `None` if the row is
    /// not visible.
    fn seen(&self, (column, row): (u16, u16)) -> Option<[u16; 2]> {
        let row = row.checked_sub(self.scrolled)?;
        (row < self.area.height).then(|| [self.area.x + column, self.area.y + row])
    }

    /// Records text; text that consists only of spaces is recorded as a gap.
    fn record_text(&self, mark: &str, runs: &[Run]) {
        let is_blank = runs.iter().all(|run| run.text.trim().is_empty());
        self.record(|charset| match is_blank && mark.trim().is_empty() {
            true => Words::Gap,
            false => Words::Text {
                mark: charset.text(mark.trim()).into_owned(),
                runs: { runs.iter() }.map(|run| run.spelt(charset)).collect(),
            },
        });
    }

    /// Writes an empty row, unless nothing has been written above.
    pub(crate) fn gap(&mut self) {
        if self.written > 0 {
            self.note(|_| Words::Gap, None, None);
            self.written += 1;
        }
    }

    /// Leaves rows empty until this row, counted from the top.
    pub(crate) fn skip_to(&mut self, row: u16) {
        self.written = self.written.max(row);
    }

    /// Writes a single row, which is cut off at the edge.
    pub(crate) fn line(&mut self, text: &str, role: Role) {
        self.record_text("", &[Run::new(text, role)]);
        self.put(0, text, role);
        self.written += 1;
    }

    /// Writes one of several choices that share a row, starting at this column of the next row.
    pub(crate) fn beside(
        &mut self,
        column: u16,
        words: impl FnOnce(Charset) -> Words,
        row: &str,
        role: Role,
        chosen: bool,
    ) {
        let press = self.seen((column, self.written));
        self.note(words, press, Some(chosen));
        self.put(column, row, role);
    }

    /// Writes the first of the `texts` that fits in large letters, if the panel has at least `from`
    /// rows; otherwise writes the first text in a single row.
    pub(crate) fn large(&mut self, texts: &[String], from: u16) {
        let Some(first) = texts.first() else {
            return;
        };
        self.record(|charset| Words::large(&charset.text(first), Role::Title));
        let width = self.area.width.saturating_sub(1);
        // In a small window, only the shorter alternatives may use a second line.
        let rows = |at: usize| LARGE[usize::from(at > 0 || self.whole >= LARGER_FROM)];
        let fit = |(at, text): (usize, &String)| Big::fit(text, width, rows(at), self.look.charset);
        let big = texts.iter().enumerate().find_map(fit);
        match big.filter(|_| self.whole >= from) {
            Some(big) => self.big(&[(&big, Align::Left)]),
            None => self.unrecorded(|lines| lines.line(first, Role::Title)),
        }
    }

    /// Writes strings in large type side by side, in as many rows as they need.
    pub(crate) fn big(&mut self, all: &[(&Big, Align)]) {
        let mut rows = 0;
        for (big, align) in all {
            if let Some(row) = self.written.checked_sub(self.scrolled) {
                let [_, place] = areas::upper(self.area, row);
                let [place, _] = areas::left(place, place.width.saturating_sub(1));
                big.draw(place, self.buf, &self.look, Role::Title, *align);
            }
            rows = rows.max(big.rows());
        }
        self.written += rows;
    }

    /// Writes a single row with a name on the left and a right-aligned value. A name that is too
    /// long for the space beside the value is truncated and ends in "..".
    pub(crate) fn pair(&mut self, name: &Run, value: &Run) {
        self.record(|charset| Words::Pair {
            name: Run::new(self.unmarked(&name.text), name.role).spelt(charset),
            value: value.spelt(charset),
        });
        let width = self.width_of(&value.text) as u16;
        let column = self.area.width.saturating_sub(width + 1);
        let room = match value.text.as_str() {
            "" => usize::from(self.area.width),
            _ => usize::from(column.saturating_sub(1)),
        };
        let shown = text::clipped(&self.look.charset.text(&name.text), room);
        self.put(0, &shown, name.role);
        self.put(column, &value.text, value.role);
        self.written += 1;
    }

    /// Writes a single row with a name, a bar that shows a fraction, `width` columns wide, and a
    /// right-aligned value.
    pub(crate) fn meter(&mut self, name: &str, share: f64, role: Role, width: u16, value: &Run) {
        let gap = if name.is_empty() { "" } else { "  " };
        let bar = bar(share, width, self.look.charset);
        let bar = Run::new(format!("{name}{gap}{bar}"), role);
        let words = |_| Words::meter(name, share, &value.text, role);
        self.written_as(words, |lines| lines.pair(&bar, value));
    }

    /// Writes a single row with a name and right-aligned values in columns. The name has as much
    /// space as a value; a value that is too wide for its column moves to the right instead of
    /// touching the text before it.
    pub(crate) fn columns(&mut self, name: &Run, values: &[Run]) {
        self.record(|charset| Words::Columns {
            name: Run::new(self.unmarked(&name.text), name.role).spelt(charset),
            values: values.iter().map(|value| value.spelt(charset)).collect(),
        });
        let width = usize::from(self.area.width);
        self.put(0, &name.text, name.role);
        let mut free = self.width_of(&name.text) + 1;
        for (i, value) in values.iter().enumerate() {
            let end = (width * (i + 2) / (values.len() + 1)).min(width.saturating_sub(1));
            let start = end.saturating_sub(self.width_of(&value.text)).max(free);
            self.put(start as u16, &value.text, value.role);
            free = start + self.width_of(&value.text) + 1;
        }
        self.written += 1;
    }

    /// Writes text in as many rows as necessary.
    pub(crate) fn paragraph(&mut self, text: &str, role: Role) {
        self.hanging("", text, role);
    }

    /// Writes an equation in as many rows as necessary. Rows after the first are indented by
    /// `indent`, so that they do not look like another equation.
    pub(crate) fn equation(&mut self, equation: &str, indent: u16, role: Role) {
        self.record(|charset| Words::Equation {
            runs: vec![Run::new(equation, role).spelt(charset)],
        });
        let text = self.look.charset.text(equation);
        let width = self.area.width.saturating_sub(1).into();
        let mut column = 0;
        for row in text::equation(&text, width, indent.into()) {
            self.put(column, &row, role);
            self.written += 1;
            column = indent;
        }
    }

    /// Writes text in several styles in as many rows as necessary. The first row begins with
    /// `mark`, and the other rows are indented by `indent`.
    pub(crate) fn flowing(&mut self, mark: &str, indent: u16, runs: &[Run]) {
        self.record_text(self.unmarked(mark), runs);
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

    /// Writes text after a mark in as many rows as necessary, all indented to the right of the
    /// mark.
    pub(crate) fn hanging(&mut self, mark: &str, text: &str, role: Role) {
        self.record_text(self.unmarked(mark), &[Run::new(text, role)]);
        let (indent, rows) = self.hung(mark, text);
        self.put(0, mark, role);
        for row in rows {
            self.put(indent, &row, role);
            self.written += 1;
        }
    }

    /// The width of a mark, and the rows of the text after it.
    pub(crate) fn hung(&self, mark: &str, text: &str) -> (u16, Vec<String>) {
        let indent = self.width_of(mark) as u16;
        let width = self.area.width.saturating_sub(1 + indent).into();
        (indent, text::wrap(&self.look.charset.text(text), width))
    }

    /// `text` without the mark that shows whether the item is selected.
    fn unmarked<'t>(&self, text: &'t str) -> &'t str {
        match self.chosen {
            Some(_) => text.get(1..).unwrap_or_default().trim_start(),
            None => text,
        }
    }

    /// The width of `text` as written, in columns.
    fn width_of(&self, text: &str) -> usize {
        text::width(&self.look.charset.text(text))
    }

    fn put(&mut self, column: u16, text: &str, role: Role) {
        let Some([x, y]) = self.seen((column, self.written)) else {
            return;
        };
        // A screen may be drawn before the program learns that the window has become smaller.
        if column < self.area.width && self.buf.area.contains((x, y).into()) {
            let text = self.look.charset.text(text);
            let room = (self.area.width - column).into();
            let style = self.look.theme.style(role);
            self.buf.set_stringn(x, y, text, room, style);
        }
    }
}
