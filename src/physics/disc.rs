//! A disc and its motion.

use glam::DVec2;

/// A rigid disc, without its position and velocity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disc {
    /// Mass in kilograms, finite and positive.
    pub mass: f64,
    /// Radius in metres, finite and positive.
    pub radius: f64,
}

impl Disc {
    /// A disc from the units of the screen and of files: grams and millimetres.
    pub const fn from_g_mm(mass_g: f64, radius_mm: f64) -> Self {
        Self {
            mass: mass_g / 1000.0,
            radius: radius_mm / 1000.0,
        }
    }
}

/// The position of a disc's centre and its velocity.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Motion {
    /// Centre in metres, from the centre of the board, x to the right, y up.
    pub position: DVec2,
    /// Velocity in m/s.
    pub velocity: DVec2,
}

impl Motion {
    /// A disc at `position` metres that moves with `velocity` m/s.
    pub const fn new(position: DVec2, velocity: DVec2) -> Self {
        Self { position, velocity }
    }

    pub(crate) const fn at_rest(position: DVec2) -> Self {
        Self::new(position, DVec2::ZERO)
    }
}
