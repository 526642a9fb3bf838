//! What has been drawn in one cell.

use crate::widgets::picture::{DrawLayer, Pen};
use crate::widgets::{Charset, Role};

/// The contents of a cell. Patterns are bit masks, row by row from the top left, bit 0 first.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell {
    /// The samples strokes went through, in the charset's own grid.
    pub(super) ink: u16,
    /// The pen whose style the cell has, if there is ink.
    pub(super) pen: Pen,
    /// The disc on top, and the visible part of the one below it.
    pub(super) discs: [DiscCover; 2],
    /// A glyph that stands for all the cell.
    pub(super) glyph: Option<Glyph>,
    /// Labels keep off.
    pub(super) reserved: bool,
}

/// What a disc covers of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct DiscCover {
    /// In a grid of 8 × 8.
    pub(super) bits: u64,
    pub(super) role: Role,
    /// So faint that marks above and below it are visible.
    pub(super) faint: bool,
}

impl DiscCover {
    const NONE: Self = Self {
        bits: 0,
        role: Role::Background,
        faint: false,
    };
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
        discs: [DiscCover::NONE; 2],
        glyph: None,
        reserved: false,
    };

    /// Whether nothing has been drawn here.
    pub(super) fn is_empty(&self) -> bool {
        self.ink == 0 && self.cover() == 0 && self.glyph.is_none()
    }

    /// What is covered by discs.
    pub(super) fn cover(&self) -> u64 {
        self.discs[0].bits | self.discs[1].bits
    }

    /// Whether all visible parts of discs here are faint.
    pub(super) fn is_faint(&self) -> bool {
        self.discs.iter().all(|disc| disc.faint || disc.bits == 0)
    }

    /// Whether the edge of a disc is clearly visible in this cell.
    pub(super) fn has_edge(&self) -> bool {
        (8..64).contains(&self.discs[0].bits.count_ones())
    }

    /// The topmost layer that has been drawn on here.
    pub(super) fn layer(&self) -> Option<DrawLayer> {
        let ink = (self.ink != 0).then_some(self.pen.layer);
        let disc = (self.cover() != 0).then_some(DrawLayer::Disc);
        ink.max(disc).max(self.glyph.map(|glyph| glyph.layer))
    }

    /// Whether a label may stand here, over strokes up to a layer.
    pub(super) fn is_free(&self, over: Option<DrawLayer>) -> bool {
        !self.reserved && self.cover() == 0 && self.layer() <= over
    }

    /// A stroke goes through `samples`.
    pub(super) fn stroke(&mut self, mut samples: u16, pen: Pen, charset: Charset) {
        if pen.layer < DrawLayer::Disc && self.cover() != 0 && !self.is_faint() {
            samples &= !under(self.cover(), charset);
        }
        if samples == 0 {
            return;
        }
        // A stroke that only touches a cell of another one does not change it.
        let takes = self.ink == 0 || (pen.layer >= self.pen.layer && samples.count_ones() > 1);
        match charset {
            // No glyph shows a crossing, so the upper stroke alone is clearer.
            Charset::Ascii if takes => self.ink = samples,
            Charset::Ascii => {}
            Charset::Unicode => self.ink |= samples,
        }
        if takes {
            self.pen = pen;
        }
    }

    /// A disc covers part of the cell; unless it is faint it hides what lies below.
    pub(super) fn fill(&mut self, disc: DiscCover, charset: Charset) {
        if self.pen.layer < DrawLayer::Disc && !disc.faint {
            self.ink &= !under(disc.bits, charset);
        }
        let [top, below] = self.discs;
        // Of three only the two that cover most are kept.
        let rest = [top, below].map(|it| DiscCover {
            bits: it.bits & !disc.bits,
            ..it
        });
        let most = rest.into_iter().max_by_key(|it| it.bits.count_ones());
        self.discs = [disc, most.unwrap_or(DiscCover::NONE)];
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
