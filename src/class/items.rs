//! What each question showed about the class.

use super::{ClassRound, Vote};
use crate::numbers::{self, correlation};
use crate::quiz::{Misconception, evidence};

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
    /// `None` for fewer than three teams or where all did alike.
    pub discrimination: Option<f64>,
    /// The misconception for which the first votes speak most, and how many fitted it.
    pub commonest: Option<(Misconception, usize)>,
}

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
    ItemAnalysis {
        question,
        votes: grades.each_ref().map(Vec::len),
        right: grades.each_ref().map(|grades| {
            let right = grades.iter().filter(|grade| grade.right).count();
            (!grades.is_empty()).then(|| right as f64 / grades.len() as f64)
        }),
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

fn discrimination(round: &ClassRound, question: usize, asked: usize) -> Option<f64> {
    let teams = 0..round.teams().len();
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
    correlation(&own, &rest)
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
