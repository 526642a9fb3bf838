//! The steps in which a class goes through a question.

/// A step of a question, in their order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub enum ClassStep {
    /// The question is read out.
    #[default]
    Describe,
    /// Everyone predicts in silence.
    Predict,
    /// The teams give their first vote.
    FirstVote,
    /// The teams see how the votes are spread, and talk.
    Talk,
    /// The teams may change their vote.
    SecondVote,
    /// What really happens, and why.
    Shot,
    /// The scoreboard.
    Scores,
}

impl ClassStep {
    /// All of them, in order.
    pub const ALL: [Self; 7] = [
        Self::Describe,
        Self::Predict,
        Self::FirstVote,
        Self::Talk,
        Self::SecondVote,
        Self::Shot,
        Self::Scores,
    ];

    /// Its name in files.
    pub const fn id(self) -> &'static str {
        match self {
            Self::Describe => "describe",
            Self::Predict => "predict",
            Self::FirstVote => "first-vote",
            Self::Talk => "talk",
            Self::SecondVote => "second-vote",
            Self::Shot => "shot",
            Self::Scores => "scores",
        }
    }

    /// The step of an `id`.
    pub fn with_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|step| step.id() == id)
    }

    /// The step after it; `None` after the last.
    pub fn next(self) -> Option<Self> {
        Self::ALL.into_iter().find(|step| *step > self)
    }

    /// The step before it; `None` before the first.
    pub fn before(self) -> Option<Self> {
        Self::ALL.into_iter().rev().find(|step| *step < self)
    }
}

/// Where in a round a class is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ClassPlace {
    /// The question, counted from 0.
    pub question: usize,
    /// The step of that question.
    pub step: ClassStep,
}
