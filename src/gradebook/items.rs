//! The results of each question over all pupils who answered it.

use std::collections::BTreeMap;

use super::ClassResults;
use crate::progress::{Attempt, Tally, discrimination};
use crate::quiz::{Code, Course, Misconception, Round};

/// The results of a question.
#[derive(Debug, Clone, PartialEq)]
pub struct ItemStatistics {
    /// The round.
    pub round: String,
    /// The question's number in the round, from 1.
    pub number: u32,
    /// The text of the question, if the code determines it.
    pub question: Option<String>,
    /// The counts of the answers to the question; there is at least one answer.
    pub tally: Tally,
    /// How well the question distinguishes strong from weak pupils, −1 to 1.
    pub discrimination: Option<f64>,
    /// The misconception that fits the most answers, and the number of those answers.
    pub commonest: Option<(Misconception, usize)>,
}

/// The results of each question in the pupils' rounds. Chapters, the table and levels are left out,
/// and so are rounds whose questions depend on the answers, because they differ between pupils.
pub fn items(results: &ClassResults<'_>) -> Vec<ItemStatistics> {
    let mut answers: BTreeMap<(&str, u32), Vec<(&Attempt, f64)>> = BTreeMap::new();
    for pupil in &results.pupils {
        let of_questions = pupil.answers.iter().filter(|(it, _)| it.is_of_quiz());
        for (attempt, round) in of_questions {
            let sum = pupil.rounds.get(round);
            let rest = sum.map_or(0.0, Tally::points) - attempt.points();
            let item = answers.entry((round, attempt.number)).or_default();
            item.push((attempt, rest));
        }
    }
    let mut asked: BTreeMap<&str, Option<Round>> = BTreeMap::new();
    let each = answers
        .into_iter()
        .filter_map(|((round, number), answers)| {
            let code = Code::parse(round);
            let course = code.as_ref().map(|it| &it.course);
            if course.is_some_and(Course::follows_answers) {
                return None;
            }
            let of_code = asked.entry(round).or_insert_with(|| code.map(Round::of));
            let place = usize::try_from(number).ok()?.checked_sub(1)?;
            let question = of_code.as_ref().and_then(|it| it.questions().get(place));
            let question = question.map(|it| it.text.clone());
            Some(ItemStatistics {
                round: round.to_owned(),
                number,
                question,
                tally: Tally::of(answers.iter().map(|(it, _)| *it)),
                discrimination: discrimination(
                    answers.iter().map(|(it, rest)| (it.points(), *rest)),
                ),
                commonest: commonest(answers.iter().map(|(it, _)| *it)),
            })
        });
    each.collect()
}

/// The misconception that fits the largest number of these answers and, if several do, the first of
/// them.
fn commonest<'a>(answers: impl Iterator<Item = &'a Attempt>) -> Option<(Misconception, usize)> {
    let shown = answers.filter_map(Attempt::shows);
    let shown: Vec<Misconception> = shown.collect();
    let count = |all: &Misconception| shown.iter().filter(|it| *it == all).count();
    let all = Misconception::ALL.iter().rev().map(|it| (*it, count(it)));
    all.max_by_key(|(_, count)| *count)
        .filter(|(_, count)| *count > 0)
}
