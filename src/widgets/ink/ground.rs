//! The parts of a board, which are drawn below everything else.

use glam::DVec2;

use super::canvas::Canvas;
use super::cell::DiscCover;
use super::disc::eighths;
use crate::widgets::picture::Region;
use crate::widgets::{Charset, Role};

impl Canvas {
    /// Fills a part of a board, or draws its outline. In ASCII only whole cells can be filled, so
    /// the outline is drawn as well, and a part without an outline is left out.
    pub(super) fn ground(&mut self, region: Region, role: Role, outline: Option<Role>) {
        let is_ascii = self.charset == Charset::Ascii;
        if self.has_shades && (!is_ascii || outline.is_some()) {
            self.lay(region, role);
        }
        let outline = outline.filter(|_| is_ascii || !self.has_shades);
        match (region, outline) {
            (Region::Square(half), Some(pen)) => {
                let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
                let corners = corners.map(|(x, y)| half * DVec2::new(x, y));
                for (i, corner) in corners.into_iter().enumerate() {
                    self.line(corner, corners[(i + 1) % 4], pen);
                }
            }
            (Region::Circle(centre, radius), Some(pen)) => self.circle(centre, radius, pen),
            (_, None) => {}
        }
    }

    fn lay(&mut self, region: Region, role: Role) {
        let part = |bits| DiscCover {
            bits,
            role,
            faint: false,
        };
        let scale = self.view().per_column();
        match region {
            Region::Square(half) => {
                let (middle, half) = (self.paper(DVec2::ZERO), half / scale);
                let (columns, rows) = self.size();
                let along = |from: f64, to: f64, count: i32| -> Vec<u8> {
                    let part = |cell| eighths(from, to, f64::from(cell));
                    (0..count).map(part).collect()
                };
                let across = along(middle.x - half, middle.x + half, columns);
                let down = along((middle.y - half) / 2.0, (middle.y + half) / 2.0, rows);
                let places = down.iter().flat_map(|y| across.iter().map(|x| (*x, *y)));
                for ((x, y), cell) in places.zip(&mut self.cells) {
                    let lines = (0..8).filter(|line| y >> line & 1 == 1);
                    let bits = lines.fold(0, |bits, line| bits | u64::from(x) << (8 * line));
                    if bits != 0 {
                        part(bits).cover(&mut cell.ground);
                    }
                }
            }
            Region::Circle(centre, radius) => {
                self.covered(self.paper(centre), radius / scale, |cell, bits| {
                    part(bits).cover(&mut cell.ground);
                });
            }
        }
    }
}
