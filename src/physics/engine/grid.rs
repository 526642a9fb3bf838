//! A grid of cells over a large board, which is used to find neighbouring discs.
//!
//! Cells are at least as wide as the widest disc, so discs that touch are in the same cell or in
//! neighbouring cells. The forecast of a disc then needs to consider only nine cells, and is
//! repeated when the disc passes into another cell.

use super::super::{Board, Disc, Motion};
use super::frame::FrameSide;

/// The smallest number of discs for which a grid is faster than testing all pairs.
pub(super) const WORTHWHILE: usize = 48;

/// The cells of a board; there are none if all discs count as neighbours.
#[derive(Debug, Default, Clone)]
pub(super) struct Grid {
    /// The number of cells along a side; 0 if there is no grid.
    columns: usize,
    /// The length of a cell's side, in metres.
    size: f64,
    /// Half the length of the board's side, in metres.
    half: f64,
    /// The discs in each cell, row by row from the lower left.
    cells: Vec<Vec<usize>>,
    /// The column and the row of each disc.
    places: Vec<[usize; 2]>,
}

impl Grid {
    /// Creates the grid, with about one disc per cell, if the board has sides and there are enough
    /// discs.
    pub(super) fn begin(&mut self, board: &Board, discs: &[Disc], start: &[Motion]) {
        self.columns = 0;
        if discs.len() < WORTHWHILE || !board.side.is_finite() {
            return;
        }
        let widest = 2.0 * discs.iter().map(|disc| disc.radius).fold(0.0, f64::max);
        let least = widest * (1.0 + 1e-6);
        let wanted = board.side / (discs.len() as f64).sqrt();
        self.columns = ((board.side / least.max(wanted)) as usize).max(1);
        self.size = board.side / self.columns as f64;
        self.half = 0.5 * board.side;
        self.cells.iter_mut().for_each(Vec::clear);
        self.cells.resize(self.columns * self.columns, Vec::new());
        self.places.clear();
        for (i, motion) in start.iter().enumerate() {
            // A cast from a float saturates, so a position that rounding has moved outside the
            // board counts as inside.
            let along = |x: f64| (((x + self.half) / self.size) as usize).min(self.columns - 1);
            let place = [along(motion.position.x), along(motion.position.y)];
            self.places.push(place);
            self.cell(place).push(i);
        }
    }

    /// The discs of a cell, given by its column and row.
    fn cell(&mut self, [column, row]: [usize; 2]) -> &mut Vec<usize> {
        &mut self.cells[row * self.columns + column]
    }

    pub(super) fn is_laid(&self) -> bool {
        self.columns > 0
    }

    /// Finds the discs in the disc's own cell and in the neighbouring cells, including the disc
    /// itself.
    pub(super) fn near(&self, i: usize, near: &mut Vec<usize>) {
        near.clear();
        let [column, row] = self.places[i];
        let last = self.columns - 1;
        for row in row.saturating_sub(1)..=(row + 1).min(last) {
            for column in column.saturating_sub(1)..=(column + 1).min(last) {
                near.extend_from_slice(&self.cells[row * self.columns + column]);
            }
        }
    }

    /// The time in seconds from the start of a slide, at constant speed, until the disc passes into
    /// another cell, and the side on which it leaves its cell; infinite if only the cushion lies
    /// ahead.
    pub(super) fn leaves(&self, i: usize, start: Motion) -> (f64, FrameSide) {
        let to = |place: f64, speed: f64, cell: usize| {
            let edge = if speed > 0.0 && cell + 1 < self.columns {
                cell + 1
            } else if speed < 0.0 && cell > 0 {
                cell
            } else {
                return f64::INFINITY;
            };
            let way = edge as f64 * self.size - self.half - place;
            (way / speed).max(0.0)
        };
        let Motion { position, velocity } = start;
        let [column, row] = self.places[i];
        let x = to(position.x, velocity.x, column);
        let y = to(position.y, velocity.y, row);
        FrameSide::ahead(velocity, x, y)
    }

    /// Moves a disc into the neighbouring cell on this side.
    pub(super) fn cross(&mut self, i: usize, side: FrameSide) {
        self.remove(i);
        let along = &mut self.places[i][side.axis];
        *along = if side.beyond { *along + 1 } else { *along - 1 };
        self.cell(self.places[i]).push(i);
    }

    /// Removes a disc from its cell.
    pub(super) fn remove(&mut self, i: usize) {
        if let Some(&place) = self.places.get(i).filter(|_| self.is_laid()) {
            self.cell(place).retain(|&disc| disc != i);
        }
    }
}
