//! The misconceptions of a class.

use super::{ClassResults, PupilResults};
use crate::progress;
use crate::quiz::Misconception;

/// A misconception that a class has shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BeliefCount {
    /// The misconception.
    pub misconception: Misconception,
    /// How many pupils hold the misconception, on the evidence of all their answers.
    pub pupils: usize,
    /// How many answers fit the misconception.
    pub answers: usize,
}

/// The misconceptions that fit at least one answer, the most widely held first.
pub fn beliefs(results: &ClassResults<'_>) -> Vec<BeliefCount> {
    let pupils = &results.pupils;
    let of = |misconception: Misconception| {
        let holds = |it: &&PupilResults<'_>| {
            { it.beliefs.iter() }.any(|held| held.misconception == misconception)
        };
        let fits =
            |it: &&progress::Attempt| it.misconception.as_deref() == Some(misconception.id());
        BeliefCount {
            misconception,
            pupils: pupils.iter().filter(holds).count(),
            answers: { pupils.iter() }
                .map(|it| it.pupil.attempts.iter().filter(fits).count())
                .sum(),
        }
    };
    let mut all: Vec<_> = Misconception::ALL.iter().map(|it| of(*it)).collect();
    all.retain(|it| it.answers > 0);
    all.sort_by_key(|it| std::cmp::Reverse((it.pupils, it.answers)));
    all
}
