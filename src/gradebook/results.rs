//! The results of a class, computed once for all tables and pages: reading the figures of an answer
//! takes far longer than counting it.

use std::collections::{BTreeSet, HashSet};

use indexmap::IndexMap;

use super::{Gradebook, Pupil};
use crate::progress::{self, Attempt, HeldBelief, Tally, TopicStanding};

/// A class with the results of each pupil.
#[derive(Debug, Clone)]
pub struct ClassResults<'a> {
    /// Where they come from.
    pub book: &'a Gradebook,
    /// One for each pupil, in the order of the pupils.
    pub pupils: Vec<PupilResults<'a>>,
}

/// The results of one pupil.
#[derive(Debug, Clone)]
pub struct PupilResults<'a> {
    /// Whose they are.
    pub pupil: &'a Pupil,
    /// The answers that count, which are the first to each question of a round, with the round
    /// of each.
    pub answers: Vec<(&'a Attempt, String)>,
    /// These answers counted.
    pub tally: Tally,
    /// How each round went, in the order in which they were begun.
    pub rounds: IndexMap<String, Tally>,
    /// How each topic went, by its name.
    pub topics: IndexMap<String, TopicStanding>,
    /// The misconceptions that all answers together show.
    pub beliefs: Vec<HeldBelief>,
}

impl<'a> ClassResults<'a> {
    pub(super) fn of(book: &'a Gradebook) -> Self {
        Self {
            book,
            pupils: book.pupils.iter().map(PupilResults::of).collect(),
        }
    }

    /// The rounds that anybody has begun, in the order of their codes.
    pub(crate) fn rounds(&self) -> Vec<&str> {
        sorted(self.pupils.iter().flat_map(|it| it.rounds.keys()))
    }

    /// The topics that anybody was asked about, in the order of their names.
    pub(crate) fn topics(&self) -> Vec<&str> {
        sorted(self.pupils.iter().flat_map(|it| it.topics.keys()))
    }
}

impl<'a> PupilResults<'a> {
    fn of(pupil: &'a Pupil) -> Self {
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

/// Each of these names once.
fn sorted<'n>(names: impl Iterator<Item = &'n String>) -> Vec<&'n str> {
    let names: BTreeSet<&str> = names.map(String::as_str).collect();
    names.into_iter().collect()
}
