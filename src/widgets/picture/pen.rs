//! Pens, which determine the appearance of a stroke.

use crate::widgets::Role;

/// The order of layers, which does not depend on the order of drawing. If two strokes share a cell,
/// the cell has the style of the stroke on the higher layer or, on the same layer, of the later
/// stroke, unless that stroke barely touches the cell. In ASCII the cell shows only one stroke.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum DrawLayer {
    /// Boards, axes, frames.
    Ground,
    /// Trails and aim lines, which discs cover.
    Trail,
    /// Discs, which hide what is below them.
    Disc,
    /// Geometry: line of impact, tangent, arcs, right-angle marks.
    Construction,
    /// The player's prediction.
    Prediction,
    /// Velocities.
    Vector,
    /// Measured points, which hide the lines in their cells.
    Point,
    /// Marks that must never be hidden.
    Mark,
}

/// The line style of a stroke.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Dash {
    /// An unbroken line.
    #[default]
    Solid,
    /// A dashed line.
    Dashed,
    /// A dotted line.
    Dotted,
}

/// The role, width, line style, age and layer of a stroke. A [`Role`] alone stands for a thin,
/// unbroken pen on the role's own layer.
///
/// ```
/// use carrom::widgets::{Role, picture::Pen};
/// let said = Pen::new(Role::Predicted).dashed();
/// let oldest = Pen::new(Role::Trail).dotted().aged(0.9);
/// # assert_ne!(said, oldest);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pen {
    pub(in crate::widgets) role: Role,
    pub(in crate::widgets) layer: DrawLayer,
    pub(in crate::widgets) dash: Dash,
    pub(in crate::widgets) bold: bool,
    pub(in crate::widgets) age: f64,
}

impl Pen {
    /// A thin, unbroken pen on the role's own layer.
    pub const fn new(role: Role) -> Self {
        Self {
            role,
            layer: layer(role),
            dash: Dash::Solid,
            bold: false,
            age: 0.0,
        }
    }

    /// This pen with a dashed line.
    #[must_use]
    pub const fn dashed(mut self) -> Self {
        self.dash = Dash::Dashed;
        self
    }

    /// This pen with a dotted line.
    #[must_use]
    pub const fn dotted(mut self) -> Self {
        self.dash = Dash::Dotted;
        self
    }

    /// This pen at about twice the width.
    #[must_use]
    pub const fn bold(self) -> Self {
        Self { bold: true, ..self }
    }

    /// This pen on another layer.
    #[must_use]
    pub const fn on(self, layer: DrawLayer) -> Self {
        Self { layer, ..self }
    }

    /// This pen faded by age: 0 is fresh, 1 is faint.
    #[must_use]
    pub const fn aged(self, age: f64) -> Self {
        Self { age, ..self }
    }
}

impl From<Role> for Pen {
    fn from(role: Role) -> Self {
        Self::new(role)
    }
}

/// The default layer of a role.
const fn layer(role: Role) -> DrawLayer {
    match role {
        Role::Background
        | Role::Text
        | Role::Dim
        | Role::Border
        | Role::BoardLine
        | Role::Pocket
        | Role::Surface
        | Role::Rail
        | Role::Hole
        | Role::BaseCircle
        | Role::Axis => DrawLayer::Ground,
        Role::Trail | Role::Aim => DrawLayer::Trail,
        Role::Striker | Role::Coin | Role::Black | Role::Queen | Role::Marble => DrawLayer::Disc,
        Role::LineOfImpact | Role::TangentLine | Role::Arc | Role::SquareCorner => {
            DrawLayer::Construction
        }
        Role::Predicted => DrawLayer::Prediction,
        Role::Incoming
        | Role::NormalPart
        | Role::TangentPart
        | Role::StrikerOut
        | Role::CoinOut => DrawLayer::Vector,
        Role::Title | Role::Key | Role::Selected | Role::Good | Role::Warn | Role::Contact => {
            DrawLayer::Mark
        }
    }
}
