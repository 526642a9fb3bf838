//! What was drawn of pictures, for whoever can do better than cells.
//!
//! A screen draws itself into cells, and what its pictures were is lost there. A browser
//! can paint true circles: its shell gathers the pictures while it has the screen drawn.
//! They go only to whoever asked, for the one call it asked for.

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
    /// Where its labels have found room.
    pub(in crate::widgets) labels: Vec<PlacedLabel>,
    /// The cells of its area when it was drawn; what lies over it came later.
    pub(in crate::widgets) cells: Buffer,
}

impl DrawnPicture {
    /// The cells that it takes up.
    #[must_use]
    pub fn area(&self) -> Rect {
        self.cells.area
    }
}

/// Does what draws, and gives the pictures that were drawn by it. Who `hides_cells` behind
/// vectors is spared the shades at the edges of discs.
pub fn gather<T>(hides_cells: bool, draw: impl FnOnce() -> T) -> (T, Vec<DrawnPicture>) {
    GATHERED.set(Some(Vec::new()));
    HIDES_CELLS.set(hides_cells);
    let drawn = draw();
    HIDES_CELLS.set(false);
    (drawn, GATHERED.take().unwrap_or_default())
}

/// Whether nobody sees the cells of pictures.
pub(super) fn hides_cells() -> bool {
    HIDES_CELLS.get()
}

/// Notes a picture that has just been drawn into cells, if anyone gathers them.
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
            labels: canvas.labels().to_vec(),
            cells,
        });
    });
}
