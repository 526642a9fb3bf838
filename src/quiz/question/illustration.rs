//! What is seen beside a question.

use super::Hit;
use crate::physics::Collision;
use crate::physics::ImpactPoint;
use crate::physics::rutherford::Rutherford;

/// What is seen beside a question.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Illustration {
    /// Nothing: words alone.
    Nothing,
    /// A hit about to happen. Once the answer is given, it does.
    Before {
        /// The hit.
        collision: Collision,
        /// What of it is drawn in.
        shown: Markings,
    },
    /// A hit that has happened: the ways out, with their angles. Once the answer is
    /// given, it can be watched.
    After {
        /// The hit.
        collision: Collision,
    },
    /// Two particles thrown at a nucleus, turned by these angles in radians.
    Tracks {
        /// The nucleus and the particles.
        rutherford: Rutherford,
        /// Both angles.
        angles: [f64; 2],
    },
}

/// What of a hit's geometry is drawn in, besides the discs and the ways in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Markings {
    /// The impact parameter, between the two centre lines.
    pub offset: bool,
    /// The line of impact where the two will meet, and α.
    pub angle: bool,
    /// Figures: speeds, and those of what is drawn in. Without them the picture is all
    /// there is to go by.
    pub figures: bool,
}

impl Markings {
    /// Everything.
    pub(crate) const ALL: Self = Self {
        offset: true,
        angle: true,
        figures: true,
    };

    /// All figures, and nothing of where the two will meet.
    pub(crate) const FIGURES: Self = Self {
        offset: false,
        angle: false,
        figures: true,
    };

    /// What a hit is given by, with all figures.
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
