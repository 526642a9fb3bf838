//! The results of a class, computed once for all tables and pages, because reading the figures of
//! an answer takes far longer than counting it.

use std::collections::{BTreeSet, HashSet};

use indexmap::IndexMap;

use super::{Gradebook, Pupil};
use crate::progress::{self, Attempt, HeldBelief, Tally, TopicStanding};

/// The results of all pupils in a class.
#[derive(Debug, Clone)]
pub struct ClassResults<'a> {
    /// The gradebook that the results come from.
    pub book: &'a Gradebook,
    /// The results of each pupil, in the order of the gradebook.
    pub pupils: Vec<PupilResults<'a>>,
}

/// The results of one pupil.
#[derive(Debug, Clone)]
pub struct PupilResults<'a> {
    /// The pupil.
    pub pupil: &'a Pupil,
    /// The answers that are counted: the first one to each question of a round, with the name of
    /// the round.
    pub answers: Vec<(&'a Attempt, String)>,
    /// The counts of these answers.
    pub tally: Tally,
    /// The results of each round, in the order in which the rounds were begun.
    pub rounds: IndexMap<String, Tally>,
    /// The results of each topic, by its name.
    pub topics: IndexMap<String, TopicStanding>,
    /// The misconceptions that the pupil's answers show.
    pub beliefs: Vec<HeldBelief>,
}

impl ClassResults<'_> {
    /// The rounds that any pupil has begun, sorted by code.
    pub(crate) fn rounds(&self) -> Vec<&str> {
        sorted(self.pupils.iter().flat_map(|it| it.rounds.keys()))
    }

    /// The topics that any pupil was asked about, sorted by name.
    pub(crate) fn topics(&self) -> Vec<&str> {
        sorted(self.pupils.iter().flat_map(|it| it.topics.keys()))
    }
}

impl<'a> PupilResults<'a> {
    pub(super) fn of(pupil: &'a Pupil) -> Self {
        let mut asked = HashSet::new();
        let all = pupil.attempts.iter().map(|it| (it, it.round()));
        let answers: Vec<_> = all
            .filter(|(it, round)| asked.insert((round.clone(), it.number, &it.question)))
            .collect();
        let mut rounds: IndexMap<String, Tally> = IndexMap::new();
        for (attempt, round) in &answers {
            rounds.entry(round.clone()).or_default().add(attempt);
        }
        let counted = || answers.iter().map(|(it, _)| *it);
        let mut topics = IndexMap::new();
        for topic in progress::topics(counted()) {
            topics.entry(topic.name.clone()).or_insert(topic);
        }
        Self {
            pupil,
            tally: Tally::of(counted()),
            beliefs: progress::beliefs(&pupil.attempts),
            rounds,
            topics,
            answers,
        }
    }
}

/// These names without duplicates, sorted.
fn sorted<'n>(names: impl Iterator<Item = &'n String>) -> Vec<&'n str> {
    let names: BTreeSet<&str> = names.map(String::as_str).collect();
    names.into_iter().collect()
}
