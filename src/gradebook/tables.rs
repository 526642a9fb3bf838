//! The gradebook as comma-separated values.

use super::{
    BeliefCount, ClassResults, ItemStatistics, Learning, Matched, beliefs, items, learning,
};
use crate::files::csv_table;
use crate::numbers::fixed;

/// One row per pupil: the total results, and those in each round and on each topic.
///
/// # Errors
/// The reason if a row cannot be written, which does not happen in practice.
pub fn pupils_csv(results: &ClassResults<'_>) -> Result<String, String> {
    let (rounds, topics) = (results.rounds(), results.topics());
    let first = "name,class,answered,right,share_right,points";
    let mut heads: Vec<_> = first.split(',').map(str::to_owned).collect();
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
    csv_table(heads.iter().map(String::as_str), &rows)
}

/// A number; empty if there is none.
fn figure(x: Option<f64>, decimals: usize) -> String {
    x.map_or(String::new(), |x| fixed(x, decimals))
}

/// One row per question: the results of all who answered it.
///
/// # Errors
/// The reason if a row cannot be written, which does not happen in practice.
pub fn items_csv(results: &ClassResults<'_>) -> Result<String, String> {
    let class = results.book.classes();
    let columns: [(&str, CellOf<ItemStatistics>); 10] = [
        ("round", &|it| it.round.clone()),
        ("number", &|it| it.number.to_string()),
        ("question", &|it| it.question.clone().unwrap_or_default()),
        ("answered", &|it| it.tally.attempts.to_string()),
        ("share_right", &|it| figure(it.tally.share_right(), 3)),
        ("mean_points", &|it| figure(it.tally.mean_points(), 1)),
        ("discrimination", &|it| figure(it.discrimination, 3)),
        ("commonest_misconception", &|it| {
            let held = it.commonest.map(|(held, _)| held.id());
            held.unwrap_or_default().into()
        }),
        ("commonest_answers", &|it| {
            it.commonest
                .map_or(String::new(), |(_, count)| count.to_string())
        }),
        ("class", &|_| class.clone()),
    ];
    table(&columns, &items(results))
}

/// A function that returns the text of a column's cell in a row.
type CellOf<'c, T> = &'c dyn Fn(&T) -> String;

/// A table of these columns, each with its heading.
fn table<T>(columns: &[(&str, CellOf<T>)], rows: &[T]) -> Result<String, String> {
    let row = |it| columns.iter().map(|(_, cell)| cell(it)).collect();
    let rows: Vec<Vec<String>> = rows.iter().map(row).collect();
    csv_table(columns.iter().map(|(head, _)| *head), &rows)
}

/// One row per misconception: how many pupils hold it.
///
/// # Errors
/// The reason if a row cannot be written, which does not happen in practice.
pub fn beliefs_csv(results: &ClassResults<'_>) -> Result<String, String> {
    let class = results.book.classes();
    let columns: [(&str, CellOf<BeliefCount>); 5] = [
        ("misconception", &|it| it.misconception.id().into()),
        ("in_words", &|it| it.misconception.name().into()),
        ("pupils", &|it| it.pupils.to_string()),
        ("answers", &|it| it.answers.to_string()),
        ("class", &|_| class.clone()),
    ];
    table(&columns, &beliefs(results))
}

/// One row per pupil who answered every question of the forms before and after a unit; `None` if
/// nobody has begun a form.
///
/// # Errors
/// The reason if a row cannot be written, which does not happen in practice.
pub fn learning_csv(results: &ClassResults<'_>) -> Result<Option<String>, String> {
    let all = learning(results);
    let columns: [(&str, CellOf<(&Learning, &Matched)>); 7] = [
        ("name", &|(_, it)| it.pupil.name.clone()),
        ("class", &|(_, it)| it.pupil.class.clone()),
        ("before", &|(of, _)| of.codes[0].clone()),
        ("after", &|(of, _)| of.codes[1].clone()),
        ("questions", &|(of, _)| of.count.to_string()),
        ("right_before", &|(_, it)| it.right[0].to_string()),
        ("right_after", &|(_, it)| it.right[1].to_string()),
    ];
    let rows = { all.iter() }.flat_map(|of| of.matched.iter().map(move |it| (of, it)));
    match all.is_empty() {
        true => Ok(None),
        false => table(&columns, &rows.collect::<Vec<_>>()).map(Some),
    }
}
