//! The names of velocities in a frame.

use glam::DVec2;

use crate::physics::{Collision, Frame};

/// The names of the velocities of a collision, each for the striker and the target.
#[derive(Debug, Clone, Copy)]
pub(crate) struct VelocityNames {
    /// The names before the collision; in any frame other than the laboratory frame they include
    /// the subtracted velocity.
    pub before: [&'static str; 2],
    /// The names after the collision; in the centre-of-mass frame they are those of chapter 11.
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

/// The name of the component of a velocity along n or t: u₁ₙ, (u − V)ₙ. As in the chapters, the
/// components of u have the number of the striker, although u has none.
pub(super) fn part_name(name: &str, axis: char) -> String {
    match name {
        "u" => format!("u₁{axis}"),
        name if name.contains(' ') => format!("({name}){axis}"),
        name => format!("{name}{axis}"),
    }
}
