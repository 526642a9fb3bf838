//! The picture beside a question.

use super::Hit;
use crate::physics::rutherford::Rutherford;
use crate::physics::{Collision, ImpactPoint};

/// The picture beside a question.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Illustration {
    /// No picture.
    Nothing,
    /// A collision that is about to happen. The collision is played after the question has been
    /// answered.
    Before {
        /// The collision that is shown.
        collision: Collision,
        /// The geometry that is marked.
        shown: Markings,
    },
    /// A collision that has happened: the final paths, with their angles. The collision can be
    /// watched after the question has been answered.
    After {
        /// The collision that is shown.
        collision: Collision,
    },
    /// Two particles that pass a nucleus and are deflected by these angles, in radians.
    Tracks {
        /// The nucleus and the particles.
        rutherford: Rutherford,
        /// The angles of the two particles, in radians.
        angles: [f64; 2],
    },
}

/// The geometry that a picture marks, in addition to the discs and their paths before the
/// collision.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Markings {
    /// The impact parameter, drawn between two parallel lines.
    pub offset: bool,
    /// The line of impact at the point where the two discs will meet, and α.
    pub angle: bool,
    /// Numbers: speeds, and the values of the marked geometry. Without numbers the picture itself
    /// has to give all the information.
    pub figures: bool,
}

impl Markings {
    /// Everything.
    pub(crate) const ALL: Self = Self {
        offset: true,
        angle: true,
        figures: true,
    };

    /// Numbers, but neither the impact parameter nor the impact angle.
    pub(crate) const FIGURES: Self = Self {
        offset: false,
        angle: false,
        figures: true,
    };

    /// The quantity that defines a hit is marked, and all numbers are shown.
    pub(crate) const fn given(hit: &Hit) -> Self {
        let angle = matches!(hit.given, ImpactPoint::Angle { .. });
        Self {
            offset: !angle,
            angle,
            ..Self::FIGURES
        }
    }
}

impl Illustration {
    /// The picture of a hit that is about to happen.
    pub(in crate::quiz) const fn before(collision: Collision, shown: Markings) -> Self {
        Self::Before { collision, shown }
    }

    /// The hit that can be watched after the question has been answered.
    pub const fn collision(&self) -> Option<&Collision> {
        match self {
            Self::Before { collision, .. } | Self::After { collision } => Some(collision),
            Self::Nothing | Self::Tracks { .. } => None,
        }
    }
}
