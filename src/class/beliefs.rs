//! The misconceptions of a class.

use std::cmp::Reverse;

use super::ballot::Vote;
use super::round::ClassRound;
use super::way::WayOfVoting;
use crate::quiz::{ChaptersRead, Evidence, Misconception, Passage};

/// A misconception in a class: the number of teams whose votes show it (with counted hands, the
/// number of questions), before and after the discussion, and the number of votes that fit it.
#[derive(Debug, Clone)]
pub(crate) struct ClassBelief {
    pub(crate) misconception: Misconception,
    pub(crate) teams: [usize; 2],
    pub(crate) votes: [usize; 2],
    /// The total evidence in the votes before the discussion.
    weight: f64,
}

/// The class's misconceptions, ordered by the number of teams that hold them before the discussion
/// and, in a tie, by the number after it, then by the evidence.
pub(crate) fn beliefs(round: &ClassRound) -> Vec<ClassBelief> {
    // Counted hands are anonymous, so their evidence is weighed question by question.
    let clues = Vote::BOTH.map(|vote| -> Vec<_> {
        let (questions, people) = (0..round.questions().len(), 0..round.participants().len());
        match round.way() {
            WayOfVoting::Tally => questions.map(|it| round.clues(it, vote)).collect(),
            _ => people.map(|it| round.clues_of(it, vote)).collect(),
        }
    });
    let of = |misconception| {
        let [first, second] = clues.each_ref().map(|teams| {
            let each = teams.iter().map(|clues| Evidence::of(misconception, clues));
            each.collect::<Vec<_>>()
        });
        let both = [&first, &second];
        ClassBelief {
            misconception,
            teams: both.map(|teams| teams.iter().filter(|it| it.names()).count()),
            votes: both.map(|teams| teams.iter().map(|it| it.times).sum()),
            weight: first.iter().map(|it| it.weight.max(0.0)).sum(),
        }
    };
    let mut held: Vec<_> = Misconception::ALL.iter().map(|it| of(*it)).collect();
    held.retain(|it| it.votes != [0, 0]);
    let rank = |it: &ClassBelief| (it.teams[0], it.teams[1], (1e6 * it.weight) as i64);
    held.sort_by_key(|it| Reverse(rank(it)));
    held
}

impl ClassBelief {
    /// The page that corrects the misconception. If the questions whose votes show it lead to
    /// different pages, this is the first of those pages in the order of the chapters.
    pub(crate) fn page(&self, round: &ClassRound) -> Passage {
        let shown = round.questions().iter().enumerate().filter(|(at, _)| {
            let mut held = Vote::BOTH.iter().flat_map(|vote| round.held(*at, *vote));
            held.any(|(misconception, _)| misconception == self.misconception)
        });
        let pages = shown.map(|(_, it)| self.misconception.settled_in(&it.topic, &it.figures));
        let first = pages.min_by_key(|page| ChaptersRead::order_of(page.chapter));
        first.unwrap_or_else(|| self.misconception.settled_by())
    }
}
