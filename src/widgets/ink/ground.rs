//! The parts of a board, which are filled below everything else.

use glam::DVec2;

use super::canvas::Canvas;
use super::cell::DiscCover;
use crate::widgets::picture::Region;
use crate::widgets::{Charset, Role};

impl Canvas {
    /// Fills a part of a board, or draws its outline. In ASCII there is always an outline, because
    /// only whole cells can be filled.
    pub(super) fn ground(&mut self, region: Region, role: Role, outline: Option<Role>) {
        if self.has_shades {
            self.lay(region, role);
        }
        let outline = outline.filter(|_| !self.has_shades || self.charset == Charset::Ascii);
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
        let (middle, reach) = match region {
            Region::Square(half) => (DVec2::ZERO, half),
            Region::Circle(centre, radius) => (centre, radius),
        };
        let middle = self.paper(middle);
        let reach = reach / self.view().per_column();
        let span = |y: f64| {
            let half = match region {
                Region::Square(_) => reach * reach,
                Region::Circle(..) => reach * reach - (y - middle.y).powi(2),
            };
            let inside = (y - middle.y).abs() < reach;
            inside.then(|| (middle.x - half.sqrt(), middle.x + half.sqrt()))
        };
        let corner = DVec2::splat(reach);
        self.covered([middle - corner, middle + corner], span, |cell, bits| {
            let part = DiscCover {
                bits,
                role,
                faint: false,
            };
            part.cover(&mut cell.ground);
        });
    }
}
