//! What the answers of a class come to, worked out once for all tables and pages: reading the
//! figures of an answer takes far longer than counting it.

use std::collections::{BTreeSet, HashMap, HashSet};

use super::rounds::{self, RoundTally};
use super::{Gradebook, Pupil, round_of};
use crate::progress::{self, Attempt, HeldBelief, Tally, TopicStanding};

/// A class with the results of each pupil.
#[derive(Debug, Clone)]
pub struct ClassResults<'a> {
    /// Where they come from.
    pub book: &'a Gradebook,
    /// One for each pupil, in the order of the pupils.
    pub pupils: Vec<PupilResults<'a>>,
}

/// What the answers of one pupil come to.
#[derive(Debug, Clone)]
pub struct PupilResults<'a> {
    /// Whose they are.
    pub pupil: &'a Pupil,
    /// The answers that count, which are the first to each question of a round, with the round
    /// of each.
    pub answers: Vec<(&'a Attempt, String)>,
    /// These answers counted.
    pub tally: Tally,
    /// The rounds that were begun, in their order.
    pub rounds: Vec<RoundTally>,
    /// How each topic went.
    pub topics: Vec<TopicStanding>,
    /// The misconceptions that all answers together show.
    pub beliefs: Vec<HeldBelief>,
    /// Where each round and each topic stands in its list, by its name.
    round_places: HashMap<String, usize>,
    topic_places: HashMap<String, usize>,
}

impl<'a> ClassResults<'a> {
    pub(super) fn of(book: &'a Gradebook) -> Self {
        Self {
            book,
            pupils: book.pupils.iter().map(PupilResults::of).collect(),
        }
    }

    /// The rounds that anybody has begun, in the order of their codes.
    pub fn rounds(&self) -> Vec<&str> {
        let all = self.pupils.iter().flat_map(|it| &it.rounds);
        let names: BTreeSet<&str> = all.map(|it| it.round.as_str()).collect();
        names.into_iter().collect()
    }

    /// The topics that anybody was asked about, in the order of their names.
    pub fn topics(&self) -> Vec<&str> {
        let all = self.pupils.iter().flat_map(|it| &it.topics);
        let names: BTreeSet<&str> = all.map(|it| it.name.as_str()).collect();
        names.into_iter().collect()
    }
}

impl<'a> PupilResults<'a> {
    fn of(pupil: &'a Pupil) -> Self {
        let mut asked = HashSet::new();
        let all = pupil.attempts.iter().map(|it| (it, round_of(it)));
        let answers: Vec<_> = all
            .filter(|(it, round)| asked.insert((round.clone(), it.number, it.question.as_str())))
            .collect();
        let counted = || answers.iter().map(|(it, _)| *it);
        let rounds = rounds::tallies(&answers);
        let topics = progress::topics(counted());
        Self {
            pupil,
            tally: Tally::of(counted()),
            beliefs: progress::beliefs(&pupil.attempts),
            round_places: places(rounds.iter().map(|it| &it.round)),
            topic_places: places(topics.iter().map(|it| &it.name)),
            rounds,
            topics,
            answers,
        }
    }

    /// How a round went, if it was begun.
    pub fn round(&self, name: &str) -> Option<&RoundTally> {
        self.rounds.get(*self.round_places.get(name)?)
    }

    /// How a topic went, if it was met.
    pub fn topic(&self, name: &str) -> Option<&TopicStanding> {
        self.topics.get(*self.topic_places.get(name)?)
    }
}

/// The first place of each name.
fn places<'n>(names: impl Iterator<Item = &'n String>) -> HashMap<String, usize> {
    let mut places = HashMap::new();
    for (place, name) in names.enumerate() {
        places.entry(name.clone()).or_insert(place);
    }
    places
}
