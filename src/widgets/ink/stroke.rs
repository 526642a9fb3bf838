//! The conversion of lines on paper to samples in cells.
//!
//! **Paper** is the area measured in columns in both directions, x to the right and y down from
//! its top left corner. On paper a cell is 1 wide and 2 high, so shapes are not distorted.

use glam::{DVec2, dvec2};

use crate::widgets::picture::{Dash, Pen};

/// The samples of one stroke, cell by cell in the order in which the stroke passes through them.
#[derive(Debug, Clone)]
pub(super) struct StrokeSamples {
    /// The number of samples in a cell: columns, rows.
    grid: (usize, usize),
    /// The number of cells in the area: columns, rows.
    size: (usize, usize),
    /// The samples of each cell; between strokes there are none.
    samples: Vec<u16>,
    /// The cells that have samples, in the order in which the stroke passed through them.
    touched: Vec<usize>,
    /// The length of the stroke so far, in samples and including its gaps.
    length: usize,
    /// The point that was marked last, in samples.
    last: Option<DVec2>,
}

impl StrokeSamples {
    pub(super) fn new(grid: (usize, usize), size: (usize, usize)) -> Self {
        Self {
            grid,
            size,
            samples: vec![0; size.0 * size.1],
            touched: Vec::new(),
            length: 0,
            last: None,
        }
    }

    /// Ends the stroke, and passes each of its cells with the samples in it to `each`, in order.
    pub(super) fn take(&mut self, mut each: impl FnMut(usize, usize, u16)) {
        self.length = 0;
        self.last = None;
        for (order, index) in self.touched.drain(..).enumerate() {
            if let Some(samples) = self.samples.get_mut(index) {
                each(order, index, std::mem::take(samples));
            }
        }
    }

    /// The size of a sample, in paper units.
    fn sample(&self) -> DVec2 {
        dvec2(1.0 / self.grid.0 as f64, 2.0 / self.grid.1 as f64)
    }

    /// The number of samples in the whole area, horizontally and vertically.
    fn samples(&self) -> DVec2 {
        let [(columns, rows), (along, down)] = [self.size, self.grid];
        dvec2((columns * along) as f64, (rows * down) as f64)
    }

    /// Adds a straight piece from `from` up to, but not including, `to`: adjacent pieces share no
    /// sample, and each sample along the longer direction is hit once.
    pub(super) fn piece(&mut self, from: DVec2, to: DVec2, pen: Pen) {
        let (a, b) = (from / self.sample(), to / self.sample());
        if !(a.is_finite() && b.is_finite()) {
            return;
        }
        let size = self.samples();
        let along = b - a;
        if along.x.abs() >= along.y.abs() {
            for x in steps(a.x, b.x, size.x) {
                let y = a.y + along.y * ((x - a.x) / along.x);
                self.hit(dvec2(x, y), dvec2(0.0, 0.5), pen);
            }
        } else {
            for y in steps(a.y, b.y, size.y) {
                let x = a.x + along.x * ((y - a.y) / along.y);
                self.hit(dvec2(x, y), dvec2(0.5, 0.0), pen);
            }
        }
    }

    /// Adds the last point of a stroke, which its pieces leave out.
    pub(super) fn end(&mut self, at: DVec2, pen: Pen) {
        let at = at / self.sample();
        if at.is_finite() {
            self.hit(at, DVec2::ZERO, pen);
        }
    }

    /// Adds a dot. A single sample near the edge of a cell has no glyph in ASCII, so the dot moves
    /// to the nearest sample that has one.
    pub(super) fn dot(&mut self, at: DVec2, pen: Pen) {
        let mut at = at / self.sample();
        if !at.is_finite() {
            return;
        }
        if self.is_ascii() {
            let grid = dvec2(self.grid.0 as f64, self.grid.1 as f64);
            let cell = (at / grid).floor() * grid;
            let row = (at.y - cell.y).clamp(1.0, grid.y - 1.5);
            at = cell + dvec2(grid.x / 2.0, row);
        }
        self.hit(at, DVec2::ZERO, pen);
    }

    pub(super) fn triangle(&mut self, corners: [DVec2; 3]) {
        let [a, b, c] = corners.map(|corner| corner / self.sample());
        if !(a.is_finite() && b.is_finite() && c.is_finite()) {
            return;
        }
        let turn = (b - a).perp_dot(c - a).signum();
        let low = a.min(b).min(c).floor().max(DVec2::ZERO);
        let high = a.max(b).max(c).ceil();
        let left_of = |p: DVec2, q: DVec2, at: DVec2| (q - p).perp_dot(at - p) * turn >= -1e-9;
        let all = self.samples();
        for y in steps(low.y, high.y, all.y) {
            for at in steps(low.x, high.x, all.x).map(|x| dvec2(x, y)) {
                if left_of(a, b, at) && left_of(b, c, at) && left_of(c, a, at) {
                    self.mark(at);
                }
            }
        }
    }

    /// Marks the point `at` of the stroke, in samples; a bold stroke covers the two nearest samples,
    /// at an offset of `half` to either side.
    fn hit(&mut self, at: DVec2, half: DVec2, pen: Pen) {
        let place = self.length;
        self.length += 1;
        // In ASCII a gap is a whole cell, which `Canvas::commit` leaves out.
        let inked = self.is_ascii()
            || match pen.dash {
                Dash::Solid => true,
                Dash::Dashed => place % 7 < 4,
                Dash::Dotted => place.is_multiple_of(3),
            };
        if !inked {
            return;
        }
        // Where a curve changes from flat to steep, it can skip a sample.
        if let Some(last) = self.last
            && pen.dash == Dash::Solid
            && (1.5..2.5).contains(&(at.floor() - last.floor()).abs().max_element())
        {
            self.mark((at + last) / 2.0);
        }
        self.last = Some(at);
        if pen.bold && !self.is_ascii() {
            self.mark(at - half);
            self.mark(at + half);
        } else {
            self.mark(at);
        }
    }

    fn is_ascii(&self) -> bool {
        self.grid.0 == 3
    }

    fn mark(&mut self, at: DVec2) {
        let (columns, rows) = self.size;
        if at.x < 0.0 || at.y < 0.0 {
            return;
        }
        let (x, y) = (at.x as usize, at.y as usize);
        let (column, row) = (x / self.grid.0, y / self.grid.1);
        if column >= columns || row >= rows {
            return;
        }
        let index = row * columns + column;
        if let Some(samples) = self.samples.get_mut(index) {
            if *samples == 0 {
                self.touched.push(index);
            }
            *samples |= 1 << (y % self.grid.1 * self.grid.0 + x % self.grid.0);
        }
    }
}

/// The middles of the samples from `from` up to, but not including, `to`, in the direction of the
/// stroke, limited to the range from 0 to `limit`.
fn steps(from: f64, to: f64, limit: f64) -> impl Iterator<Item = f64> {
    let forward = to > from;
    let (low, high) = if forward {
        ((from - 0.5).ceil(), (to - 0.5).ceil())
    } else {
        ((to - 0.5).floor() + 1.0, (from - 0.5).floor() + 1.0)
    };
    let (low, high) = (low.max(0.0) as usize, high.clamp(0.0, limit) as usize);
    let count = high.saturating_sub(low);
    (0..count).map(move |i| {
        let i = if forward { low + i } else { high - 1 - i };
        i as f64 + 0.5
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::widgets::Role;

    #[test]
    fn adjacent_pieces_share_no_sample() {
        for (from, to) in [(0.2, 7.3), (7.3, 0.2), (0.5, 4.5), (4.5, 0.5)] {
            let between = 3.5;
            let whole: Vec<f64> = steps(from, to, 100.0).collect();
            let halves: Vec<f64> = steps(from, between, 100.0)
                .chain(steps(between, to, 100.0))
                .collect();
            assert_eq!(whole, halves);
        }
        assert_eq!(steps(-1e300, 1e300, 10.0).count(), 10);
    }

    #[test]
    fn a_line_hits_each_sample_of_its_longer_direction_once() {
        let mut stroke = StrokeSamples::new((2, 4), (20, 5));
        stroke.piece(dvec2(0.0, 1.0), dvec2(20.0, 5.0), Pen::new(Role::Text));
        let mut count = 0;
        stroke.take(|_, _, samples| count += samples.count_ones());
        assert_eq!(count, 40);
    }
}
