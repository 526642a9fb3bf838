//! Labels that find themselves a free place.

use glam::DVec2;
use ratatui::{buffer::Buffer, layout::Rect};
use unicode_width::UnicodeWidthStr;

use super::{pen::Layer, sheet::Sheet};
use crate::widgets::{Role, Theme};

/// On which side of its anchor a label stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// In the row of the anchor, to the right.
    Right,
    /// Above and to the right.
    AboveRight,
    /// Centred above.
    Above,
    /// Above and to the left.
    AboveLeft,
    /// In the row of the anchor, to the left.
    Left,
    /// Below and to the left.
    BelowLeft,
    /// Centred below.
    Below,
    /// Below and to the right.
    BelowRight,
    /// Centred on the anchor itself.
    Over,
}

use Side as S;

impl Side {
    /// All sides but [`Side::Over`], anticlockwise from the right.
    pub const ALL: [Self; 8] = [
        S::Right,
        S::AboveRight,
        S::Above,
        S::AboveLeft,
        S::Left,
        S::BelowLeft,
        S::Below,
        S::BelowRight,
    ];

    /// All sides, those nearest to a direction of the world first: for a label at
    /// the tip of an arrow, in the arrow's own direction.
    #[must_use]
    pub fn towards(direction: DVec2) -> [Self; 8] {
        let mut sides = Self::ALL;
        sides.sort_by(|a, b| {
            let along = |side: Self| side.direction().dot(direction);
            along(*b).total_cmp(&along(*a))
        });
        sides
    }

    /// The direction of the world a side lies in, a unit vector.
    fn direction(self) -> DVec2 {
        let eighths = Self::ALL.iter().position(|&side| side == self);
        DVec2::from_angle(eighths.unwrap_or(0) as f64 * std::f64::consts::FRAC_PI_4)
    }

    /// The sense in which a label to one side moves away from its anchor, in columns.
    fn outwards(self) -> i32 {
        match self {
            S::Right | S::AboveRight | S::BelowRight => 1,
            S::Above | S::Below | S::Over => 0,
            S::AboveLeft | S::Left | S::BelowLeft => -1,
        }
    }

    /// The cell in which a label `width` wide begins that stands `away` cells from
    /// its anchor: columns count double, as they are half as wide.
    fn start(self, (column, row): (i32, i32), width: i32, away: i32) -> (i32, i32) {
        let x = match self {
            S::Right => column + 2 * away,
            S::AboveRight | S::BelowRight => column + away,
            S::Above | S::Below | S::Over => column - width / 2,
            S::AboveLeft | S::BelowLeft => column - width + 1 - away,
            S::Left => column - width + 1 - 2 * away,
        };
        let y = match self {
            S::Right | S::Left | S::Over => row,
            S::Above | S::AboveLeft | S::AboveRight => row - away,
            S::Below | S::BelowLeft | S::BelowRight => row + away,
        };
        (x, y)
    }
}

/// A label that has its place.
#[derive(Debug, Clone)]
pub(super) struct Label {
    text: String,
    role: Role,
    /// One row of the screen.
    place: Rect,
    /// The cell of what it names, counted from the corner of the area.
    anchor: (i32, i32),
}

impl Label {
    #[cfg(test)]
    pub(super) fn place(&self) -> Rect {
        self.place
    }

    pub(super) fn draw(&self, buffer: &mut Buffer, theme: &Theme) {
        let inside = self.place.intersection(buffer.area);
        if inside != self.place {
            return;
        }
        let style = theme.base().patch(theme.style(self.role));
        for position in inside.positions() {
            buffer[position].reset();
        }
        buffer.set_string(inside.x, inside.y, &self.text, style);
    }
}

/// How many columns a label may move outwards for air around it.
const ASIDE: i32 = 2;
/// How far from its anchor a label may stand, in rows.
const FARTHEST: i32 = 4;

impl Sheet {
    /// Writes `text` (in the sheet's charset) beside a point of the world: on the
    /// first of `sides` that is free, near before far; then on the other sides.
    /// Call it when all is drawn.
    ///
    /// A label never leaves the area, whose first and last column stay free beside what
    /// is there (unless it is as wide), and never covers another label, a disc, a
    /// velocity, a reserved cell or an arrow's tip. Rather than stand far away it
    /// covers the weakest lines. Says whether it found a place.
    pub fn label(&mut self, text: &str, anchor: DVec2, sides: &[Side], role: Role) -> bool {
        // Free paper first, with a blank at both ends; then without the blanks, then
        // over boards and trails, then over geometry.
        let places = [
            (FARTHEST, true, true, None),
            (FARTHEST, true, false, None),
            (FARTHEST, false, false, Some(Layer::Trail)),
            (FARTHEST, false, false, Some(Layer::Construction)),
        ];
        self.label_at(text, anchor, sides, role, &places)
    }

    /// Writes `text` as [`Sheet::label`] does, but farther away: for what has found no
    /// place near by once all else has its own. It stays clear of what others name.
    pub fn label_far(&mut self, text: &str, anchor: DVec2, sides: &[Side], role: Role) -> bool {
        let places = [(2 * FARTHEST, true, false, None)];
        self.label_at(text, anchor, sides, role, &places)
    }

    /// Tells of a point that a label is still to be written for, so that labels written
    /// before it leave its surroundings to it.
    pub fn expect_label(&mut self, anchor: DVec2) {
        let cell = self.view().to_cell(anchor);
        if cell.is_finite() {
            self.expected.push(self.counted(cell));
        }
    }

    /// A cell counted from the corner of the area.
    fn counted(&self, cell: DVec2) -> (i32, i32) {
        let area = self.view().area();
        (
            cell.x.floor() as i32 - i32::from(area.x),
            cell.y.floor() as i32 - i32::from(area.y),
        )
    }

    /// Writes a label at the first free place: up to so many rows away, beside its own
    /// anchor or not, with blanks at both ends or not, over strokes up to a layer.
    fn label_at(
        &mut self,
        text: &str,
        anchor: DVec2,
        sides: &[Side],
        role: Role,
        places: &[(i32, bool, bool, Option<Layer>)],
    ) -> bool {
        let text = self.charset.text(text).into_owned();
        let cell = self.view().to_cell(anchor);
        let within_reach = cell.is_finite() && cell.abs().max_element() < f64::from(u16::MAX);
        if text.is_empty() || !within_reach {
            return false;
        }
        let area = self.view().area();
        let at = self.counted(cell);
        let width = i32::try_from(text.width()).unwrap_or(i32::MAX / 2);
        let spare = i32::from(area.width) - width;
        let margin = i32::from(spare >= 2);
        let last = spare - margin;
        let others = Side::ALL.iter().filter(|side| !sides.contains(side));
        let sides: Vec<Side> = sides.iter().chain(others).copied().collect();
        let place = places.iter().find_map(|&(farthest, own, blank, over)| {
            let all = (1..=farthest)
                .flat_map(|away| sides.iter().map(move |side| (*side, away)))
                .flat_map(|(side, away)| (0..=ASIDE).map(move |aside| (side, away, aside)));
            all.map(|(side, away, aside)| {
                let (x, y) = side.start(at, width, away);
                // Above or below it may move along to stay within the area.
                let x = x + aside * side.outwards();
                match side {
                    S::Right | S::Left => (x, y),
                    _ => (x.clamp(margin, last.max(margin)), y),
                }
            })
            .find(|&(x, y)| {
                (margin..=last).contains(&x)
                    && self.has_room((x, y), width, over)
                    && (!own || self.is_beside_own_anchor((x, y), width, at))
                    && (!blank || self.is_blank((x - 1, y)) && self.is_blank((x + width, y)))
            })
        });
        let Some((x, y)) = place else {
            return false;
        };
        let place = Rect::new(
            (i32::from(area.x) + x) as u16,
            (i32::from(area.y) + y) as u16,
            width as u16,
            1,
        );
        self.labels.push(Label {
            text,
            role,
            place,
            anchor: at,
        });
        true
    }

    /// Whether nothing is drawn or written beside a cell and in it, or it lies outside.
    fn is_blank(&self, (x, y): (i32, i32)) -> bool {
        let (columns, _) = self.size();
        let index = usize::try_from(y * columns + x).ok();
        let cell = index.and_then(|index| self.cells.get(index));
        !(0..columns).contains(&x)
            || cell.is_none_or(|cell| !cell.reserved && cell.cover == 0 && cell.layer().is_none())
                && self.is_clear_of_labels((x, y), 1)
    }

    /// Whether a label here is beside its own anchor rather than that of another label,
    /// so that nobody takes it for the name of that.
    fn is_beside_own_anchor(&self, (x, y): (i32, i32), width: i32, own: (i32, i32)) -> bool {
        // Squared, in columns; a row is two of them high.
        let apart = |(column, row): (i32, i32)| {
            let aside = (x - column).max(column - (x + width - 1)).max(0);
            aside * aside + 4 * (row - y) * (row - y)
        };
        let others = self.expected.iter().filter(|anchor| **anchor != own);
        let others = others.chain(self.labels.iter().map(|label| &label.anchor));
        let other = others.map(|anchor| apart(*anchor)).min();
        let own = apart(own);
        other.is_none_or(|other| own <= 3 * other)
    }

    /// Whether no label stands in a stretch of a row or right beside it.
    fn is_clear_of_labels(&self, (x, y): (i32, i32), width: i32) -> bool {
        let area = self.view().area();
        self.labels.iter().all(|label| {
            let left = i32::from(label.place.x) - i32::from(area.x);
            let row = i32::from(label.place.y) - i32::from(area.y);
            row != y || x > left + i32::from(label.place.width) || x + width < left
        })
    }

    /// Whether a label fits here, on paper or `over` strokes up to a layer.
    fn has_room(&self, (x, y): (i32, i32), width: i32, over: Option<Layer>) -> bool {
        let (columns, rows) = self.size();
        if y < 0 || y >= rows || x < 0 || x + width > columns {
            return false;
        }
        self.is_clear_of_labels((x, y), width)
            && (x..x + width).all(|column| {
                let index = usize::try_from(y * columns + column).ok();
                let cell = index.and_then(|index| self.cells.get(index));
                cell.is_some_and(|cell| !cell.reserved && cell.cover == 0 && cell.layer() <= over)
            })
    }
}
