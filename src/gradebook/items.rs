//! What each question showed about all who answered it.

use std::collections::BTreeMap;

use super::{ClassResults, rounds};
use crate::numbers::correlation;
use crate::progress::{Attempt, LESSON};
use crate::quiz::{Code, Misconception, Round};

/// Fewest answers from which on it is said how well a question tells pupils apart.
const ENOUGH: usize = 10;

/// What a question showed.
#[derive(Debug, Clone, PartialEq)]
pub struct ItemStatistics {
    /// The round, and the question's number in it, from 1.
    pub round: String,
    /// The number.
    pub number: u32,
    /// What was asked, where that follows from the code.
    pub question: Option<String>,
    /// How many answered it.
    pub answered: usize,
    /// The share of their answers that were right, 0 to 1.
    pub right: f64,
    /// The mean of their points, 0 to 10.
    pub points: f64,
    /// The correlation of its points with those of the other questions of the round, −1 to 1;
    /// `None` for fewer than ten answers, or where all did alike.
    pub discrimination: Option<f64>,
    /// The misconception that most answers fitted, and how many did.
    pub commonest: Option<(Misconception, usize)>,
}

/// What the questions of all rounds showed; those of chapters and of rounds that follow from the
/// answers differ from pupil to pupil.
pub fn items(results: &ClassResults<'_>) -> Vec<ItemStatistics> {
    let mut answers: BTreeMap<(&str, u32), Vec<(&Attempt, f64)>> = BTreeMap::new();
    for pupil in &results.pupils {
        let of_questions = pupil.answers.iter().filter(|(it, _)| it.family != LESSON);
        for (attempt, round) in of_questions {
            let sum = pupil.round(round);
            let rest = sum.map_or(0.0, |it| it.points) - rounds::points(attempt);
            let item = answers.entry((round, attempt.number)).or_default();
            item.push((attempt, rest));
        }
    }
    let mut asked: BTreeMap<&str, Option<Round>> = BTreeMap::new();
    let each = answers
        .into_iter()
        .filter_map(|((round, number), answers)| {
            let code = Code::parse(round);
            if code
                .as_ref()
                .is_some_and(|code| code.course.follows_answers())
            {
                return None;
            }
            let of_code = asked.entry(round).or_insert_with(|| code.map(Round::of));
            let place = usize::try_from(number).ok()?.checked_sub(1)?;
            let question = of_code.as_ref().and_then(|it| it.questions().get(place));
            let question = question.map(|it| it.text.clone());
            let count = answers.len();
            let right = answers.iter().filter(|(it, _)| it.right).count();
            let (points, rest): (Vec<f64>, Vec<f64>) = { answers.iter() }
                .map(|(it, rest)| (rounds::points(it), *rest))
                .unzip();
            Some(ItemStatistics {
                round: round.to_owned(),
                number,
                question,
                answered: count,
                right: right as f64 / count as f64,
                points: points.iter().sum::<f64>() / count as f64,
                discrimination: correlation(&points, &rest).filter(|_| count >= ENOUGH),
                commonest: commonest(answers.iter().map(|(it, _)| *it)),
            })
        });
    each.collect()
}

/// The misconception that most of these fitted; of equals the first of all.
fn commonest<'a>(answers: impl Iterator<Item = &'a Attempt>) -> Option<(Misconception, usize)> {
    let shown = answers.filter_map(|it| Misconception::with_id(it.misconception.as_deref()?));
    let shown: Vec<Misconception> = shown.collect();
    let count = |all: &Misconception| shown.iter().filter(|it| *it == all).count();
    let all = Misconception::ALL.iter().rev().map(|it| (*it, count(it)));
    all.max_by_key(|(_, count)| *count)
        .filter(|(_, count)| *count > 0)
}
