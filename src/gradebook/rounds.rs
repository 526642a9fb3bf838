//! Answers by the round in which they were given.

use serde_json::Value;

use crate::progress::{Attempt, LESSON};
use crate::quiz::Grade;

/// How a pupil did in a round.
#[derive(Debug, Clone, PartialEq)]
pub struct RoundTally {
    /// Its code, or the chapter that asked.
    pub round: String,
    /// How many questions were answered.
    pub answered: usize,
    /// How many of the answers were right.
    pub right: usize,
    /// 0 to [`Grade::MOST`] for each answer, by how near it was.
    pub points: f64,
}

/// The round in which an answer was given: its code; of a chapter its title.
pub fn round_of(attempt: &Attempt) -> String {
    if attempt.family == LESSON {
        return format!("chapter: {}", attempt.topic);
    }
    let figures: Option<Value> = serde_json::from_str(&attempt.question).ok();
    let code = figures.and_then(|it| Some(it.get("round")?.as_str()?.to_owned()));
    // Before codes were noted with the figures the seed was all there was.
    code.unwrap_or_else(|| attempt.seed.to_string())
}

/// Points for an answer, by how near it was.
pub(super) fn points(attempt: &Attempt) -> f64 {
    Grade::MOST * attempt.credit
}

/// These answers by their rounds, in the order in which those were begun.
pub(super) fn tallies(attempts: &[&Attempt]) -> Vec<RoundTally> {
    let mut tallies: Vec<RoundTally> = Vec::new();
    for attempt in attempts {
        let round = round_of(attempt);
        let at = tallies.iter().position(|it| it.round == round);
        let at = at.unwrap_or_else(|| {
            tallies.push(RoundTally {
                round,
                answered: 0,
                right: 0,
                points: 0.0,
            });
            tallies.len() - 1
        });
        tallies[at].answered += 1;
        tallies[at].right += usize::from(attempt.right);
        tallies[at].points += points(attempt);
    }
    tallies
}
