//! The results of each question for the class.

use std::cmp::Reverse;

use super::ballot::Vote;
use super::round::ClassRound;
use super::way::WayOfVoting;
use crate::progress::{Tally, discrimination};
use crate::quiz::{Misconception, Question, Response, evidence, letter};

/// The results of a question.
#[derive(Debug, Clone, PartialEq)]
pub struct ItemAnalysis {
    /// The question, counted from 0.
    pub question: usize,
    /// The votes of the teams before and after the discussion; a team that did not change its vote
    /// is counted in both.
    pub votes: [Tally; 2],
    /// How well the question separates those with the better results from the others.
    pub discrimination: Option<f64>,
    /// Of the misconceptions that first votes fit, the one with the strongest evidence, and the
    /// number of first votes that fit it.
    pub commonest: Option<(Misconception, usize)>,
    /// The number of first and second votes for each answer: choices in their order, other answers
    /// in descending order of first votes, then of second votes.
    pub counts: Vec<(Response, [usize; 2])>,
    /// The normalized gain of the discussion (R. R. Hake, 1998): (second − first) / (1 − first),
    /// where first and second are the shares of right votes; `None` if there are no first votes, or
    /// all of them were right.
    pub gain: Option<f64>,
    /// How many votes changed from wrong to right, and from right to wrong; `None` if hands were
    /// counted, because those votes are anonymous.
    pub changed: Option<[usize; 2]>,
}

/// The results of the first `asked` questions.
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

/// The number of votes for each answer, in each of the two votes.
fn counts(round: &ClassRound, question: usize) -> Vec<(Response, [usize; 2])> {
    let offered = round.offered(question);
    let is_sorted = offered.is_empty();
    let mut counts: Vec<_> = offered.into_iter().map(|choice| (choice, [0, 0])).collect();
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
    if is_sorted {
        counts.sort_by_key(|(_, counts)| Reverse(*counts));
    }
    counts
}

/// The letter of a choice, or another answer in words.
pub(crate) fn answer_name(question: &Question, said: &Response) -> String {
    match said {
        Response::Choice(choice) => letter(*choice).to_string(),
        _ => question.form.words(said),
    }
}

/// How many votes changed from wrong to right, and how many from right to wrong.
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

/// The points of each team for a question, and for all other questions that were asked.
fn points(round: &ClassRound, question: usize, asked: usize) -> Vec<(f64, f64)> {
    let of_team = |team| {
        let others = (0..asked).filter(|other| *other != question);
        let rest = others.map(|other| round.points(other, team)).sum();
        (round.points(question, team), rest)
    };
    (0..round.participants().len()).map(of_team).collect()
}
