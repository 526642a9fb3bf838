//! The gradebook as comma-separated values.

use super::{ClassResults, beliefs, items};
use crate::files::csv_table;
use crate::numbers::fixed;

/// A row a pupil: what was answered in all, in each round and on each topic.
///
/// # Errors
/// None that can be met in practice; the reason, should a row not be writable.
pub fn pupils_csv(results: &ClassResults<'_>) -> Result<String, String> {
    let (rounds, topics) = (results.rounds(), results.topics());
    let mut heads: Vec<String> = [
        "name",
        "class",
        "answered",
        "right",
        "share_right",
        "points",
    ]
    .map(Into::into)
    .to_vec();
    for round in &rounds {
        heads.extend(["answered", "right", "points"].map(|what| format!("{round} {what}")));
    }
    for topic in &topics {
        heads.extend(["answered", "right"].map(|what| format!("{topic}: {what}")));
    }
    let rows: Vec<Vec<String>> = { results.pupils.iter() }
        .map(|it| {
            let tally = it.tally;
            let mut row = vec![
                it.pupil.name.clone(),
                it.pupil.class.clone(),
                tally.attempts.to_string(),
                tally.right.to_string(),
                figure(tally.share_right(), 3),
                fixed(tally.points(), 1),
            ];
            for round in &rounds {
                row.extend(it.rounds.get(*round).map_or_else(Default::default, |it| {
                    [
                        it.attempts.to_string(),
                        it.right.to_string(),
                        fixed(it.points(), 1),
                    ]
                }));
            }
            for topic in &topics {
                row.extend(it.topics.get(*topic).map_or_else(Default::default, |it| {
                    [it.all.attempts.to_string(), it.all.right.to_string()]
                }));
            }
            row
        })
        .collect();
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    csv_table(&heads, &rows)
}

/// A figure; nothing where there is none.
fn figure(x: Option<f64>, decimals: usize) -> String {
    x.map_or(String::new(), |x| fixed(x, decimals))
}

/// A row a question: how all who answered it did.
///
/// # Errors
/// None that can be met in practice; the reason, should a row not be writable.
pub fn items_csv(results: &ClassResults<'_>) -> Result<String, String> {
    let class = results.book.classes();
    let rows: Vec<Vec<String>> = { items(results).into_iter() }
        .map(|it| {
            let (belief, count) = it.commonest.map_or_else(Default::default, |(held, count)| {
                (held.id().to_owned(), count.to_string())
            });
            vec![
                it.round,
                it.number.to_string(),
                it.question.unwrap_or_default(),
                it.tally.attempts.to_string(),
                figure(it.tally.share_right(), 3),
                figure(it.tally.mean_points(), 1),
                figure(it.discrimination, 3),
                belief,
                count,
                class.clone(),
            ]
        })
        .collect();
    let heads = [
        "round",
        "number",
        "question",
        "answered",
        "share_right",
        "mean_points",
        "discrimination",
        "commonest_misconception",
        "commonest_answers",
        "class",
    ];
    csv_table(&heads, &rows)
}

/// A row a misconception: how many hold it.
///
/// # Errors
/// None that can be met in practice; the reason, should a row not be writable.
pub fn beliefs_csv(results: &ClassResults<'_>) -> Result<String, String> {
    let class = results.book.classes();
    let rows: Vec<Vec<String>> = { beliefs(results).into_iter() }
        .map(|it| {
            vec![
                it.misconception.id().into(),
                it.misconception.name().into(),
                it.pupils.to_string(),
                it.answers.to_string(),
                class.clone(),
            ]
        })
        .collect();
    let heads = ["misconception", "in_words", "pupils", "answers", "class"];
    csv_table(&heads, &rows)
}
