//! A plot for paper.

use glam::{DVec2, dvec2};

use super::svg::LETTERS;
use super::{Anchor, Ink, Stroke, Svg};
use crate::widgets::plot::Axis;

/// Room between a tick's number and its axis.
const GAP: f64 = 5.0;
/// Half of a mark.
const MARK: f64 = 2.6;

/// What a point is marked with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// A filled dot.
    Dot,
    /// A ring.
    Ring,
}

/// A plot for paper, in the units of its axes. What is drawn first lies lowest; what has
/// no place on the axes is left out.
#[derive(Debug, Clone)]
pub struct Chart {
    svg: Svg,
    axes: [Axis; 2],
    /// The corners of the area between the axes: lower left and upper right.
    least: DVec2,
    most: DVec2,
}

impl Chart {
    /// An empty plot of this width and height, in units of a picture, with its axes:
    /// the name of `y` above its axis, that of `x` below.
    #[must_use]
    pub fn new(words: &str, width: f64, height: f64, x: Axis, y: Axis) -> Self {
        Self::with_room(words, width, height, 14.0, x, y)
    }

    /// The same with so much room to the right of its axes, for the names of lines.
    #[must_use]
    pub fn with_room(words: &str, width: f64, height: f64, room: f64, x: Axis, y: Axis) -> Self {
        let mut svg = Svg::new(words, width, height);
        let line = LETTERS + 4.0;
        let (top, bottom) = (line + 7.0, height - 2.0 * line - 3.0);
        let y_ticks = y.ticks(((bottom - top) / 28.0) as usize);
        let widest = y_ticks.iter().map(|tick| Svg::label_width(&tick.text));
        let left = widest.fold(0.0, f64::max) + GAP;
        let (least, most) = (dvec2(left, bottom), dvec2(width - room, top));
        svg.label(
            y.name(),
            dvec2(0.0, line / 2.0 - 1.0),
            Anchor::Start,
            Ink::Dim,
        );
        svg.label(
            x.name(),
            dvec2(f64::midpoint(least.x, most.x), height - line / 2.0),
            Anchor::Middle,
            Ink::Dim,
        );
        let mut chart = Self {
            svg,
            axes: [x, y],
            least,
            most,
        };
        chart.draw_axes();
        chart
    }

    fn draw_axes(&mut self) {
        let (least, most) = (self.least, self.most);
        let [x, y] = self.axes.clone();
        for tick in y.ticks(((least.y - most.y) / 28.0) as usize) {
            let at = least.y + share(&y, tick.place) * (most.y - least.y);
            let (from, to) = (dvec2(least.x, at), dvec2(most.x, at));
            self.svg.line(from, to, Stroke::new(Ink::Faint).wide(0.6));
            let end = dvec2(least.x - GAP, at);
            self.svg.label(&tick.text, end, Anchor::End, Ink::Dim);
        }
        let widest = x.ticks(6).into_iter().map(|it| Svg::label_width(&it.text));
        let widest = widest.fold(10.0, f64::max);
        let room = ((most.x - least.x) / (1.8 * widest)) as usize;
        for tick in x.ticks(room.clamp(2, 10)) {
            let at = least.x + share(&x, tick.place) * (most.x - least.x);
            let (from, to) = (dvec2(at, least.y), dvec2(at, least.y + 3.0));
            self.svg.line(from, to, Stroke::new(Ink::Dim));
            let below = dvec2(at, least.y + 5.0 + LETTERS / 2.0);
            self.svg.label(&tick.text, below, Anchor::Middle, Ink::Dim);
        }
        self.svg
            .line(least, dvec2(most.x, least.y), Stroke::new(Ink::Dim));
    }

    /// Fills what lies between two values of y.
    pub fn band(&mut self, from: f64, to: f64, ink: Ink) -> &mut Self {
        let (left, right) = (self.least.x, self.most.x);
        if let (Some(from), Some(to)) = (self.height(from), self.height(to)) {
            self.svg.rectangle(dvec2(left, from), dvec2(right, to), ink);
        }
        self
    }

    /// A line across at a value of y.
    pub fn level(&mut self, y: f64, stroke: Stroke) -> &mut Self {
        let (left, right) = (self.least.x, self.most.x);
        if let Some(y) = self.height(y) {
            self.svg.line(dvec2(left, y), dvec2(right, y), stroke);
        }
        self
    }

    /// A line through points.
    pub fn curve(&mut self, points: impl IntoIterator<Item = DVec2>, stroke: Stroke) -> &mut Self {
        let points: Vec<_> = points.into_iter().filter_map(|it| self.place(it)).collect();
        self.svg.polyline(points, stroke);
        self
    }

    /// Marks a point.
    pub fn mark(&mut self, at: DVec2, mark: Mark, ink: Ink) -> &mut Self {
        if let Some(at) = self.place(at) {
            let (fill, size) = match mark {
                Mark::Dot => (ink, MARK),
                Mark::Ring => (Ink::Paper, MARK - 0.4),
            };
            self.svg
                .circle(at, size, Some(fill), Some(Stroke::new(ink)));
        }
        self
    }

    /// A label whose anchor is `off` beside a point, in units of the picture.
    pub fn label(
        &mut self,
        text: &str,
        at: DVec2,
        off: DVec2,
        anchor: Anchor,
        ink: Ink,
    ) -> &mut Self {
        if let Some(at) = self.place(at) {
            self.svg.label(text, at + off, anchor, ink);
        }
        self
    }

    /// How far up a value of y lies, in units of the picture from its upper edge; `None`
    /// where it has no place.
    #[must_use]
    pub fn height(&self, y: f64) -> Option<f64> {
        let [_, axis] = &self.axes;
        let share = share(axis, axis.place(y)?);
        let within = (-1e-9..=1.0 + 1e-9).contains(&share);
        within.then_some(self.least.y + share * (self.most.y - self.least.y))
    }

    /// The picture.
    #[must_use]
    pub fn picture(self) -> Svg {
        self.svg
    }

    fn place(&self, at: DVec2) -> Option<DVec2> {
        let [axis, _] = &self.axes;
        let share = share(axis, axis.place(at.x)?);
        let within = (-1e-9..=1.0 + 1e-9).contains(&share);
        let x = self.least.x + share * (self.most.x - self.least.x);
        within.then_some(dvec2(x, self.height(at.y)?))
    }
}

/// How far along an axis a place is: 0 at its beginning, 1 at its end.
fn share(axis: &Axis, place: f64) -> f64 {
    let (from, to) = axis.ends();
    (place - from) / (to - from)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart() -> Chart {
        let x = Axis::linear("answer", 0.0, 10.0);
        Chart::new("", 200.0, 100.0, x, Axis::linear("off by (°)", 0.0, 40.0))
    }

    #[test]
    fn the_ends_of_the_axes_are_the_corners() {
        let chart = chart();
        assert_eq!(chart.place(dvec2(0.0, 0.0)), Some(chart.least));
        assert_eq!(chart.place(dvec2(10.0, 40.0)), Some(chart.most));
        let middle = chart.place(dvec2(5.0, 20.0)).unwrap();
        assert!(middle.distance(chart.least.midpoint(chart.most)) < 1e-9);
    }

    #[test]
    fn what_has_no_place_is_left_out() {
        let mut chart = chart();
        let before = chart.svg.file();
        for (x, y) in [
            (-1.0, 0.0),
            (11.0, 0.0),
            (0.0, 41.0),
            (f64::NAN, 0.0),
            (0.0, f64::INFINITY),
        ] {
            chart.mark(dvec2(x, y), Mark::Dot, Ink::Text);
            chart.curve([dvec2(x, y)], Stroke::new(Ink::Text));
            chart.label("x", dvec2(x, y), DVec2::ZERO, Anchor::Start, Ink::Text);
        }
        chart
            .level(-1.0, Stroke::new(Ink::Text))
            .band(0.0, 99.0, Ink::Wash);
        assert_eq!(chart.svg.file(), before);
    }
}
