//! What has been drawn in one cell.

use crate::widgets::picture::{DrawLayer, Pen};
use crate::widgets::{Charset, Role};

/// What has been drawn in one cell. Patterns are bit masks, row by row from the
/// top left, bit 0 first.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell {
    /// The samples strokes went through, in the charset's own grid.
    pub(super) ink: u16,
    /// The pen the cell looks like, where there is ink.
    pub(super) pen: Pen,
    /// What a disc covers, in a grid of 8 × 8.
    pub(super) cover: u64,
    /// That disc, and …
    pub(super) disc: Role,
    /// … another one that fills most of the rest of the cell.
    pub(super) beside: Option<Role>,
    /// A glyph that stands for all the cell.
    pub(super) glyph: Option<Glyph>,
    /// Labels keep off.
    pub(super) reserved: bool,
}

/// A glyph that stands for all of a cell.
#[derive(Debug, Clone, Copy)]
pub(super) struct Glyph {
    pub(super) symbol: char,
    pub(super) role: Role,
    pub(super) layer: DrawLayer,
    /// Written upon a disc of this role rather than in its colour.
    pub(super) upon: bool,
    /// Paper and ink change places.
    pub(super) reversed: bool,
}

impl Cell {
    pub(super) const EMPTY: Self = Self {
        ink: 0,
        pen: Pen::new(Role::Background),
        cover: 0,
        disc: Role::Background,
        beside: None,
        glyph: None,
        reserved: false,
    };

    /// Whether nothing has been drawn here.
    pub(super) fn is_empty(&self) -> bool {
        self.ink == 0 && self.cover == 0 && self.glyph.is_none()
    }

    /// Whether the edge of a disc is plain to see in this cell.
    pub(super) fn has_edge(&self) -> bool {
        (8..64).contains(&self.cover.count_ones())
    }

    /// The topmost layer that has been drawn on here.
    pub(super) fn layer(&self) -> Option<DrawLayer> {
        let ink = (self.ink != 0).then_some(self.pen.layer);
        let disc = (self.cover != 0).then_some(DrawLayer::Disc);
        ink.max(disc).max(self.glyph.map(|glyph| glyph.layer))
    }

    /// Whether a label may stand here, over strokes up to a layer.
    pub(super) fn is_free(&self, over: Option<DrawLayer>) -> bool {
        !self.reserved && self.cover == 0 && self.layer() <= over
    }

    /// A stroke goes through `samples`.
    pub(super) fn stroke(&mut self, mut samples: u16, pen: Pen, charset: Charset) {
        if pen.layer < DrawLayer::Disc && self.cover != 0 {
            samples &= !under(self.cover, charset);
        }
        if samples == 0 {
            return;
        }
        // A stroke that only nips a cell another one goes through leaves it be.
        let takes = self.ink == 0 || (pen.layer >= self.pen.layer && samples.count_ones() > 1);
        match charset {
            // No glyph shows a crossing: the upper stroke alone reads better.
            Charset::Ascii if takes => self.ink = samples,
            Charset::Ascii => {}
            Charset::Unicode => self.ink |= samples,
        }
        if takes {
            self.pen = pen;
        }
    }

    /// A disc covers part of the cell and hides what lies below.
    pub(super) fn fill(&mut self, cover: u64, disc: Role, charset: Charset) {
        if self.pen.layer < DrawLayer::Disc {
            self.ink &= !under(cover, charset);
        }
        let rest = (!cover).count_ones();
        let other = (self.cover & !cover).count_ones();
        self.beside = (other > 0 && 2 * other >= rest).then_some(self.disc);
        self.cover = cover;
        self.disc = disc;
    }
}

/// The samples of a charset's grid that a cover hides.
fn under(cover: u64, charset: Charset) -> u16 {
    let (columns, rows) = super::grid(charset);
    (0..columns * rows)
        .filter(|sample| {
            let x = (2 * (sample % columns) + 1) * 4 / columns;
            let y = (2 * (sample / columns) + 1) * 4 / rows;
            cover >> (8 * y + x) & 1 == 1
        })
        .fold(0, |mask, sample| mask | 1 << sample)
}
