//! The mapping from the world to the screen.

use glam::{DVec2, dvec2};
use ratatui::layout::Rect;

/// The mapping between world coordinates and an area of cells.
///
/// World coordinates are metres (or the units of a plot's axes), x to the right and y **up**. Cell
/// coordinates are columns and rows of the screen, y **down**; the cell in column `c` reaches from
/// `c` to `c + 1`, so its middle is at `c + 0.5`. A cell is assumed to be twice as high as wide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    area: Rect,
    /// The point in the world that is drawn at `middle`.
    centre: DVec2,
    /// The point on the screen, in cells, at which `centre` is drawn.
    middle: DVec2,
    /// World units per column and per row.
    per_cell: DVec2,
}

impl View {
    /// An undistorted view with `centre` in the middle of the area's middle cell, so that
    /// horizontal and vertical lines through `centre` follow the cells. A `metres_per_column` that
    /// is not positive and finite is replaced by 1.
    pub fn new(area: Rect, centre: DVec2, metres_per_column: f64) -> Self {
        let scale = positive(metres_per_column);
        Self {
            area,
            centre,
            middle: middle(area),
            per_cell: dvec2(scale, 2.0 * scale),
        }
    }

    /// The largest undistorted view that is centred on a rectangle in the world, given by two
    /// opposite corners, and shows all of it.
    pub fn fit(area: Rect, corner: DVec2, opposite: DVec2) -> Self {
        let size = (opposite - corner).abs();
        // The space on the narrower side of the middle limits the scale.
        let free = (middle(area) - top_left(area)).max(dvec2(0.5, 0.5)) * 2.0;
        let scale = (size.x / free.x).max(size.y / (2.0 * free.y));
        Self::new(area, (corner + opposite) / 2.0, scale)
    }

    /// This view, shifted by at most half a cell so that `world` is in the middle of a cell. A
    /// small mark at that point is then drawn exactly there.
    #[must_use]
    pub fn with_in_a_middle(self, world: DVec2) -> Self {
        let cell = self.to_cell(world);
        let shift = cell.floor() + DVec2::splat(0.5) - cell;
        Self {
            middle: self.middle + shift,
            ..self
        }
    }

    /// A view with a separate scale for each axis, for plots: the corners of the given rectangle in
    /// the world are in the middles of the corner cells of the area.
    pub fn stretch(area: Rect, bottom_left: DVec2, top_right: DVec2) -> Self {
        let cells = dvec2(f64::from(area.width), f64::from(area.height)) - DVec2::ONE;
        let size = top_right - bottom_left;
        Self {
            area,
            centre: dvec2(bottom_left.x, top_right.y),
            middle: top_left(area) + dvec2(0.5, 0.5),
            per_cell: dvec2(
                positive(size.x / cells.x.max(1.0)),
                positive(size.y / cells.y.max(1.0)),
            ),
        }
    }

    /// The area of the screen that the view covers.
    pub const fn area(&self) -> Rect {
        self.area
    }

    /// World units per column.
    pub const fn per_column(&self) -> f64 {
        self.per_cell.x
    }

    /// World units per row.
    pub const fn per_row(&self) -> f64 {
        self.per_cell.y
    }

    /// Converts a point in world coordinates to cell coordinates.
    pub fn to_cell(&self, world: DVec2) -> DVec2 {
        let away = (world - self.centre) / self.per_cell;
        self.middle + dvec2(away.x, -away.y)
    }

    /// Converts a point in cell coordinates to world coordinates.
    pub fn to_world(&self, cell: DVec2) -> DVec2 {
        let away = cell - self.middle;
        self.centre + dvec2(away.x, -away.y) * self.per_cell
    }

    /// The cell that contains a point in the world, as (column, row) on the screen; `None` if the
    /// point is outside the area.
    pub fn cell_at(&self, world: DVec2) -> Option<(u16, u16)> {
        let cell = self.to_cell(world);
        let inside = cell.x >= f64::from(self.area.left())
            && cell.x < f64::from(self.area.right())
            && cell.y >= f64::from(self.area.top())
            && cell.y < f64::from(self.area.bottom());
        inside.then_some((cell.x as u16, cell.y as u16))
    }

    /// The point in the world at the middle of a cell, for handling a click on the cell.
    pub fn world_at(&self, column: u16, row: u16) -> DVec2 {
        self.to_world(dvec2(f64::from(column) + 0.5, f64::from(row) + 0.5))
    }
}

/// The corners of the smallest rectangle that contains the circles with these centres and radii.
pub(in crate::widgets) fn around(circles: impl IntoIterator<Item = (DVec2, f64)>) -> [DVec2; 2] {
    let mut corners = [DVec2::INFINITY, DVec2::NEG_INFINITY];
    for (centre, radius) in circles {
        corners[0] = corners[0].min(centre - radius);
        corners[1] = corners[1].max(centre + radius);
    }
    corners
}

/// This scale, or 1 if it is not positive and finite.
pub(in crate::widgets) fn positive(scale: f64) -> f64 {
    let is_scale = scale > 0.0 && scale.is_finite();
    if is_scale { scale } else { 1.0 }
}

fn top_left(area: Rect) -> DVec2 {
    dvec2(f64::from(area.x), f64::from(area.y))
}

/// The middle of an area's middle cell.
fn middle(area: Rect) -> DVec2 {
    let half = |length: u16| f64::from(length.saturating_sub(1) / 2) + 0.5;
    top_left(area) + dvec2(half(area.width), half(area.height))
}

#[cfg(test)]
mod tests {
    use super::*;

    const AREAS: [Rect; 4] = [
        Rect::new(0, 0, 50, 20),
        Rect::new(7, 3, 51, 21),
        Rect::new(2, 1, 1, 1),
        Rect::new(0, 0, 0, 0),
    ];

    #[test]
    fn conversions_are_inverses_of_each_other() {
        for area in AREAS {
            for view in [
                View::new(area, dvec2(0.1, -0.2), 0.004),
                View::fit(area, dvec2(-0.37, -0.37), dvec2(0.37, 0.37)),
                View::stretch(area, dvec2(0.0, 0.0), dvec2(90.0, 1.0)),
                View::new(area, DVec2::ZERO, f64::NAN),
            ] {
                let world = dvec2(0.123, -0.045);
                assert!((view.to_world(view.to_cell(world)) - world).length() < 1e-12);
            }
        }
    }

    #[test]
    fn a_fitted_world_is_completely_inside() {
        for area in [AREAS[0], AREAS[1]] {
            let view = View::fit(area, dvec2(-0.3, 0.5), dvec2(0.7, -0.1));
            for corner in [dvec2(-0.3, 0.5), dvec2(0.7, -0.1)] {
                let cell = view.to_cell(corner) - top_left(area);
                assert!(cell.min_element() > -1e-9, "{cell}");
                assert!(cell.x < f64::from(area.width) + 1e-9, "{cell}");
                assert!(cell.y < f64::from(area.height) + 1e-9, "{cell}");
            }
            assert!((view.per_row() - 2.0 * view.per_column()).abs() < 1e-15);
        }
    }

    #[test]
    fn a_point_is_moved_to_the_middle_of_its_cell() {
        let view = View::fit(AREAS[0], dvec2(-0.3, 0.5), dvec2(0.7, -0.1));
        for at in [dvec2(0.0, 0.0), dvec2(0.123, 0.345), dvec2(-0.29, 0.49)] {
            let moved = view.with_in_a_middle(at);
            let cell = moved.to_cell(at);
            let middle = cell.floor() + DVec2::splat(0.5);
            assert!(cell.distance(middle) < 1e-9, "{cell}");
            let shift = moved.to_cell(at) - view.to_cell(at);
            assert!(shift.abs().max_element() <= 0.5 + 1e-12, "{shift}");
            assert_eq!(moved.per_row(), view.per_row());
        }
    }

    #[test]
    fn a_plot_reaches_the_corner_cells() {
        let view = View::stretch(AREAS[1], dvec2(0.0, 0.0), dvec2(90.0, 1.0));
        assert_eq!(view.cell_at(dvec2(0.0, 0.0)), Some((7, 23)));
        assert_eq!(view.cell_at(dvec2(90.0, 1.0)), Some((57, 3)));
        assert_eq!(view.cell_at(dvec2(95.0, 1.0)), None);
        assert_eq!(view.world_at(7, 23), DVec2::ZERO);
    }
}
