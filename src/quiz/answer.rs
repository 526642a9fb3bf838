//! What the player says.

use super::{Confidence, Rays};

/// What is said to a question, in the way it asks for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Said {
    /// Where the two will go.
    Rays(Rays),
    /// A number, in the unit of its [`Quantity`](super::Quantity).
    Number(f64),
    /// One of the choices, counted from 0.
    Choice(usize),
    /// A shot with this offset, in metres; positive puts the target to the right.
    Shot(f64),
}

/// An answer: what is said, and how sure the player is of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Answer {
    /// What is said.
    pub said: Said,
    /// How sure the player is.
    pub confidence: Confidence,
}

impl Answer {
    /// An answer.
    pub const fn new(said: Said, confidence: Confidence) -> Self {
        Self { said, confidence }
    }
}
