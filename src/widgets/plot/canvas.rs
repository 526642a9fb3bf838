//! Building a plot.

use glam::{DVec2, dvec2};
use ratatui::layout::Rect;

use super::{Axis, ticks::Tick};
use crate::widgets::picture::{Axes, LabelSide, Mark, Pen, Picture, View};
use crate::widgets::{Look, Role, text};

/// A plot under construction: a [`Picture`] whose coordinates are values on the axes.
///
/// Undefined values (0 on a logarithmic axis, NaN) are left out, and lines are clipped at the ends
/// of the axes.
#[derive(Debug, Clone)]
pub(crate) struct Plot {
    axes: [Axis; 2],
    picture: Picture,
}

impl Plot {
    /// Creates an empty plot that fills `area`, with the name of `y` in the first row and the name
    /// of `x` in the last.
    pub(crate) fn new(area: Rect, look: Look, x: Axis, y: Axis) -> Self {
        let rows = area.height.saturating_sub(3);
        let y_ticks = y.ticks(usize::from(rows / 3).max(1));
        let width_of = |(_, name): &Tick| text::width(&look.charset.text(name)) as u16;
        let left = (y_ticks.iter().map(width_of).max().unwrap_or(0) + 1).min(area.width);
        // Half of the last number below the axis extends beyond the right end of the axis.
        let right = 2.min(area.width - left);
        let paper = Rect {
            x: area.x + left,
            y: area.y + 1.min(area.height),
            width: area.width - left - right,
            height: rows,
        };
        // The width of the widest number hardly depends on how many ticks there are.
        let widest = x.ticks(6).iter().map(width_of).max().unwrap_or(1);
        let x_ticks = x.ticks(usize::from(paper.width / (widest + 3)).max(1));
        let ((x0, x1), (y0, y1)) = (x.ends(), y.ends());
        let view = View::stretch(paper, dvec2(x0, y0), dvec2(x1, y1));
        let mut picture = Picture::new(view).within(area);
        picture.marks.push(Mark::Axes(Axes {
            ticks: [x_ticks, y_ticks],
            names: [&x, &y].map(|axis| axis.name.clone()),
        }));
        Self {
            axes: [x, y],
            picture,
        }
    }

    /// The cells of the plot, including the cells of its axes.
    pub(crate) fn paper(&self) -> Rect {
        self.picture.view().area()
    }

    /// The values in the middle of a cell (column, row), if the cell is on the [`Plot::paper`].
    pub(crate) fn values_at(&self, (column, row): (u16, u16)) -> Option<DVec2> {
        self.paper().contains((column, row).into()).then(|| {
            let place = self.picture.view().world_at(column, row);
            dvec2(self.axes[0].value(place.x), self.axes[1].value(place.y))
        })
    }

    /// The smallest value of y at which a mark does not touch the x axis.
    pub(crate) fn least_clear(&self) -> f64 {
        let (low, _) = self.axes[1].ends();
        self.axes[1].value(low + self.picture.view().per_row())
    }

    /// The position of a pair of values in the picture.
    fn place(&self, at: DVec2) -> Option<DVec2> {
        Some(dvec2(self.axes[0].place(at.x)?, self.axes[1].place(at.y)?))
    }

    /// Adds a line through points; the line is interrupted at points that have no position.
    pub(crate) fn curve(&mut self, points: impl IntoIterator<Item = DVec2>, pen: impl Into<Pen>) {
        let place = |at| self.place(at).unwrap_or(DVec2::NAN);
        let places: Vec<DVec2> = points.into_iter().map(place).collect();
        self.picture.curve(places, pen);
    }

    /// Adds the graph of a function over the whole x axis; the graph is interrupted where the
    /// function has no value.
    pub(crate) fn function(&mut self, y: impl Fn(f64) -> Option<f64>, pen: impl Into<Pen>) {
        // Four points per column are closer together than the dots of the screen.
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

    /// Adds a vertical line at `x`, from the top down to the x axis.
    pub(crate) fn vline(&mut self, x: f64, pen: impl Into<Pen>) {
        let (low, high) = self.axes[1].ends();
        if let Some(x) = self.axes[0].place(x) {
            let foot = low + self.picture.view().per_row();
            self.picture.line(dvec2(x, foot), dvec2(x, high), pen);
        }
    }

    /// Adds a horizontal line at `y`, from the y axis to the right edge.
    pub(crate) fn hline(&mut self, y: f64, pen: impl Into<Pen>) {
        let (low, high) = self.axes[0].ends();
        if let Some(y) = self.axes[1].place(y) {
            let start = low + self.picture.view().per_column();
            self.picture.line(dvec2(start, y), dvec2(high, y), pen);
        }
    }

    /// Adds a bar between two values of x, from the bottom of the plot up to `height`.
    pub(crate) fn bar(&mut self, from: f64, to: f64, height: f64, pen: impl Into<Pen>) {
        let [x, y] = &self.axes;
        if let (Some(from), Some(to), Some(height)) = (x.place(from), x.place(to), y.place(height))
        {
            let (low, _) = y.ends();
            self.picture.fill(dvec2(from, low), dvec2(to, height), pen);
        }
    }

    /// Adds a sign, one letter wide, at a point.
    pub(crate) fn mark(&mut self, at: DVec2, symbol: char, role: Role) {
        if let Some(place) = self.place(at) {
            self.picture.text(place, symbol, role);
        }
    }

    /// Adds a label beside a point, on the first of `sides` that is free; earlier labels have
    /// priority.
    pub(crate) fn label(&mut self, text: &str, at: DVec2, sides: &[LabelSide], role: Role) {
        self.label_along(text, [at], sides, role);
    }

    /// Adds a label beside the first of these points that has room for it.
    pub(crate) fn label_along(
        &mut self,
        text: &str,
        points: impl IntoIterator<Item = DVec2>,
        sides: &[LabelSide],
        role: Role,
    ) {
        let places = points.into_iter().filter_map(|at| self.place(at));
        if let [first, others @ ..] = &places.collect::<Vec<_>>()[..] {
            let label = self.picture.label(text, *first, sides, role);
            for at in others {
                label.or(*at, sides);
            }
        }
    }

    /// The finished picture.
    pub(crate) fn picture(self) -> Picture {
        self.picture
    }
}

#[cfg(test)]
mod tests {
    use ratatui::buffer::Buffer;

    use super::*;
    use crate::widgets::{Charset, Depth, Palette, Theme};

    const AREA: Rect = Rect::new(2, 1, 44, 14);

    fn look(charset: Charset) -> Look {
        Look {
            charset,
            theme: Theme::new(Palette::Dark, Depth::None),
            ..Look::default()
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
    fn names_and_numbers_are_beside_the_axes() {
        let mut buf = Buffer::empty(Rect::new(0, 0, 48, 16));
        let picture = log_plot(Charset::Ascii).picture();
        picture.draw(&mut buf, &look(Charset::Ascii));
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
    fn the_values_of_a_cell_are_drawn_in_that_cell() {
        let plot = log_plot(Charset::Unicode);
        let paper = plot.paper();
        for column in paper.left()..paper.right() {
            for row in paper.top()..paper.bottom() {
                let at = plot.values_at((column, row)).unwrap();
                let place = plot.place(at).unwrap();
                assert_eq!(plot.picture.view().cell_at(place), Some((column, row)));
            }
        }
        assert_eq!(plot.values_at((paper.right(), paper.y)), None);
        let last = plot.values_at((paper.right() - 1, paper.y)).unwrap();
        assert!((last - dvec2(180.0, 1e6)).length() < 1e-6);
    }

    #[test]
    fn every_possible_place_of_a_label_is_on_the_axes() {
        let mut plot = log_plot(Charset::Ascii);
        let points = [dvec2(90.0, 0.0), dvec2(60.0, 1e3), dvec2(30.0, 1e5)];
        plot.label_along("here", points, &[LabelSide::Above], Role::Text);
        let picture = plot.picture();
        let places = picture.labels[0].places.iter().map(|(at, _)| *at);
        let places: Vec<_> = places.collect();
        assert_eq!(places, [dvec2(60.0, 3.0), dvec2(30.0, 5.0)]);
    }

    #[test]
    fn values_without_a_place_are_left_out() {
        let mut buf = Buffer::empty(Rect::new(0, 0, 48, 16));
        let mut empty = buf.clone();
        let mut plot = log_plot(Charset::Ascii);
        plot.picture.draw(&mut empty, &look(Charset::Ascii));
        plot.curve([dvec2(10.0, 0.0), dvec2(20.0, -1.0)], Role::CoinOut);
        plot.function(|_| None, Role::CoinOut);
        plot.mark(dvec2(f64::NAN, 1.0), 'x', Role::Contact);
        plot.mark(dvec2(10.0, 1e9), 'x', Role::Contact);
        plot.bar(0.0, 5.0, 0.0, Role::Trail);
        plot.label("far", dvec2(10.0, 0.0), &[LabelSide::Above], Role::Text);
        plot.picture.draw(&mut buf, &look(Charset::Ascii));
        assert_eq!(buf, empty);
    }

    #[test]
    fn bars_have_the_given_height() {
        for charset in [Charset::Ascii, Charset::Unicode] {
            let mut buf = Buffer::empty(Rect::new(0, 0, 48, 16));
            let mut plot = log_plot(charset);
            plot.bar(60.0, 120.0, 1000.0, Role::Trail);
            plot.picture.draw(&mut buf, &look(charset));
            let filled = |y: u16| {
                let shown = row(&buf, y);
                shown.contains(':') || shown.contains('░')
            };
            // Six decades take eleven rows, so 1000 is in the middle of the sixth row.
            assert!(!filled(6) && filled(8) && filled(11), "{buf:?}");
        }
    }

    #[test]
    fn the_height_of_a_bar_under_a_curve_is_accurate_to_half_a_cell() {
        let mut buf = Buffer::empty(Rect::new(0, 0, 40, 16));
        let coloured = Look {
            charset: Charset::Unicode,
            theme: Theme::new(Palette::Dark, Depth::True),
            ..Look::default()
        };
        let mut plot = Plot::new(
            buf.area,
            coloured,
            Axis::linear("x", 0.0, 10.0),
            Axis::linear("y", 0.0, 10.0),
        );
        let height = plot.picture.view().world_at(0, 5).y + 0.3 * 10.0 / 13.0;
        plot.bar(0.0, 10.0, height, Role::Trail);
        plot.function(|_| Some(height), Role::StrikerOut);
        plot.picture.draw(&mut buf, &coloured);
        let paper = coloured.theme.fill(Role::Trail).bg;
        assert_eq!(Some(buf[(20, 5)].bg), paper, "{buf:?}");
        assert_ne!(Some(buf[(20, 4)].bg), paper, "{buf:?}");
    }

    #[test]
    fn a_first_bar_narrower_than_a_column_is_not_hidden_by_the_axis() {
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
        plot.picture.draw(&mut buf, &look(Charset::Ascii));
        assert!(row(&buf, 4).contains("|:"), "{buf:?}");
    }

    #[test]
    fn any_size_and_any_range_is_drawn_without_a_panic() {
        for width in 0..14 {
            for height in 0..9 {
                let area = Rect::new(1, 1, width, height);
                for charset in [Charset::Ascii, Charset::Unicode] {
                    for (from, to) in [(0.0, 1.0), (5.0, 5.0), (f64::NAN, -1.0), (1e300, 1e308)] {
                        let x = Axis::linear("x", from, to).every(0.0);
                        let y = Axis::log("y", from, to);
                        let mut plot = Plot::new(area, look(charset), x, y);
                        plot.bar(from, to, 1.0, Role::Trail);
                        plot.hline(0.5, Role::Aim);
                        plot.vline(0.5, Role::Aim);
                        plot.function(Some, Role::CoinOut);
                        plot.label("label", dvec2(0.5, 0.5), &LabelSide::ALL, Role::Text);
                        let mut buf = Buffer::empty(Rect::new(0, 0, 14, 9));
                        plot.picture.draw(&mut buf, &look(charset));
                    }
                }
            }
        }
    }
}
