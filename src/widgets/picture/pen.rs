//! What a stroke is drawn with.

use crate::widgets::Role;

/// The order of layers, whatever the order of drawing. Where two strokes share a cell, the cell
/// looks like the one on the higher layer; on the same layer, like the later one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum DrawLayer {
    /// Boards, axes, frames.
    Ground,
    /// Trails and aim lines, which discs run over.
    Trail,
    /// Discs, which hide what is below them.
    Disc,
    /// Geometry: line of impact, tangent, arcs, square corners.
    Construction,
    /// The player's prediction.
    Prediction,
    /// Velocities.
    Vector,
    /// What must never be hidden.
    Mark,
}

/// How a stroke is broken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Dash {
    /// Not at all.
    #[default]
    Solid,
    /// Into dashes.
    Dashed,
    /// Into dots.
    Dotted,
}

/// What a stroke is drawn with. A bare [`Role`] is a thin, unbroken pen on the
/// role's own layer.
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
    #[must_use]
    pub const fn new(role: Role) -> Self {
        Self {
            role,
            layer: layer(role),
            dash: Dash::Solid,
            bold: false,
            age: 0.0,
        }
    }

    /// The same pen, drawing dashes.
    #[must_use]
    pub const fn dashed(mut self) -> Self {
        self.dash = Dash::Dashed;
        self
    }

    /// The same pen, drawing dots.
    #[must_use]
    pub const fn dotted(mut self) -> Self {
        self.dash = Dash::Dotted;
        self
    }

    /// The same pen, twice as broad.
    #[must_use]
    pub const fn bold(self) -> Self {
        Self { bold: true, ..self }
    }

    /// The same pen on another layer.
    #[must_use]
    pub const fn on(self, layer: DrawLayer) -> Self {
        Self { layer, ..self }
    }

    /// The same pen, faded: 0 is fresh, 1 nearly gone.
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

/// The layer a role is on unless the caller says otherwise.
const fn layer(role: Role) -> DrawLayer {
    match role {
        Role::Background
        | Role::Text
        | Role::Dim
        | Role::Border
        | Role::BoardLine
        | Role::Pocket
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
