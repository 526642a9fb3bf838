//! The labels of a picture.

use glam::DVec2;

use crate::widgets::Role;

/// A text beside a point of the world.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    /// What is written.
    pub text: String,
    /// A shorter text, if there is no room near by for the whole label.
    pub short: Option<String>,
    /// What it is.
    pub role: Role,
    /// The points it may be beside, the preferred first, each with its preferred sides; there is
    /// always one.
    pub places: Vec<(DVec2, Vec<LabelSide>)>,
    /// Whether it and others leave each other the surroundings of their points.
    pub(in crate::widgets) keeps_others_off: bool,
}

impl Label {
    /// The same for a label that stands apart and cannot be mistaken for another name: it is placed
    /// first, and may be close to the points of others.
    pub fn apart(&mut self) -> &mut Self {
        self.keeps_others_off = false;
        self
    }

    /// Fewer letters, where there is no room near by for all of them.
    pub fn short(&mut self, text: impl Into<String>) -> &mut Self {
        self.short = Some(text.into());
        self
    }

    /// Another place, where there is no room at those before.
    pub fn or(&mut self, anchor: DVec2, sides: &[LabelSide]) -> &mut Self {
        self.places.push((anchor, sides.to_vec()));
        self
    }
}

/// On which side of its anchor a label stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LabelSide {
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

use LabelSide as S;

impl LabelSide {
    /// All sides but [`LabelSide::Over`], anticlockwise from the right.
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

    /// The sense in which a label to one side moves away from its anchor: in columns, to
    /// the right, and in rows, up.
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

    /// The cell in which a label `width` wide begins that stands `away` cells from
    /// its anchor: columns count double, as they are half as wide.
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
