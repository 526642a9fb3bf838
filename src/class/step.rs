//! The steps in which a class goes through a question.

use serde::{Deserialize, Serialize};
use strum::{FromRepr, IntoStaticStr, VariantArray};

use super::ballot::Vote;

/// A step of a question; the variants are in order. In files, a step has a name such as
/// "first-vote".
#[derive(
    Debug,
    Clone,
    Copy,
    PartialEq,
    Eq,
    Default,
    FromRepr,
    IntoStaticStr,
    VariantArray,
    Serialize,
    Deserialize,
)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum ClassStep {
    /// The question is read out.
    #[default]
    Describe,
    /// Everyone predicts in silence.
    Predict,
    /// The teams give their first vote.
    FirstVote,
    /// The teams see the distribution of votes, and discuss.
    Talk,
    /// The teams may change their vote.
    SecondVote,
    /// The real outcome, and its explanation.
    Shot,
    /// The scoreboard.
    Scores,
}

impl ClassStep {
    /// The next step; `None` after the last.
    pub fn next(self) -> Option<Self> {
        Self::from_repr(self as usize + 1)
    }

    /// The vote that is open at this step.
    pub const fn vote(self) -> Option<Vote> {
        match self {
            Self::FirstVote => Some(Vote::First),
            Self::SecondVote => Some(Vote::Second),
            _ => None,
        }
    }

    /// The previous step; `None` before the first.
    pub fn before(self) -> Option<Self> {
        (self as usize).checked_sub(1).and_then(Self::from_repr)
    }
}

/// A position in a round.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ClassPlace {
    /// The question, counted from 0.
    pub question: usize,
    /// The step of that question.
    pub step: ClassStep,
}
