//! What each question showed about the class.

use std::cmp::Reverse;

use super::ballot::Vote;
use super::round::ClassRound;
use super::way::WayOfVoting;
use crate::numbers::{self, correlation};
use crate::quiz::{Form, Misconception, Response, evidence};

/// What a question showed.
#[derive(Debug, Clone, PartialEq)]
pub struct ItemAnalysis {
    /// The question, counted from 0.
    pub question: usize,
    /// How many teams voted on it first, and after talking; a team that did not change
    /// its vote counts in both.
    pub votes: [usize; 2],
    /// The share of these votes that were right, 0 to 1; `None` where there were none.
    pub right: [Option<f64>; 2],
    /// How the errors of these votes are spread, where the answer is an angle.
    pub spread: [Option<Spread>; 2],
    /// How well the question tells the better teams from the others: the correlation
    /// between the points for it and the points for all other questions, −1 to 1;
    /// `None` for fewer than ten of them or where all did alike.
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

/// Fewest teams or people from which on it is said how well a question tells them apart.
const ENOUGH: usize = 10;

/// How errors of angles are spread, in radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// Their mean.
    pub mean: f64,
    /// Their standard deviation about it, that of the votes given, not an estimate for
    /// others.
    pub deviation: f64,
}

/// What the first `asked` questions showed.
pub fn items(round: &ClassRound, asked: usize) -> Vec<ItemAnalysis> {
    let asked = asked.min(round.questions().len());
    (0..asked).map(|i| item(round, i, asked)).collect()
}

fn item(round: &ClassRound, question: usize, asked: usize) -> ItemAnalysis {
    let grades = Vote::BOTH.map(|vote| round.grades(question, vote));
    let spoken_for = evidence(&round.clues(question, Vote::First)).into_iter();
    let right = grades.each_ref().map(|grades| {
        let right = grades.iter().filter(|grade| grade.right).count();
        (!grades.is_empty()).then(|| right as f64 / grades.len() as f64)
    });
    ItemAnalysis {
        question,
        votes: grades.each_ref().map(Vec::len),
        right,
        gain: gain(right),
        counts: counts(round, question),
        changed: changed(round, question),
        spread: grades.each_ref().map(|grades| {
            let errors: Vec<f64> = grades.iter().filter_map(|it| it.angle_error).collect();
            spread(&errors)
        }),
        discrimination: discrimination(round, question, asked),
        commonest: { spoken_for }
            .find(|it| it.times > 0)
            .map(|it| (it.misconception, it.times)),
    }
}

fn spread(errors: &[f64]) -> Option<Spread> {
    let mean = numbers::mean(errors)?;
    let squares: Vec<f64> = errors.iter().map(|error| (error - mean).powi(2)).collect();
    Some(Spread {
        mean,
        deviation: numbers::mean(&squares)?.sqrt(),
    })
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

fn discrimination(round: &ClassRound, question: usize, asked: usize) -> Option<f64> {
    let teams = 0..round.participants().len();
    let own: Vec<f64> = teams
        .clone()
        .map(|team| round.points(question, team))
        .collect();
    let rest: Vec<f64> = teams
        .map(|team| {
            let others = (0..asked).filter(|other| *other != question);
            others.map(|other| round.points(other, team)).sum()
        })
        .collect();
    correlation(&own, &rest).filter(|_| own.len() >= ENOUGH)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spread_by_hand() {
        let spread = spread(&[1.0, 3.0]).unwrap();
        assert!((spread.mean - 2.0).abs() < 1e-12 && (spread.deviation - 1.0).abs() < 1e-12);
        assert_eq!(super::spread(&[]), None);
    }
}
