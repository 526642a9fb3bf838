//! What each question showed about the class.

use std::cmp::Reverse;

use super::ballot::Vote;
use super::round::ClassRound;
use super::way::WayOfVoting;
use crate::progress::{Tally, discrimination};
use crate::quiz::{Form, Misconception, Response, evidence};

/// What a question showed.
#[derive(Debug, Clone, PartialEq)]
pub struct ItemAnalysis {
    /// The question, counted from 0.
    pub question: usize,
    /// The votes of the teams at first, and after talking; a team that did not change its vote
    /// counts in both.
    pub votes: [Tally; 2],
    /// How well it tells the better teams from the others.
    pub discrimination: Option<f64>,
    /// The misconception for which the first votes speak most, and how many fitted it.
    pub commonest: Option<(Misconception, usize)>,
    /// How many said each at these votes: the choices in their order, else what was said from
    /// what most said on.
    pub counts: Vec<(Response, [usize; 2])>,
    /// The share of what could be gained by talking that was: of those votes that were wrong at
    /// first, less those that were right (R. R. Hake, 1998); `None` where there was nothing to be
    /// gained, or nobody voted.
    pub gain: Option<f64>,
    /// How many changed from a wrong vote to a right one, and the other way round; `None` where
    /// hands were counted, so that nobody knows whose they were.
    pub changed: Option<[usize; 2]>,
}

/// What the first `asked` questions showed.
pub fn items(round: &ClassRound, asked: usize) -> Vec<ItemAnalysis> {
    let asked = asked.min(round.questions().len());
    (0..asked).map(|i| item(round, i, asked)).collect()
}

fn item(round: &ClassRound, question: usize, asked: usize) -> ItemAnalysis {
    let votes = Vote::BOTH.map(|vote| round.results(question, vote));
    let spoken_for = evidence(&round.clues(question, Vote::First)).into_iter();
    ItemAnalysis {
        question,
        votes,
        gain: gain(votes.map(|it| it.share_right())),
        counts: counts(round, question),
        changed: changed(round, question),
        discrimination: discrimination(points(round, question, asked)),
        commonest: { spoken_for }
            .find(|it| it.times > 0)
            .map(|it| (it.misconception, it.times)),
    }
}

fn gain(right: [Option<f64>; 2]) -> Option<f64> {
    let [first, second] = [right[0]?, right[1]?];
    (first < 1.0).then(|| (second - first) / (1.0 - first))
}

/// How many said what at both votes.
fn counts(round: &ClassRound, question: usize) -> Vec<(Response, [usize; 2])> {
    let asked = round.questions().get(question);
    let has_choices = asked.is_some_and(|it| matches!(it.form, Form::Choice { .. }));
    let given = has_choices || round.way() == WayOfVoting::Tally;
    let choices = if given {
        round.choices(question)
    } else {
        Vec::new()
    };
    let mut counts: Vec<_> = choices.into_iter().map(|choice| (choice, [0, 0])).collect();
    for vote in Vote::BOTH {
        for said in round.said(question, vote) {
            let at = counts.iter().position(|(it, _)| *it == said);
            let at = at.unwrap_or_else(|| {
                counts.push((said, [0, 0]));
                counts.len() - 1
            });
            counts[at].1[vote as usize] += 1;
        }
    }
    if !given {
        counts.sort_by_key(|(_, counts)| Reverse(*counts));
    }
    counts
}

/// How many changed to a right vote and to a wrong one.
fn changed(round: &ClassRound, question: usize) -> Option<[usize; 2]> {
    if round.way() == WayOfVoting::Tally {
        return None;
    }
    let mut changed = [0, 0];
    for team in round.participants() {
        let ballot = team.ballot(question);
        let right = Vote::BOTH.map(|vote| Some(round.grade(question, ballot.vote(vote))?.right));
        match right {
            [Some(false), Some(true)] => changed[0] += 1,
            [Some(true), Some(false)] => changed[1] += 1,
            _ => {}
        }
    }
    Some(changed)
}

/// The points of each team for a question, and for all others that were asked.
fn points(round: &ClassRound, question: usize, asked: usize) -> Vec<(f64, f64)> {
    let of_team = |team| {
        let others = (0..asked).filter(|other| *other != question);
        let rest = others.map(|other| round.points(other, team)).sum();
        (round.points(question, team), rest)
    };
    (0..round.participants().len()).map(of_team).collect()
}
