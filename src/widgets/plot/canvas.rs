//! The plot itself.

use glam::{DVec2, dvec2};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::axis::Axis;
use super::ticks::Tick;
use crate::widgets::ink::{Pen, Sheet, Side, View};
use crate::widgets::{Charset, Look, Role, text};

/// A plot being made: what is drawn on it lies over its axes, bars lie below curves,
/// marks above them, labels find themselves a free place.
///
/// Values are those of the axes. What has no place on them (a point beyond the edge, 0
/// on a logarithmic axis, what is not a number) is left out.
#[derive(Debug, Clone)]
pub struct Plot {
    axes: [Axis; 2],
    area: Rect,
    look: Look,
    ticks: [Vec<Tick>; 2],
    sheet: Sheet,
    bars: Vec<Bar>,
    marks: Vec<(DVec2, char, Role)>,
}

/// A bar, in places of the axes.
#[derive(Debug, Clone, Copy)]
struct Bar {
    from: f64,
    to: f64,
    height: f64,
    role: Role,
}

impl Plot {
    /// An empty plot that fills `area`: the name of `y` in the first row, that of `x`
    /// in the last.
    #[must_use]
    pub fn new(area: Rect, look: Look, x: Axis, y: Axis) -> Self {
        let rows = area.height.saturating_sub(3);
        let y_ticks = y.ticks(usize::from(rows / 3).max(1));
        let width_of = |tick: &Tick| text::width(&look.charset.text(&tick.text)) as u16;
        let left = (y_ticks.iter().map(width_of).max().unwrap_or(0) + 1).min(area.width);
        // Half of the last number below the axis stands out to the right.
        let right = 2.min(area.width - left);
        let paper = Rect {
            x: area.x + left,
            y: area.y + 1.min(area.height),
            width: area.width - left - right,
            height: rows,
        };
        // The room a number takes does not depend on how many there are.
        let widest = x.ticks(6).iter().map(width_of).max().unwrap_or(1);
        let x_ticks = x.ticks(usize::from(paper.width / (widest + 3)).max(1));
        let ((x0, x1), (y0, y1)) = (x.ends(), y.ends());
        let view = View::stretch(paper, dvec2(x0, y0), dvec2(x1, y1));
        let mut sheet = Sheet::new(view, look.charset);
        for column in paper.left()..paper.right() {
            sheet.reserve(view.world_at(column, paper.bottom().saturating_sub(1)));
        }
        for row in paper.top()..paper.bottom() {
            sheet.reserve(view.world_at(paper.x, row));
        }
        Self {
            axes: [x, y],
            area,
            look,
            ticks: [x_ticks, y_ticks],
            sheet,
            bars: Vec::new(),
            marks: Vec::new(),
        }
    }

    /// The cells between the axes, theirs included.
    #[must_use]
    pub fn paper(&self) -> Rect {
        self.sheet.view().area()
    }

    /// The values in the middle of a cell (column, row), where it lies on the
    /// [`Plot::paper`].
    #[must_use]
    pub fn values_at(&self, (column, row): (u16, u16)) -> Option<DVec2> {
        self.paper().contains((column, row).into()).then(|| {
            let place = self.sheet.view().world_at(column, row);
            dvec2(self.axes[0].value(place.x), self.axes[1].value(place.y))
        })
    }

    /// The least value of y whose mark is clear of the x axis.
    #[must_use]
    pub fn least_clear(&self) -> f64 {
        let (low, _) = self.axes[1].ends();
        self.axes[1].value(low + self.sheet.view().per_row())
    }

    /// Where values lie on the sheet.
    fn place(&self, at: DVec2) -> Option<DVec2> {
        Some(dvec2(self.axes[0].place(at.x)?, self.axes[1].place(at.y)?))
    }

    /// A line through points; it breaks where one has no place.
    pub fn curve(&mut self, points: impl IntoIterator<Item = DVec2>, pen: impl Into<Pen>) {
        let places: Vec<DVec2> = points
            .into_iter()
            .map(|at| self.place(at).unwrap_or(DVec2::NAN))
            .collect();
        self.sheet.polyline(places, pen);
    }

    /// The curve of a function over the whole of the x axis; it breaks where there is
    /// no value.
    pub fn function(&mut self, y: impl Fn(f64) -> Option<f64>, pen: impl Into<Pen>) {
        // Four points a column are finer than any dot of it.
        let pieces = 4 * u32::from(self.paper().width.saturating_sub(1)).max(1);
        let (from, to) = self.axes[0].ends();
        let points: Vec<DVec2> = (0..=pieces)
            .map(|i| {
                let x = self.axes[0].value(from + (to - from) * f64::from(i) / f64::from(pieces));
                y(x).map_or(DVec2::NAN, |y| dvec2(x, y))
            })
            .collect();
        self.curve(points, pen);
    }

    /// An upright line over the whole height at `x`, down to the axis.
    pub fn upright(&mut self, x: f64, pen: impl Into<Pen>) {
        let (low, high) = self.axes[1].ends();
        if let Some(x) = self.axes[0].place(x) {
            let foot = low + self.sheet.view().per_row();
            self.sheet.line(dvec2(x, foot), dvec2(x, high), pen);
        }
    }

    /// A level line over the whole width at `y`, up to the axis.
    pub fn level(&mut self, y: f64, pen: impl Into<Pen>) {
        let (low, high) = self.axes[0].ends();
        if let Some(y) = self.axes[1].place(y) {
            let start = low + self.sheet.view().per_column();
            self.sheet.line(dvec2(start, y), dvec2(high, y), pen);
        }
    }

    /// A bar from the foot of the plot to `height`, between two values of x.
    pub fn bar(&mut self, from: f64, to: f64, height: f64, role: Role) {
        let [x, y] = &self.axes;
        if let (Some(from), Some(to), Some(height)) = (x.place(from), x.place(to), y.place(height))
        {
            self.bars.push(Bar {
                from,
                to,
                height,
                role,
            });
            self.reserve_bar(from, to, height);
        }
    }

    /// Keeps labels off the cells of a bar, in places of the axes.
    fn reserve_bar(&mut self, from: f64, to: f64, height: f64) {
        let view = *self.sheet.view();
        let paper = view.area();
        let half = dvec2(view.per_column(), view.per_row()) / 2.0;
        let x = |column| view.world_at(column, paper.y).x;
        let across = |column: &u16| x(*column) + half.x > from && x(*column) - half.x < to;
        for column in (paper.left()..paper.right()).filter(across) {
            for row in paper.top()..paper.bottom() {
                let at = view.world_at(column, row);
                if at.y - half.y < height {
                    self.sheet.reserve(at);
                }
            }
        }
    }

    /// A symbol, one cell wide, at a point.
    pub fn mark(&mut self, at: DVec2, symbol: char, role: Role) {
        if let Some(place) = self.place(at) {
            self.sheet.reserve(place);
            self.marks.push((place, symbol, role));
        }
    }

    /// A label beside a point, on the first of `sides` that is free. Call it when all
    /// is drawn; says whether it found a place.
    pub fn label(&mut self, text: &str, at: DVec2, sides: &[Side], role: Role) -> bool {
        let place = self.place(at);
        place.is_some_and(|place| self.sheet.label(text, place, sides, role))
    }

    /// Draws it all.
    pub fn draw(&self, buf: &mut Buffer) {
        self.draw_bars(buf);
        self.draw_axes(buf);
        self.draw_names(buf);
        self.sheet.draw(buf, &self.look.theme);
        for (place, symbol, role) in &self.marks {
            if let Some((column, row)) = self.sheet.view().cell_at(*place) {
                let style = self.look.theme.style(*role);
                self.write(buf, (column, row), &symbol.to_string(), style);
            }
        }
    }

    /// Every column but that of the axis takes the bar that its middle is in. A first bar
    /// so narrow that it would be lost in the axis has the column beside it.
    fn draw_bars(&self, buf: &mut Buffer) {
        let paper = self.paper();
        let view = self.sheet.view();
        let first = paper.left() + 1;
        for column in first..paper.right() {
            let x = view.world_at(column, paper.y).x;
            let over = |bar: &&Bar| bar.from <= x && x < bar.to;
            let lost = self.bars.first().filter(|bar| bar.to <= x);
            let narrow = lost.filter(|_| column == first);
            let Some(bar) = narrow.or_else(|| self.bars.iter().find(over)) else {
                continue;
            };
            // Its top in cells; the last row belongs to the axis.
            let top = view.to_cell(dvec2(x, bar.height)).y;
            for row in paper.top()..paper.bottom().saturating_sub(1) {
                let filled = f64::from(row) + 1.0 - top;
                if filled > 0.0 {
                    self.fill(buf, (column, row), filled.min(1.0), bar.role);
                }
            }
        }
    }

    /// Fills a cell from below: to the eighth in Unicode, to the whole in ASCII and where
    /// a curve runs over it, which leaves only the paper behind it to fill.
    fn fill(&self, buf: &mut Buffer, at: (u16, u16), share: f64, role: Role) {
        const EIGHTHS: [&str; 8] = ["", "▁", "▂", "▃", "▄", "▅", "▆", "▇"];
        let theme = &self.look.theme;
        let share = match self.sheet.is_drawn(at) {
            true => share.round(),
            false => share,
        };
        let eighths = (share * 8.0).round() as usize;
        match (self.look.charset, EIGHTHS.get(eighths)) {
            (Charset::Ascii, _) if share < 0.5 => {}
            (Charset::Ascii, _) => self.write(buf, at, ":", theme.style(role)),
            (Charset::Unicode, Some(part)) => self.write(buf, at, part, theme.style(role)),
            (Charset::Unicode, None) if theme.is_mono() => {
                self.write(buf, at, "░", theme.style(role));
            }
            // As paper of another colour, so that a curve can run over it.
            (Charset::Unicode, None) => self.write(buf, at, " ", theme.fill(role)),
        }
    }

    fn draw_axes(&self, buf: &mut Buffer) {
        let paper = self.paper();
        if paper.is_empty() {
            return;
        }
        let style = self.look.theme.style(Role::Axis);
        let [upright, level, corner, y_tick, x_tick] = match self.look.charset {
            Charset::Ascii => ["|", "-", "+", "+", "+"],
            Charset::Unicode => ["│", "─", "└", "┤", "┬"],
        };
        let foot = paper.bottom() - 1;
        for row in paper.top()..foot {
            self.write(buf, (paper.x, row), upright, style);
        }
        for column in paper.left() + 1..paper.right() {
            self.write(buf, (column, foot), level, style);
        }
        self.write(buf, (paper.x, foot), corner, style);
        let view = self.sheet.view();
        let numbers = self.look.theme.style(Role::Dim);
        let ((x0, _), (y0, _)) = (self.axes[0].ends(), self.axes[1].ends());
        let mut free = self.area.x;
        for tick in &self.ticks[0] {
            let Some((column, row)) = view.cell_at(dvec2(tick.place, y0)) else {
                continue;
            };
            if column > paper.x {
                self.write(buf, (column, row), x_tick, style);
            }
            let text = self.look.charset.text(&tick.text);
            let width = text::width(&text) as u16;
            let start = column.saturating_sub(width.saturating_sub(1) / 2).max(free);
            if start + width <= self.area.right() {
                self.write(buf, (start, row + 1), &text, numbers);
                free = start + width + 1;
            }
        }
        for tick in &self.ticks[1] {
            let Some((column, row)) = view.cell_at(dvec2(x0, tick.place)) else {
                continue;
            };
            if row < foot {
                self.write(buf, (column, row), y_tick, style);
            }
            let text = self.look.charset.text(&tick.text);
            let start = column
                .saturating_sub(text::width(&text) as u16)
                .max(self.area.x);
            self.write(buf, (start, row), &text, numbers);
        }
    }

    fn draw_names(&self, buf: &mut Buffer) {
        if self.area.is_empty() {
            return;
        }
        let style = self.look.theme.style(Role::Text);
        let paper = self.paper();
        let [x, y] = [0, 1].map(|i| self.look.charset.text(self.axes[i].name()));
        self.write(buf, (self.area.x, self.area.y), &y, style);
        let spare = paper.width.saturating_sub(text::width(&x) as u16);
        let last = self.area.bottom() - 1;
        if last > paper.bottom() {
            self.write(buf, (paper.x + spare / 2, last), &x, style);
        }
    }

    /// Writes within the plot's area; what does not fit is cut off.
    fn write(&self, buf: &mut Buffer, (column, row): (u16, u16), text: &str, style: Style) {
        let room = self.area.right().saturating_sub(column);
        if buf.area.contains((column, row).into()) && room > 0 {
            buf.set_stringn(column, row, text, room.into(), style);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::widgets::{Depth, Palette, Theme};

    const AREA: Rect = Rect::new(2, 1, 44, 14);

    fn look(charset: Charset) -> Look {
        Look {
            charset,
            theme: Theme::new(Palette::Dark, Depth::None),
        }
    }

    fn log_plot(charset: Charset) -> Plot {
        let angle = Axis::linear("angle (°)", 0.0, 180.0).every(30.0);
        Plot::new(AREA, look(charset), angle, Axis::log("count", 1.0, 1e6))
    }

    fn row(buf: &Buffer, y: u16) -> String {
        let row: String = (0..buf.area.width).map(|x| buf[(x, y)].symbol()).collect();
        row.trim_end().to_owned()
    }

    #[test]
    fn names_and_numbers_stand_at_the_axes() {
        let mut buf = Buffer::empty(Rect::new(0, 0, 48, 16));
        log_plot(Charset::Ascii).draw(&mut buf);
        assert_eq!(row(&buf, 1), "  count");
        assert_eq!(row(&buf, 2).trim(), "10^6+");
        assert_eq!(
            row(&buf, 12).trim(),
            "1+".to_owned() + &row(&buf, 12).trim()[2..]
        );
        assert!(row(&buf, 13).trim().starts_with("0"));
        assert!(row(&buf, 13).ends_with("180"));
        assert!(row(&buf, 14).contains("angle (deg)"));
    }

    #[test]
    fn a_cell_says_its_values_and_they_come_back_to_it() {
        let mut plot = log_plot(Charset::Unicode);
        let paper = plot.paper();
        for column in paper.left()..paper.right() {
            for row in paper.top()..paper.bottom() {
                let at = plot.values_at((column, row)).unwrap();
                plot.marks.clear();
                plot.mark(at, 'x', Role::Contact);
                assert_eq!(
                    plot.sheet.view().cell_at(plot.marks[0].0),
                    Some((column, row))
                );
            }
        }
        assert_eq!(plot.values_at((paper.right(), paper.y)), None);
        let last = plot.values_at((paper.right() - 1, paper.y)).unwrap();
        assert!((last - dvec2(180.0, 1e6)).length() < 1e-6);
    }

    #[test]
    fn what_has_no_place_is_left_out() {
        let mut buf = Buffer::empty(Rect::new(0, 0, 48, 16));
        let mut empty = buf.clone();
        let mut plot = log_plot(Charset::Ascii);
        plot.draw(&mut empty);
        plot.curve([dvec2(10.0, 0.0), dvec2(20.0, -1.0)], Role::CoinOut);
        plot.function(|_| None, Role::CoinOut);
        plot.mark(dvec2(f64::NAN, 1.0), 'x', Role::Contact);
        plot.mark(dvec2(10.0, 1e9), 'x', Role::Contact);
        plot.bar(0.0, 5.0, 0.0, Role::Trail);
        assert!(!plot.label("far", dvec2(10.0, 0.0), &[Side::Above], Role::Text));
        plot.draw(&mut buf);
        assert_eq!(buf, empty);
    }

    #[test]
    fn bars_are_as_high_as_they_are_told() {
        for charset in [Charset::Ascii, Charset::Unicode] {
            let mut buf = Buffer::empty(Rect::new(0, 0, 48, 16));
            let mut plot = log_plot(charset);
            plot.bar(60.0, 120.0, 1000.0, Role::Trail);
            plot.draw(&mut buf);
            let filled = |y: u16| {
                let shown = row(&buf, y);
                shown.contains(':') || shown.contains('░')
            };
            // Eleven rows for six decades: 1000 is in the middle of the sixth.
            assert!(!filled(6) && filled(8) && filled(11), "{buf:?}");
        }
    }

    #[test]
    fn a_bar_under_a_curve_is_as_high_as_it_is_to_half_a_cell() {
        let mut buf = Buffer::empty(Rect::new(0, 0, 40, 16));
        let coloured = Look {
            charset: Charset::Unicode,
            theme: Theme::new(Palette::Dark, Depth::True),
        };
        let mut plot = Plot::new(
            buf.area,
            coloured,
            Axis::linear("x", 0.0, 10.0),
            Axis::linear("y", 0.0, 10.0),
        );
        let height = plot.sheet.view().world_at(0, 5).y + 0.3 * 10.0 / 13.0;
        plot.bar(0.0, 10.0, height, Role::Trail);
        plot.function(|_| Some(height), Role::StrikerOut);
        plot.draw(&mut buf);
        let paper = coloured.theme.fill(Role::Trail).bg;
        assert_eq!(Some(buf[(20, 5)].bg), paper, "{buf:?}");
        assert_ne!(Some(buf[(20, 4)].bg), paper, "{buf:?}");
    }

    #[test]
    fn a_first_bar_narrower_than_a_column_is_not_lost_in_the_axis() {
        let mut buf = Buffer::empty(Rect::new(0, 0, 30, 16));
        let mut plot = Plot::new(
            buf.area,
            look(Charset::Ascii),
            Axis::linear("x", 0.0, 180.0),
            Axis::linear("y", 0.0, 10.0),
        );
        for (from, height) in [(0.0, 9.0), (1.0, 2.0), (2.0, 1.0)] {
            plot.bar(from, from + 1.0, height, Role::Trail);
        }
        plot.draw(&mut buf);
        assert!(row(&buf, 4).contains("|:"), "{buf:?}");
    }

    #[test]
    fn no_size_is_too_small_and_no_range_too_odd() {
        for width in 0..14 {
            for height in 0..9 {
                let area = Rect::new(1, 1, width, height);
                for charset in [Charset::Ascii, Charset::Unicode] {
                    for (from, to) in [(0.0, 1.0), (5.0, 5.0), (f64::NAN, -1.0), (1e300, 1e308)] {
                        let x = Axis::linear("x", from, to).every(0.0);
                        let y = Axis::log("y", from, to);
                        let mut plot = Plot::new(area, look(charset), x, y);
                        plot.bar(from, to, 1.0, Role::Trail);
                        plot.level(0.5, Role::Aim);
                        plot.upright(0.5, Role::Aim);
                        plot.function(Some, Role::CoinOut);
                        plot.label("label", dvec2(0.5, 0.5), &Side::ALL, Role::Text);
                        let mut buf = Buffer::empty(Rect::new(0, 0, 14, 9));
                        plot.draw(&mut buf);
                    }
                }
            }
        }
    }
}
