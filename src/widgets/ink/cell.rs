//! The contents of one cell.

use crate::widgets::picture::{DrawLayer, Pen};
use crate::widgets::{Charset, Role};

/// The contents of a cell. Patterns are bit masks, row by row from the top left, starting at bit 0.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell {
    /// The samples that strokes pass through, in the charset's grid.
    pub(super) ink: u16,
    /// The pen that determines the cell's style, if there is ink.
    pub(super) pen: Pen,
    /// The topmost disc, and the visible part of the disc below it.
    pub(super) discs: [DiscCover; 2],
    /// The parts of a board, which are below everything else.
    pub(super) ground: [DiscCover; 3],
    /// A glyph that fills the whole cell.
    pub(super) glyph: Option<Glyph>,
    /// Whether labels must not cover the cell.
    pub(super) reserved: bool,
}

/// The part of a cell that a disc covers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct DiscCover {
    /// The covered part, in a grid of 8 × 8.
    pub(super) bits: u64,
    pub(super) role: Role,
    /// Whether the disc is drawn so faintly that marks below it remain visible.
    pub(super) faint: bool,
}

impl DiscCover {
    const NONE: Self = Self {
        bits: 0,
        role: Role::Background,
        faint: false,
    };

    /// Puts this cover first among the `parts` of a cell, in place of the smallest one, and removes
    /// the area that it covers from the others.
    pub(super) fn cover<const N: usize>(self, parts: &mut [Self; N]) {
        if self.bits == u64::MAX {
            *parts = [Self::NONE; N];
        }
        for part in &mut *parts {
            part.bits &= !self.bits;
        }
        parts.sort_by_key(|part| part.bits.count_ones());
        if let Some(smallest) = parts.first_mut() {
            *smallest = self;
        }
    }
}

/// A glyph that fills a whole cell.
#[derive(Debug, Clone, Copy)]
pub(super) struct Glyph {
    pub(super) symbol: char,
    pub(super) role: Role,
    pub(super) layer: DrawLayer,
    /// Whether the glyph is written on a disc of this role instead of in the role's colour.
    pub(super) upon: bool,
    /// Whether foreground and background are swapped.
    pub(super) reversed: bool,
}

impl Cell {
    pub(super) const EMPTY: Self = Self {
        ink: 0,
        pen: Pen::new(Role::Background),
        discs: [DiscCover::NONE; 2],
        ground: [DiscCover::NONE; 3],
        glyph: None,
        reserved: false,
    };

    /// Whether nothing has been drawn in this cell.
    pub(super) fn is_empty(&self) -> bool {
        self.ink == 0 && self.cover() == 0 && self.glyph.is_none() && !self.has_ground()
    }

    /// Whether the cell shows part of a board.
    fn has_ground(&self) -> bool {
        self.ground[0].bits != 0
    }

    /// The role of the largest part of a board in this cell; if two parts are equally large, the
    /// role of the upper one, so that a token beside the frame has the background of the surface.
    pub(super) fn ground_role(&self) -> Option<Role> {
        let parts = self.ground.iter().rev();
        let largest = parts.max_by_key(|part| part.bits.count_ones());
        largest.filter(|_| self.has_ground()).map(|part| part.role)
    }

    /// Whether one part of a board fills the whole cell and no disc covers any of it.
    pub(super) fn is_flat(&self) -> bool {
        self.cover() == 0 && self.ground[0].bits == u64::MAX
    }

    /// The part of the cell that discs cover.
    pub(super) fn cover(&self) -> u64 {
        self.discs[0].bits | self.discs[1].bits
    }

    /// Whether all visible parts of discs in this cell are faint.
    pub(super) fn is_faint(&self) -> bool {
        self.discs.iter().all(|disc| disc.faint || disc.bits == 0)
    }

    /// Whether an edge is clearly visible in this cell: that of a disc or, if the cell has no
    /// strokes other than board lines, that of a part of a board.
    pub(super) fn has_edge(&self) -> bool {
        let is_edge = |cover: &DiscCover| (8..64).contains(&cover.bits.count_ones());
        is_edge(&self.discs[0]) || self.pen.layer == DrawLayer::Ground && is_edge(&self.ground[0])
    }

    /// The topmost layer with a mark in this cell.
    pub(super) fn layer(&self) -> Option<DrawLayer> {
        let ink = (self.ink != 0).then_some(self.pen.layer);
        let disc = (self.cover() != 0).then_some(DrawLayer::Disc);
        ink.max(disc).max(self.glyph.map(|glyph| glyph.layer))
    }

    /// Whether a label that may cover strokes up to the layer `over` can use this cell.
    pub(super) fn is_free(&self, over: Option<DrawLayer>) -> bool {
        !self.reserved && self.cover() == 0 && self.layer() <= over
    }

    pub(super) fn stroke(&mut self, mut samples: u16, pen: Pen, charset: Charset) {
        if pen.layer < DrawLayer::Disc && self.cover() != 0 && !self.is_faint() {
            samples &= !under(self.cover(), charset);
        }
        let [is_point, on_point] = [pen.layer, self.pen.layer].map(|it| it == DrawLayer::Point);
        if samples == 0 || on_point && !is_point {
            return;
        }
        if is_point && !on_point {
            self.ink = 0;
        }
        // A stroke that barely touches a cell with another stroke does not change the cell's style.
        let takes = self.ink == 0 || (pen.layer >= self.pen.layer && samples.count_ones() > 1);
        match charset {
            // No glyph shows a crossing, so showing only the upper stroke is clearer.
            Charset::Ascii if takes => self.ink = samples,
            Charset::Ascii => {}
            Charset::Unicode => self.ink |= samples,
        }
        if takes {
            self.pen = pen;
        }
    }

    /// Adds a disc that covers part of the cell and, unless it is faint, hides everything below.
    pub(super) fn fill(&mut self, disc: DiscCover, charset: Charset) {
        if self.pen.layer < DrawLayer::Disc && !disc.faint {
            self.ink &= !under(disc.bits, charset);
        }
        disc.cover(&mut self.discs);
    }
}

/// The samples in a charset's grid that lie under a covered part of the cell.
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
