//! Labels that are placed automatically.

use glam::DVec2;
use ratatui::{buffer::Buffer, layout::Rect};
use unicode_width::UnicodeWidthStr;

use super::canvas::Canvas;
use crate::widgets::picture::{DrawLayer, Label, LabelSide};
use crate::widgets::{Role, Theme};

/// A label that has been placed.
#[derive(Debug, Clone)]
pub(in crate::widgets) struct PlacedLabel {
    pub(in crate::widgets) text: String,
    pub(in crate::widgets) role: Role,
    /// The cells of the label, in one row of the screen.
    pub(in crate::widgets) place: Rect,
    /// The side of the anchor on which the label is placed.
    pub(in crate::widgets) side: LabelSide,
    /// The cell of the point that the label refers to, counted from the corner of the area.
    anchor: (i32, i32),
}

impl PlacedLabel {
    pub(super) fn draw(&self, buffer: &mut Buffer, theme: &Theme) {
        let inside = self.place.intersection(buffer.area);
        if inside != self.place {
            return;
        }
        for position in inside.positions() {
            let paper = buffer[position].bg;
            buffer[position].reset();
            buffer[position].bg = paper;
        }
        buffer.set_string(inside.x, inside.y, &self.text, theme.style(self.role));
    }
}

/// The number of columns by which a label may move outwards to leave space around it.
const ASIDE: i32 = 2;
/// The maximum distance of a label from its anchor, in rows; as a last resort, it is doubled.
const FARTHEST: i32 = 4;

/// What is allowed in the cells next to the two ends of a label.
#[derive(Debug, Clone, Copy)]
enum Ends {
    Blank,
    NoArrow,
    Any,
}

/// Whether a point, given in cells, could lie on any screen.
fn is_within_reach(cell: DVec2) -> bool {
    cell.is_finite() && cell.abs().max_element() < f64::from(u16::MAX)
}

impl Canvas {
    /// Writes labels after everything else has been drawn: first those that may be close to the
    /// anchors of later labels, then those that keep away from each other's anchors. A label is
    /// shortened if there is no room nearby; if it still does not fit, the full label is placed
    /// farther away, clear of other anchors.
    pub(super) fn write(&mut self, labels: &[Label]) {
        let (near, apart): (Vec<_>, Vec<_>) = labels.iter().partition(|it| it.keeps_others_off);
        let mut left = self.write_near(apart);
        let anchors = near.iter().map(|label| label.places[0].0);
        let cells = anchors.map(|anchor| self.view().to_cell(anchor));
        self.expected = cells
            .filter(|cell| is_within_reach(*cell))
            .map(|cell| self.counted(cell))
            .collect();
        left.extend(self.write_near(near));
        for label in left {
            let short = label.short.as_deref();
            if short.is_some_and(|short| self.write_at_places(short, label)) {
                continue;
            }
            let (anchor, sides) = &label.places[0];
            let places = [(2 * FARTHEST, true, Ends::Any, None)];
            self.label_at(&label.text, *anchor, sides, label.role, &places);
        }
    }

    /// Writes the labels that fit near their anchors, and returns the others.
    fn write_near<'a>(&mut self, labels: Vec<&'a Label>) -> Vec<&'a Label> {
        let is_left = |label: &&Label| !self.write_at_places(&label.text, label);
        labels.into_iter().filter(is_left).collect()
    }

    /// Writes `text` near one of the possible positions of a label, if there is room.
    fn write_at_places(&mut self, text: &str, label: &Label) -> bool {
        let mut places = label.places.iter();
        let clear = label.short.is_some();
        places.any(|(at, sides)| self.label(text, *at, sides, label.role, clear))
    }

    /// Writes `text` (in the canvas's charset) beside a point in the world: at near positions
    /// before distant ones, and at each distance on one of `sides` before the other sides. If
    /// `clear` is set, not even the ends of the label touch an arrow.
    ///
    /// A label never extends beyond the area, and unless it is too wide, it keeps the first and the
    /// last column free. It never covers another label, a disc, a velocity, a reserved cell or an
    /// arrow's tip, but it may cover faint lines to stay near its anchor. Returns whether it was
    /// placed.
    pub(super) fn label(
        &mut self,
        text: &str,
        anchor: DVec2,
        sides: &[LabelSide],
        role: Role,
        clear: bool,
    ) -> bool {
        // Empty cells with a blank at both ends are tried first, then empty cells without the
        // blanks, then cells with boards and trails, then cells with geometry.
        let ends = if clear { Ends::NoArrow } else { Ends::Any };
        let places = [
            (FARTHEST, true, Ends::Blank, None),
            (FARTHEST, true, ends, None),
            (FARTHEST, false, ends, Some(DrawLayer::Trail)),
            (FARTHEST, false, ends, Some(DrawLayer::Construction)),
        ];
        self.label_at(text, anchor, sides, role, &places)
    }

    /// Converts a cell to one counted from the corner of the area.
    fn counted(&self, cell: DVec2) -> (i32, i32) {
        let area = self.view().area();
        let (column, row) = (cell.x.floor() as i32, cell.y.floor() as i32);
        (column - i32::from(area.x), row - i32::from(area.y))
    }

    /// Writes a label at the first of `places` that is free. Each place specifies the number of
    /// rows to search, whether the label must be beside its own anchor rather than another label's,
    /// what is required at both ends, and the highest layer whose strokes the label may cover.
    fn label_at(
        &mut self,
        text: &str,
        anchor: DVec2,
        sides: &[LabelSide],
        role: Role,
        places: &[(i32, bool, Ends, Option<DrawLayer>)],
    ) -> bool {
        let text = self.charset.text(text).into_owned();
        let cell = self.view().to_cell(anchor);
        if text.is_empty() || !is_within_reach(cell) {
            return false;
        }
        let area = self.view().area();
        let at = self.counted(cell);
        let width = i32::try_from(text.width()).unwrap_or(i32::MAX / 2);
        let spare = i32::from(area.width) - width;
        let margin = i32::from(spare >= 2);
        let last = spare - margin;
        let others = LabelSide::ALL.iter().filter(|side| !sides.contains(side));
        let sides: Vec<LabelSide> = sides.iter().chain(others).copied().collect();
        let place = places.iter().find_map(|&(farthest, own, ends, over)| {
            let all = (1..=farthest)
                .flat_map(|away| sides.iter().map(move |side| (*side, away)))
                .flat_map(|(side, away)| (0..=ASIDE).map(move |aside| (side, away, aside)));
            all.map(|(side, away, aside)| {
                let (x, y) = side.start(at, width, away);
                // Above or below its anchor, a label may shift to stay within the area.
                let x = x + aside * side.outwards().0;
                match side {
                    LabelSide::Right | LabelSide::Left => (side, x, y),
                    _ => (side, x.clamp(margin, last.max(margin)), y),
                }
            })
            .find(|&(_, x, y)| {
                (margin..=last).contains(&x)
                    && self.has_room((x, y), width, over)
                    && (!own || self.is_beside_own_anchor((x, y), width, at))
                    && [x - 1, x + width]
                        .iter()
                        .all(|&x| self.may_end((x, y), ends))
            })
        });
        let Some((side, x, y)) = place else {
            return false;
        };
        let (left, top) = (i32::from(area.x) + x, i32::from(area.y) + y);
        let place = Rect::new(left as u16, top as u16, width as u16, 1);
        self.labels.push(PlacedLabel {
            text,
            role,
            place,
            side,
            anchor: at,
        });
        true
    }

    /// Whether a label may end next to this cell.
    fn may_end(&self, at: (i32, i32), ends: Ends) -> bool {
        match ends {
            Ends::Blank => self.is_blank(at),
            Ends::NoArrow => {
                let layer = self.cell(at).and_then(|cell| cell.layer());
                layer < Some(DrawLayer::Vector)
            }
            Ends::Any => true,
        }
    }

    /// Whether a cell is empty and no label is next to it, or the cell is outside the area.
    fn is_blank(&self, (x, y): (i32, i32)) -> bool {
        let (columns, _) = self.size();
        !(0..columns).contains(&x)
            || self.cell((x, y)).is_none_or(|cell| cell.is_free(None))
                && self.is_clear_of_labels((x, y), 1)
    }

    /// Whether a label at this position is not much farther from its own anchor than from any other,
    /// so that it does not seem to belong to another point.
    fn is_beside_own_anchor(&self, (x, y): (i32, i32), width: i32, own: (i32, i32)) -> bool {
        // The square of the distance in columns; a row is two columns high.
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

    /// Whether part of a row, including the cell beyond each end, is free of labels.
    fn is_clear_of_labels(&self, (x, y): (i32, i32), width: i32) -> bool {
        let area = self.view().area();
        self.labels.iter().all(|label| {
            let left = i32::from(label.place.x) - i32::from(area.x);
            let row = i32::from(label.place.y) - i32::from(area.y);
            row != y || x > left + i32::from(label.place.width) || x + width < left
        })
    }

    /// Whether a label fits at this position, on empty cells or over strokes up to the layer
    /// `over`.
    fn has_room(&self, (x, y): (i32, i32), width: i32, over: Option<DrawLayer>) -> bool {
        let is_free = |x| self.cell((x, y)).is_some_and(|cell| cell.is_free(over));
        self.is_clear_of_labels((x, y), width) && (x..x + width).all(is_free)
    }
}
