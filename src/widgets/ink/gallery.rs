//! The pictures drawn so far, for a shell that can show more than cells.
//!
//! A screen draws itself into cells, where the shapes of its pictures are lost. A browser can draw
//! true circles, so its shell collects the pictures during a call that draws the screen. Only the
//! caller receives these pictures.

use std::cell::{Cell, RefCell};

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Canvas, PlacedLabel};
use crate::widgets::picture::Picture;
use crate::widgets::{Look, sheet};

thread_local! {
    static GATHERED: RefCell<Option<Vec<DrawnPicture>>> = const { RefCell::new(None) };
    static HIDES_CELLS: Cell<bool> = const { Cell::new(false) };
}

/// A picture that was drawn into cells.
#[derive(Debug, Clone)]
pub struct DrawnPicture {
    pub(in crate::widgets) picture: Picture,
    pub(in crate::widgets) look: Look,
    /// The positions of its labels.
    pub(in crate::widgets) labels: Vec<PlacedLabel>,
    /// The cells of its area at the time when it was drawn. Cells that have changed since then were
    /// drawn over.
    pub(in crate::widgets) cells: Buffer,
}

impl DrawnPicture {
    /// The area that it fills.
    pub fn area(&self) -> Rect {
        self.cells.area
    }
}

/// Runs the drawing function and returns its result together with the pictures that it drew. If the
/// cells are hidden by vectors (`hides_cells`), the shades at the edges of discs are skipped.
pub fn gather<T>(hides_cells: bool, draw: impl FnOnce() -> T) -> (T, Vec<DrawnPicture>) {
    GATHERED.set(Some(Vec::new()));
    HIDES_CELLS.set(hides_cells);
    let drawn = draw();
    HIDES_CELLS.set(false);
    (drawn, GATHERED.take().unwrap_or_default())
}

/// Whether the cells of pictures are hidden by vectors.
pub(super) fn hides_cells() -> bool {
    HIDES_CELLS.get()
}

/// Records a picture that has just been drawn into cells, if a shell is collecting pictures.
pub(super) fn note(picture: &Picture, canvas: &Canvas, buffer: &Buffer, look: &Look) {
    sheet::picture(picture.area());
    GATHERED.with_borrow_mut(|gathered| {
        let Some(gathered) = gathered else {
            return;
        };
        let mut cells = Buffer::empty(picture.area().intersection(buffer.area));
        for at in cells.area.positions() {
            cells[at] = buffer[at].clone();
        }
        gathered.push(DrawnPicture {
            picture: picture.clone(),
            look: *look,
            labels: canvas.labels.clone(),
            cells,
        });
    });
}
