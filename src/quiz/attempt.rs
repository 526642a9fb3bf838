//! What is kept of an answer: the record that the quiz and the lessons share.

use super::Confidence;

/// One answer that was given somewhere, and how good it was.
#[derive(Debug, Clone, PartialEq)]
pub struct Attempt {
    /// What was asked.
    pub asked: AskedIn,
    /// How good the answer was, from 0 to 1.
    pub credit: f64,
    /// Whether it counts as right.
    pub right: bool,
    /// How sure the player was, where that was asked.
    pub confidence: Option<Confidence>,
    /// The name of the misconception it fits.
    pub misconception: Option<&'static str>,
}

/// Where a question was asked.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum AskedIn {
    /// In a round of the quiz.
    Round {
        /// The code of the round.
        seed: u64,
        /// The question's number in it, from 0.
        number: usize,
    },
    /// At a checkpoint of a chapter.
    Chapter {
        /// The id of the chapter.
        id: String,
        /// The page, from 0.
        page: usize,
    },
}
