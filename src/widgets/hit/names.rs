//! The names of velocities in a frame.

use glam::DVec2;

use crate::physics::{Collision, Frame};

/// The names of a collision's velocities, of the striker and of the target.
#[derive(Debug, Clone, Copy)]
pub(crate) struct VelocityNames {
    /// Before the collision; in another frame the name includes the subtracted velocity.
    pub before: [&'static str; 2],
    /// After the collision; in the centre-of-mass frame the names are those of chapter 11.
    pub after: [&'static str; 2],
}

impl VelocityNames {
    /// The names for a collision in a frame.
    pub(crate) fn new(collision: &Collision, frame: Frame) -> Self {
        let stands = collision.u2 == DVec2::ZERO;
        let (before, after) = match (frame, stands) {
            (Frame::Laboratory, true) => (["u", "u₂"], ["v₁", "v₂"]),
            (Frame::Laboratory, false) => (["u₁", "u₂"], ["v₁", "v₂"]),
            (Frame::CentreOfMass, true) => (["u − V", "−V"], ["w₁", "w₂"]),
            (Frame::CentreOfMass, false) => (["u₁ − V", "u₂ − V"], ["w₁", "w₂"]),
            (Frame::Target, _) => (["u₁ − u₂", "u₂ − u₂"], ["v₁ − u₂", "v₂ − u₂"]),
        };
        Self { before, after }
    }
}

/// The name of the component of a velocity along n or t: uₙ, (u − V)ₙ.
pub(super) fn part_name(name: &str, axis: char) -> String {
    match name.contains(' ') {
        true => format!("({name}){axis}"),
        false => format!("{name}{axis}"),
    }
}
