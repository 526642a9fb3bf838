//! Arrows.

use glam::DVec2;

use super::{canvas::Canvas, cell::Glyph};
use crate::widgets::{Charset, picture::Pen};

/// The length of an arrow's head, in columns; a very short arrow has a shorter head.
const HEAD_LENGTH: f64 = 3.0;
/// The length of the head of a bold arrow, in columns.
const BOLD_HEAD_LENGTH: f64 = 4.0;
/// Half the width of an arrow's head, as a fraction of the head's length.
const HEAD_SLIMNESS: f64 = 0.45;

impl Canvas {
    /// Draws an arrow from one point to another, with its tip at `to` (in ASCII: in the cell of
    /// `to`). Labels do not cover the tip.
    pub(super) fn arrow(&mut self, from: DVec2, to: DVec2, pen: impl Into<Pen>) {
        let pen = pen.into();
        let (tail, tip) = self.snapped(self.paper(from), self.paper(to), pen);
        let along = tip - tail;
        if !(along.is_finite() && along.length() > 1e-9) {
            return;
        }
        match self.charset {
            Charset::Unicode => self.filled_head(tail, tip, pen),
            Charset::Ascii => self.glyph_head(tail, tip, pen),
        }
        if let Some(cell) = self.cell_at(tip) {
            cell.reserved = true;
        }
    }

    fn filled_head(&mut self, tail: DVec2, tip: DVec2, pen: Pen) {
        let length = (tip - tail).length();
        let forward = (tip - tail) / length;
        let full = if pen.bold {
            BOLD_HEAD_LENGTH
        } else {
            HEAD_LENGTH
        };
        let head = full.min(0.6 * length);
        let base = tip - forward * head;
        let side = forward.perp() * head * HEAD_SLIMNESS;
        let stroke = &mut self.stroke;
        stroke.piece(tail, base, pen);
        stroke.triangle([tip, base + side, base - side]);
        // Near the tip the triangle is narrower than a dot, so its axis is drawn.
        stroke.piece(base, tip, Pen::new(pen.role));
        self.commit(pen);
    }

    fn glyph_head(&mut self, tail: DVec2, tip: DVec2, pen: Pen) {
        // The shaft ends in the middle of the cell that contains the tip's glyph.
        let middle = DVec2::new(tip.x.floor() + 0.5, 2.0 * (tip.y / 2.0).floor() + 1.0);
        self.stroke.piece(tail, middle, pen);
        self.commit(pen);
        let along = tip - tail;
        let symbol = match (along.x.abs() >= along.y.abs(), along.x > 0.0, along.y > 0.0) {
            (true, true, _) => '>',
            (true, false, _) => '<',
            (false, _, true) => 'v',
            (false, _, false) => '^',
        };
        if let Some(cell) = self.cell_at(tip)
            && cell.glyph.is_none_or(|glyph| glyph.layer <= pen.layer)
        {
            cell.glyph = Some(Glyph {
                symbol,
                role: pen.role,
                layer: pen.layer,
                upon: false,
                reversed: false,
            });
        }
    }
}
