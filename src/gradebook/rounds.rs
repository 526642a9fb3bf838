//! Answers by the round in which they were given.

use std::collections::HashMap;

use serde::Deserialize;

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

/// What of the figures of a question tells its round.
#[derive(Deserialize, Default)]
struct Figures {
    #[serde(default)]
    round: Option<String>,
}

/// The round in which an answer was given: its code; of a chapter its title.
pub fn round_of(attempt: &Attempt) -> String {
    if attempt.family == LESSON {
        return format!("chapter: {}", attempt.topic);
    }
    let figures: Figures = serde_json::from_str(&attempt.question).unwrap_or_default();
    // Before codes were noted with the figures the seed was all there was.
    (figures.round).unwrap_or_else(|| attempt.seed.to_string())
}

/// Points for an answer, by how near it was.
pub(super) fn points(attempt: &Attempt) -> f64 {
    Grade::MOST * attempt.credit
}

/// These answers by their rounds, in the order in which those were begun.
pub(super) fn tallies(answers: &[(&Attempt, String)]) -> Vec<RoundTally> {
    let mut tallies: Vec<RoundTally> = Vec::new();
    let mut places: HashMap<&str, usize> = HashMap::new();
    for (attempt, round) in answers {
        let place = *places.entry(round).or_insert(tallies.len());
        if place == tallies.len() {
            tallies.push(RoundTally {
                round: round.clone(),
                answered: 0,
                right: 0,
                points: 0.0,
            });
        }
        if let Some(tally) = tallies.get_mut(place) {
            tally.answered += 1;
            tally.right += usize::from(attempt.right);
            tally.points += points(attempt);
        }
    }
    tallies
}
