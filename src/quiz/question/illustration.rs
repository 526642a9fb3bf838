//! The picture beside a question.

use super::Hit;
use crate::physics::Collision;
use crate::physics::ImpactPoint;
use crate::physics::rutherford::Rutherford;

/// The picture beside a question.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Illustration {
    /// No picture.
    Nothing,
    /// A collision about to happen. It is played once the answer is given.
    Before {
        /// The hit.
        collision: Collision,
        /// The geometry that is marked.
        shown: Markings,
    },
    /// A collision that has happened: the final paths, with their angles. It can be watched once
    /// the answer is given.
    After {
        /// The hit.
        collision: Collision,
    },
    /// Two particles that pass a nucleus, deflected by these angles in radians.
    Tracks {
        /// The nucleus and the particles.
        rutherford: Rutherford,
        /// Both angles.
        angles: [f64; 2],
    },
}

/// The geometry that a picture marks, besides the discs and their paths before the collision.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Markings {
    /// The impact parameter, between the two centre lines.
    pub offset: bool,
    /// The line of impact where the two discs will meet, and α.
    pub angle: bool,
    /// Numbers: speeds, and the values of the marked geometry. Without them the picture alone gives
    /// the information.
    pub figures: bool,
}

impl Markings {
    /// Everything.
    pub(crate) const ALL: Self = Self {
        offset: true,
        angle: true,
        figures: true,
    };

    /// All numbers, and no marks where the discs will meet.
    pub(crate) const FIGURES: Self = Self {
        offset: false,
        angle: false,
        figures: true,
    };

    /// The quantity that defines a hit, with all numbers.
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
    /// A hit about to happen.
    pub(in crate::quiz) const fn before(collision: Collision, shown: Markings) -> Self {
        Self::Before { collision, shown }
    }

    /// The hit that can be watched once the answer is given.
    pub const fn collision(&self) -> Option<&Collision> {
        match self {
            Self::Before { collision, .. } | Self::After { collision } => Some(collision),
            Self::Nothing | Self::Tracks { .. } => None,
        }
    }
}
