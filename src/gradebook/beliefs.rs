//! The misconceptions of a class.

use super::{ClassResults, PupilResults};
use crate::progress::Attempt;
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
        let fits = |it: &&Attempt| it.shows() == Some(misconception);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gradebook::{Gradebook, HandIn};

    #[test]
    fn answers_with_the_former_id_of_a_misconception_are_counted() {
        let former = Attempt {
            misconception: Some("linear-offset".into()),
            ..Attempt::default()
        };
        let hand_in = HandIn {
            name: "Ada".into(),
            class: String::new(),
            attempts: vec![former],
        };
        let mut book = Gradebook::default();
        book.add("ada.json", Ok(hand_in));
        let expected = BeliefCount {
            misconception: Misconception::OffsetAsAngle,
            pupils: 0,
            answers: 1,
        };
        assert_eq!(beliefs(&book.results()), [expected]);
    }
}
