//! Drawing one disc: filled, as a rim with a letter, or as a token if it is small.

use glam::{DVec2, dvec2};

use super::canvas::{Canvas, cell_of};
use super::cell::{Cell, DiscCover, Glyph};
use crate::widgets::picture::{Body, DrawLayer, Pen};
use crate::widgets::{Charset, Role};

/// The height, in rows, below which a disc is drawn as a token. Blocks are finer than letters, so a
/// smaller disc made of blocks still looks round.
pub(super) const fn token_rows(charset: Charset) -> f64 {
    match charset {
        Charset::Ascii => 3.0,
        Charset::Unicode => 1.7,
    }
}

impl Canvas {
    /// Draws a disc with a letter in its middle (a space for none): filled in Unicode, a rim in
    /// ASCII. The disc hides lower layers. A disc that is too small to look round becomes the
    /// [`token`] of its role.
    pub(super) fn disc(&mut self, body: &Body) {
        if body.radius.is_nan() || body.radius <= 0.0 {
            return;
        }
        if self.is_token(body) {
            let place = self.paper(body.at);
            self.stamp(place, token(body.role, self.charset), body.role, false);
        } else {
            self.round(body);
        }
    }

    /// Whether a disc is too small to look round.
    pub(super) fn is_token(&self, body: &Body) -> bool {
        2.0 * body.radius / self.view().per_row() < token_rows(self.charset)
    }

    /// Draws a disc in its true shape at its true position, even if it is small.
    pub(super) fn round(&mut self, body: &Body) {
        let (place, role, letter) = (self.paper(body.at), body.role, body.letter);
        let reach = body.radius / self.view().per_column();
        self.cover(place, reach, (role, false));
        if self.charset == Charset::Ascii {
            let rim = Pen::new(role).on(DrawLayer::Disc);
            self.circle(body.at, body.radius, rim);
        }
        if letter != ' ' {
            let letter = letter.to_string();
            self.stamp(place, &self.charset.text(&letter), role, true);
        }
    }

    /// Draws a disc that hides nothing, with its letter at `letter`: in a faint colour in Unicode
    /// if the terminal has shades, otherwise as an outline.
    pub(super) fn ring(&mut self, body: &Body, letter: DVec2) {
        if self.is_token(body) {
            return self.disc(body);
        }
        let faint = self.has_shades && self.charset == Charset::Unicode;
        if faint {
            let reach = body.radius / self.view().per_column();
            self.cover(self.paper(body.at), reach, (body.role, true));
        } else {
            let rim = Pen::new(body.role).on(DrawLayer::Disc);
            self.circle(body.at, body.radius, rim);
        }
        let place = self.paper(letter);
        let upon = faint || self.charset == Charset::Ascii;
        let sign = body.letter.to_string();
        self.stamp(place, &self.charset.text(&sign), body.role, upon);
    }

    /// Draws a disc as a block of half cells, at most a quarter of a cell from its true place in
    /// each direction. The queen and the striker have the letter of their [`token`], in a cell of
    /// their colour. Their blocks are an even number of half cells wide, so if the letter's cell
    /// sticks out, it moves the middle of the block towards the true place.
    pub(super) fn block(&mut self, body: &Body) {
        let (centre, role) = (self.paper(body.at), body.role);
        let radius = body.radius / self.view().per_column();
        if !(centre.is_finite() && radius.is_finite()) {
            return;
        }
        let charset = self.charset;
        let letter = match role {
            Role::Queen => "Q",
            Role::Striker => "S",
            _ => "",
        };
        let mut size = (radius * dvec2(4.0, 2.0)).round().max(DVec2::ONE);
        if !letter.is_empty() {
            size.x = 2.0 * (size.x / 2.0).ceil();
        }
        let low = (centre * dvec2(2.0, 1.0) - size / 2.0).round() / 2.0;
        let high = low + size / 2.0;
        for row in low.y.floor() as i32..high.y.ceil() as i32 {
            let lines = eighths(low.y, high.y, f64::from(row));
            for column in low.x.floor() as i32..high.x.ceil() as i32 {
                let line = u64::from(eighths(low.x, high.x, f64::from(column)));
                let lines = (0..8).filter(|eighth| lines >> eighth & 1 == 1);
                let bits = match (column, row) == cell_of(centre) && !letter.is_empty() {
                    true => u64::MAX,
                    false => lines.fold(0, |bits, eighth| bits | line << (8 * eighth)),
                };
                if let Some(cell) = self.cell_mut((column, row)) {
                    let faint = false;
                    cell.fill(DiscCover { bits, role, faint }, charset);
                }
            }
        }
        self.stamp(centre, letter, role, true);
    }

    /// Covers the cells under a disc, row by row; all lengths are in paper units.
    fn cover(&mut self, centre: DVec2, radius: f64, (role, faint): (Role, bool)) {
        let charset = self.charset;
        self.covered(centre, radius, |cell, bits| {
            cell.fill(DiscCover { bits, role, faint }, charset);
        });
    }

    /// Calls `each` with every cell under a circle and the covered part of that cell; all lengths
    /// are in paper units.
    pub(super) fn covered(
        &mut self,
        centre: DVec2,
        radius: f64,
        mut each: impl FnMut(&mut Cell, u64),
    ) {
        if !(centre.is_finite() && radius.is_finite()) {
            return;
        }
        let (columns, rows) = self.size();
        let clamp = |value: f64, high: i32| value.floor().clamp(0.0, f64::from(high)) as i32;
        let top = clamp((centre.y - radius) / 2.0, rows);
        let bottom = clamp((centre.y + radius) / 2.0 + 1.0, rows);
        for row in top..bottom {
            // The spans of the eight lines in this row of cells, from left to right, in columns.
            let spans: [Option<(f64, f64)>; 8] = std::array::from_fn(|eighth| {
                let y = 2.0 * f64::from(row) + (eighth as f64 + 0.5) / 4.0 - centre.y;
                let half = radius.mul_add(radius, -y * y);
                (half > 0.0).then(|| (centre.x - half.sqrt(), centre.x + half.sqrt()))
            });
            let left = clamp(centre.x - radius, columns);
            let right = clamp(centre.x + radius + 1.0, columns);
            for column in left..right {
                let bits = spans.iter().enumerate().fold(0, |cover, (eighth, span)| {
                    let bits = span.map_or(0, |(from, to)| eighths(from, to, f64::from(column)));
                    cover | u64::from(bits) << (8 * eighth)
                });
                let cell = self.cell_mut((column, row)).filter(|_| bits != 0);
                if let Some(cell) = cell {
                    each(cell, bits);
                }
            }
        }
    }

    /// Writes a token or a letter centred on a point on paper. An arrow's head never covers a
    /// token, because without its token the disc would be invisible.
    pub(super) fn stamp(&mut self, centre: DVec2, text: &str, role: Role, upon: bool) {
        let width = text.chars().count() as f64;
        let left = centre.x.floor() + 0.5 - (width / 2.0 - 0.5).floor();
        let mut at = dvec2(left, centre.y);
        let layer = match upon {
            true => DrawLayer::Disc,
            false => DrawLayer::Mark,
        };
        for symbol in text.chars() {
            if let Some(cell) = self.cell_at(at) {
                cell.glyph = Some(Glyph {
                    symbol,
                    role,
                    layer,
                    upon,
                    reversed: false,
                });
                cell.reserved = true;
            }
            at.x += 1.0;
        }
    }
}

/// Those eighths of the cell beginning at `column` that have their middles between `from` and `to`.
pub(super) fn eighths(from: f64, to: f64, column: f64) -> u8 {
    let edge = |at: f64| ((at - column) * 8.0 + 0.5).floor().clamp(0.0, 8.0) as u32;
    let (low, high) = (edge(from), edge(to));
    (((1u32 << high) - 1) & !((1u32 << low) - 1)) as u8
}

/// The token of a disc that is too small to be round.
pub(crate) const fn token(role: Role, charset: Charset) -> &'static str {
    match (role, charset) {
        (Role::Striker, _) => "(S)",
        (Role::Queen, _) => "Q",
        (Role::Black, Charset::Ascii) => "@",
        (Role::Marble, Charset::Ascii) => "*",
        (_, Charset::Ascii) => "o",
        (Role::Black, Charset::Unicode) => "●",
        (Role::Marble, Charset::Unicode) => "◆",
        (_, Charset::Unicode) => "○",
    }
}
