//! Many discs on one board, all drawn in the same way and all visible.

use glam::{DVec2, dvec2};

use super::canvas::{Canvas, CellPlace, cell_of};
use super::disc::{token, token_rows};
use crate::widgets::{Charset, Role, picture::Body};

/// The maximum distance between a token and its disc's true cell, in columns and in rows.
const FARTHEST: i32 = 4;

/// The width of an [`outline`], in columns.
const OUTLINE_WIDTH: i32 = 3;

/// The radius, in columns, below which a disc is drawn as an [`outline`].
const OUTLINED: f64 = 2.0;

/// Discs that would not look round are drawn as blocks if the height of the smallest disc, in rows,
/// is below this limit, which is slightly less than the height of a coin on the whole board in a
/// window with 30 rows.
const BLOCK_ROWS: f64 = 1.05;

/// The radius of the ring around a marked disc, in units of the disc's radius.
const RING: f64 = 1.25;

impl Canvas {
    /// Draws discs at one scale: all as [tokens](token) if the smallest is too small, otherwise as
    /// circles, with [blocks](Self::block) for those that would not look round.
    ///
    /// A round disc is at its true position, with its letter in the cell that contains its centre.
    /// Tokens and outlines never share cells: if two would overlap, the one farther from the middle
    /// of its cell moves to the nearest free cell, but the queen never moves, and the striker only
    /// for the queen. No stroke or arrow hides a token, whatever the drawing order.
    pub(super) fn discs(&mut self, bodies: &[Body]) {
        if self.are_round(bodies) {
            let real = bodies.iter().filter(|body| body.radius > 0.0);
            // Without colours adjacent blocks merge, so a small disc is drawn as an outline with
            // its token.
            let is_outline =
                |body: &&Body| self.is_mono && body.radius / self.view().per_column() < OUTLINED;
            let (outlined, mut round): (Vec<_>, Vec<&Body>) = real.partition(is_outline);
            // In a tight pack of small discs, nothing covers the queen.
            round.sort_by_key(|body| body.role == Role::Queen);
            for (place, body) in self.places(outlined, |_| OUTLINE_WIDTH) {
                self.stamp(middle(place), &outline(body.role), body.role, false);
            }
            for body in round {
                match self.is_block(body, bodies) {
                    true => self.block(body),
                    false => self.round(body),
                }
            }
            for body in bodies.iter().filter(|body| body.pointed_out) {
                self.circle(body.at, RING * body.radius, Role::Good);
            }
        } else {
            for (place, body) in self.token_places(bodies) {
                let token = token(body.role, self.charset);
                self.stamp(middle(place), token, body.role, false);
                let glyph = self.cell_mut(place).and_then(|cell| cell.glyph.as_mut());
                if let Some(glyph) = glyph.filter(|_| body.pointed_out) {
                    glyph.reversed = true;
                }
            }
        }
    }

    /// Whether discs at one scale are drawn as circles, blocks or outlines rather than as tokens,
    /// which is the case if the smallest disc is high enough to be distinguished from its
    /// neighbours.
    pub(super) fn are_round(&self, bodies: &[Body]) -> bool {
        let fewest_rows = match self.charset {
            Charset::Ascii => token_rows(self.charset),
            // This is slightly less than the height of a coin on the whole board in a window with
            // 24 rows.
            Charset::Unicode if self.has_shades => 0.8,
            Charset::Unicode => 1.4,
        };
        self.rows_of_smallest(bodies) >= fewest_rows
    }

    /// Whether a disc among others is drawn as a block. This is the case if the disc would not look
    /// round, and the smallest disc is so small that its soft edge would be larger than the rest of
    /// it.
    pub(super) fn is_block(&self, body: &Body, bodies: &[Body]) -> bool {
        let is_soft = self.charset == Charset::Unicode && self.has_shades;
        is_soft && self.rows_of_smallest(bodies) < BLOCK_ROWS && self.is_token(body)
    }

    /// The height of the smallest of these discs, in rows.
    fn rows_of_smallest(&self, bodies: &[Body]) -> f64 {
        let smallest = bodies.iter().map(|body| body.radius);
        2.0 * smallest.fold(f64::INFINITY, f64::min) / self.view().per_row()
    }

    /// The cells of the tokens of these discs.
    pub(super) fn token_places<'a>(&self, bodies: &'a [Body]) -> Vec<(CellPlace, &'a Body)> {
        let width = |body: &Body| token(body.role, self.charset).chars().count() as i32;
        self.places(bodies, width)
    }

    /// Assigns separate cells to bodies, each drawn one row high and as many columns wide as
    /// `width` returns.
    fn places<'a>(
        &self,
        bodies: impl IntoIterator<Item = &'a Body>,
        width: impl Fn(&Body) -> i32,
    ) -> Vec<(CellPlace, &'a Body)> {
        let mut crowd: Vec<(DVec2, &Body)> = bodies
            .into_iter()
            .map(|body| (self.paper(body.at), body))
            .filter(|(at, _)| self.index(cell_of(*at)).is_some())
            .collect();
        let rank = |role| match role {
            Role::Queen => 0,
            Role::Striker => 1,
            _ => 2,
        };
        crowd.sort_by(|(a, first), (b, second)| {
            let apart = |at: &DVec2| at.distance(middle(cell_of(*at)));
            let ranks = rank(first.role).cmp(&rank(second.role));
            ranks.then_with(|| apart(a).total_cmp(&apart(b)))
        });
        let mut taken: Vec<CellPlace> = Vec::with_capacity(crowd.len() + 2);
        let mut places = Vec::with_capacity(crowd.len());
        for (at, body) in crowd {
            let beside = width(body) / 2;
            let is_free = |(column, row): CellPlace| {
                (column - beside..=column + beside).all(|column| !taken.contains(&(column, row)))
            };
            let Some(place) = self.nearest(at, is_free) else {
                continue;
            };
            taken.extend((place.0 - beside..=place.0 + beside).map(|column| (column, place.1)));
            places.push((place, body));
        }
        places
    }

    /// The free cell nearest to a point on paper.
    fn nearest(&self, at: DVec2, is_free: impl Fn(CellPlace) -> bool) -> Option<CellPlace> {
        let (column, row) = cell_of(at);
        let around = (-FARTHEST..=FARTHEST)
            .flat_map(|down| (-FARTHEST..=FARTHEST).map(move |along| (column + along, row + down)));
        around
            .filter(|place| self.index(*place).is_some() && is_free(*place))
            .min_by(|a, b| {
                let apart = |place: &CellPlace| middle(*place).distance_squared(at);
                apart(a).total_cmp(&apart(b))
            })
    }
}

/// The middle of a cell on paper.
fn middle((column, row): CellPlace) -> DVec2 {
    dvec2(f64::from(column) + 0.5, 2.0 * f64::from(row) + 1.0)
}

/// A small disc drawn without colours: its token between two brackets.
fn outline(role: Role) -> String {
    match token(role, Charset::Unicode) {
        sign @ "(S)" => sign.to_owned(),
        sign => format!("({sign})"),
    }
}

#[cfg(test)]
mod tests {
    use ratatui::buffer::Buffer;
    use ratatui::layout::Rect;

    use super::*;
    use crate::widgets::Theme;
    use crate::widgets::picture::View;

    /// The opening pack: a queen with two rings of coins around it, all touching.
    fn pack() -> Vec<Body> {
        let body = |at: DVec2, role, letter| Body::new(at, 0.5, role, letter);
        let mut pack = Vec::new();
        for ring in 1..=2 {
            for side in 0..6 {
                for step in 0..ring {
                    let corner = DVec2::from_angle(f64::from(side) * 60_f64.to_radians());
                    let along = DVec2::from_angle(f64::from(side + 2) * 60_f64.to_radians());
                    let at = corner * f64::from(ring) + along * f64::from(step);
                    pack.push(body(at, Role::Coin, 'W'));
                }
            }
        }
        pack.push(body(DVec2::ZERO, Role::Queen, 'Q'));
        pack
    }

    fn count(buffer: &Buffer, sign: &str) -> usize {
        buffer
            .content
            .iter()
            .filter(|cell| cell.symbol() == sign)
            .count()
    }

    #[test]
    fn every_token_of_a_tight_pack_is_visible_below_other_marks() {
        let area = Rect::new(0, 0, 41, 21);
        for charset in [Charset::Ascii, Charset::Unicode] {
            // From half a column to two columns per disc.
            for scale in [0.5, 0.55, 0.61, 0.7, 0.83, 1.0, 1.3, 2.0] {
                let mut canvas = Canvas::new(View::new(area, dvec2(0.1, 0.2), scale), charset);
                canvas.discs(&pack());
                let queen = canvas.view().cell_at(DVec2::ZERO).unwrap();
                for turn in 0..12 {
                    let tip = DVec2::from_angle(f64::from(turn) * 0.53) * 2.0;
                    canvas.arrow(DVec2::ZERO, tip, Role::CoinOut);
                    canvas.circle(DVec2::ZERO, 0.2 * f64::from(turn), Role::Predicted);
                }
                let mut buffer = Buffer::empty(area);
                canvas.draw(&mut buffer, &Theme::default());
                assert_eq!(buffer[queen].symbol(), "Q", "{charset:?} {scale}");
                let coins = count(&buffer, token(Role::Coin, charset));
                assert_eq!(coins, 18, "{charset:?} {scale}");
            }
        }
    }

    #[test]
    fn without_colours_each_disc_of_a_tight_pack_has_its_own_outline() {
        let area = Rect::new(0, 0, 41, 21);
        let mut canvas = Canvas::new(View::new(area, DVec2::ZERO, 0.33), Charset::Unicode);
        canvas.is_mono = true;
        canvas.discs(&pack());
        let mut buffer = Buffer::empty(area);
        canvas.draw(&mut buffer, &Theme::default());
        for (sign, times) in [("(", 19), (")", 19), ("○", 18), ("Q", 1)] {
            assert_eq!(count(&buffer, sign), times, "{sign}");
        }
    }

    #[test]
    fn discs_are_all_tokens_or_all_round() {
        let area = Rect::new(0, 0, 61, 31);
        for (scale, round) in [(0.33, true), (0.4, false)] {
            let mut canvas = Canvas::new(View::new(area, DVec2::ZERO, scale), Charset::Unicode);
            // On its own, the large disc would be round at both scales.
            let large = Body::new(dvec2(6.0, 0.0), 0.9, Role::Striker, 'S');
            let mut bodies = pack();
            bodies.push(large);
            canvas.discs(&bodies);
            let mut buffer = Buffer::empty(area);
            canvas.draw(&mut buffer, &Theme::default());
            let tokens = count(&buffer, token(Role::Coin, Charset::Unicode));
            assert_eq!(tokens, if round { 0 } else { 18 });
            assert_eq!(count(&buffer, "("), usize::from(!round));
        }
    }
}
