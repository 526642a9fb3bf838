//! The labels of a picture.

use glam::DVec2;

use crate::widgets::Role;

/// Text beside a point in the world.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    /// The text of the label.
    pub text: String,
    /// A shorter version, used if there is no room nearby for the whole label.
    pub short: Option<String>,
    /// The role, which determines the colour of the label.
    pub role: Role,
    /// The points beside which the label may be placed, in order of preference, each with its
    /// preferred sides; there is always at least one point.
    pub places: Vec<(DVec2, Vec<LabelSide>)>,
    /// Whether this label keeps away from the points of other labels, even of labels that are
    /// placed later.
    pub(in crate::widgets) keeps_others_off: bool,
}

impl Label {
    /// Marks a label that cannot be mistaken for the name of another point: it is placed first, and
    /// may be close to the points of other labels.
    pub fn apart(&mut self) -> &mut Self {
        self.keeps_others_off = false;
        self
    }

    /// Sets a shorter version, used if there is no room nearby for the whole label.
    pub fn short(&mut self, text: impl Into<String>) -> &mut Self {
        self.short = Some(text.into());
        self
    }

    /// Adds another point, used if there is no room at the previous ones.
    pub fn or(&mut self, anchor: DVec2, sides: &[LabelSide]) -> &mut Self {
        self.places.push((anchor, sides.to_vec()));
        self
    }
}

/// The side of a label's anchor on which the label is placed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LabelSide {
    /// On the anchor's row, to its right.
    Right,
    /// Above the anchor, to its right.
    AboveRight,
    /// Centred above the anchor.
    Above,
    /// Above the anchor, to its left.
    AboveLeft,
    /// On the anchor's row, to its left.
    Left,
    /// Below the anchor, to its left.
    BelowLeft,
    /// Centred below the anchor.
    Below,
    /// Below the anchor, to its right.
    BelowRight,
    /// Centred on the anchor itself.
    Over,
}

use LabelSide as S;

impl LabelSide {
    /// All sides except [`LabelSide::Over`], anticlockwise from the right.
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

    /// All sides, sorted by how close they are to a direction in the world. For a label at the tip
    /// of an arrow, pass the arrow's direction.
    #[must_use]
    pub fn towards(direction: DVec2) -> [Self; 8] {
        let mut sides = Self::ALL;
        sides.sort_by(|a, b| {
            let along = |side: Self| side.direction().dot(direction);
            along(*b).total_cmp(&along(*a))
        });
        sides
    }

    /// The direction of a side in the world, as a unit vector.
    fn direction(self) -> DVec2 {
        let eighths = Self::ALL.iter().position(|&side| side == self);
        DVec2::from_angle(eighths.unwrap_or(0) as f64 * std::f64::consts::FRAC_PI_4)
    }

    /// The direction in which a label on this side moves away from its anchor, in columns to the
    /// right and rows up.
    pub(in crate::widgets) fn outwards(self) -> (i32, i32) {
        match self {
            S::Right => (1, 0),
            S::AboveRight => (1, 1),
            S::Above => (0, 1),
            S::AboveLeft => (-1, 1),
            S::Left => (-1, 0),
            S::BelowLeft => (-1, -1),
            S::Below => (0, -1),
            S::BelowRight => (1, -1),
            S::Over => (0, 0),
        }
    }

    /// The first cell of a label that has this `width` and is `away` rows from its anchor; a label
    /// on the anchor's row is twice as many columns away, because a cell is twice as high as it is
    /// wide.
    pub(in crate::widgets) fn start(
        self,
        (column, row): (i32, i32),
        width: i32,
        away: i32,
    ) -> (i32, i32) {
        let (aside, up) = self.outwards();
        let columns = if up == 0 { 2 * away } else { away };
        let x = match aside {
            1 => column + columns,
            0 => column - width / 2,
            _ => column - width + 1 - columns,
        };
        (x, row - up * away)
    }
}
