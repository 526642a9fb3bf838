//! The gradebook of a class, with a page for each pupil.

use maud::{Markup, html};

use super::{Paper, clean, html_page};
use crate::gradebook::{ClassResults, PupilResults, beliefs, items};
use crate::numbers::{counted, fixed};
use crate::progress::Mastery;
use crate::progress::words::percent;

/// The maximum number of letters in a name, and in the round or topic at the head of a column.
const NAME: usize = 44;
const HEAD: usize = 40;
/// The maximum number of letters in a question in a table. Only damaged files contain longer ones.
const QUESTION: usize = 400;
/// The maximum number of round or topic columns in a table; the rest go into further tables.
const COLUMNS: usize = 6;

/// The gradebook as an HTML document: the results by pupil, the results by question, the class's
/// misconceptions, then one page per pupil.
pub fn html(results: &ClassResults<'_>) -> String {
    let of_class = [
        sheet("Gradebook", &overview(results)),
        sheet("The questions", &questions(results)),
        sheet("What the class believes", &believed(results)),
    ];
    let pupils =
        { results.pupils.iter() }.map(|it| sheet(&clean(&it.pupil.name, NAME), &report(it)));
    let sheets = of_class.into_iter().chain(pupils);
    html_page(
        "carrom: gradebook",
        include_str!("gradebook.css"),
        Paper::A4,
        sheets,
    )
}

fn sheet(title: &str, body: &Markup) -> Markup {
    html! {
        div.gradebook {
            header { p.dim { "carrom · glancing collisions" } h1 { bdi { (title) } } }
            (body)
        }
    }
}

/// A table with headings and rows. The first `texts` columns are text, the others numbers.
fn table(texts: usize, heads: &[String], rows: &[Vec<String>]) -> Markup {
    html! {
        table {
            thead { tr { @for (i, head) in heads.iter().enumerate() { th.n[i >= texts] { bdi { (head) } } } } }
            tbody {
                @for row in rows {
                    tr { @for (i, cell) in row.iter().enumerate() { td.n[i >= texts] { bdi { (cell) } } } }
                }
            }
        }
    }
}

fn overview(results: &ClassResults<'_>) -> Markup {
    let book = results.book;
    let answers: usize = results.pupils.iter().map(|it| it.tally.attempts).sum();
    let all = html! {
        p {
            (counted(book.pupils.len(), "pupil")) ", " (counted(answers, "answer")) ". "
            "For each question in a round, the first answer counts: 0 to 10 points, depending on "
            "how close it was."
        }
        @if !book.notes.is_empty() {
            h2 { "About the files" }
            ul.notes { @for note in &book.notes { li { bdi { (clean(note, 240)) } } } }
        }
    };
    let (rounds, topics) = (results.rounds(), results.topics());
    let rounds = by_columns(
        results,
        "Rounds: points (right out of answered)",
        &rounds,
        |pupil, round| {
            let it = pupil.rounds.get(round)?;
            let points = fixed(it.points(), 1);
            Some(format!("{points} ({} of {})", it.right, it.attempts))
        },
    );
    let topics = by_columns(
        results,
        "Topics: right out of answered",
        &topics,
        |pupil, topic| {
            let it = pupil.topics.get(topic)?;
            Some(format!("{} of {}", it.all.right, it.all.attempts))
        },
    );
    html! { (all) (rounds) (topics) }
}

/// Tables with one row per pupil and one column for each of the `columns`.
fn by_columns(
    results: &ClassResults<'_>,
    title: &str,
    columns: &[&str],
    cell: impl Fn(&PupilResults<'_>, &str) -> Option<String>,
) -> Markup {
    let tables = columns.chunks(COLUMNS).map(|columns| {
        let mut heads = vec!["pupil".to_owned(), "class".to_owned()];
        heads.extend(columns.iter().map(|it| clean(it, HEAD)));
        let rows = results.pupils.iter().map(|of| {
            let mut row = vec![clean(&of.pupil.name, NAME), clean(&of.pupil.class, 16)];
            row.extend(columns.iter().map(|it| cell(of, it).unwrap_or_default()));
            row
        });
        table(2, &heads, &rows.collect::<Vec<_>>())
    });
    html! { h2 { (title) } @for table in tables { (table) } }
}

fn questions(results: &ClassResults<'_>) -> Markup {
    let heads = [
        "round",
        "",
        "question",
        "most common mistake",
        "answered",
        "right",
        "points",
        "discrimination",
    ];
    let rows = items(results).into_iter().map(|it| {
        let commonest = it.commonest.map_or(String::new(), |(held, count)| {
            format!("{}: {count}", held.name())
        });
        vec![
            clean(&it.round, HEAD),
            it.number.to_string(),
            clean(&it.question.unwrap_or_default(), QUESTION),
            commonest,
            it.tally.attempts.to_string(),
            percent(it.tally.share_right()),
            it.tally.mean_points().map_or("–".into(), |it| fixed(it, 1)),
            it.discrimination.map_or("–".into(), |it| fixed(it, 2)),
        ]
    });
    let rows: Vec<Vec<String>> = rows.collect();
    html! {
        (table(4, &heads.map(Into::into), &rows))
        p.dim {
            "Discrimination: the correlation of a question's points with those of the other "
            "questions of its round, from −1 to 1, for at least ten answers."
        }
    }
}

fn believed(results: &ClassResults<'_>) -> Markup {
    let held = beliefs(results);
    html! {
        @if held.is_empty() { p { "No answer fits a known misconception." } }
        @for it in &held {
            h2 { (it.misconception.name()) }
            p {
                "Held by " (counted(it.pupils, "pupil")) "; fits " (counted(it.answers, "answer"))
                ". " (it.misconception.advice())
            }
        }
    }
}

fn report(results: &PupilResults<'_>) -> Markup {
    let (pupil, tally) = (results.pupil, results.tally);
    let rounds: Vec<Vec<String>> = { results.rounds.iter() }
        .map(|(round, it)| {
            let [answered, right] = [it.attempts, it.right].map(|it| it.to_string());
            vec![clean(round, NAME), answered, right, fixed(it.points(), 1)]
        })
        .collect();
    let topics: Vec<Vec<String>> = { results.topics.values() }
        .map(|it| {
            let [answered, right] = [it.all.attempts, it.all.right].map(|it| it.to_string());
            let mastery = it.mastery().name().to_owned();
            vec![clean(&it.name, NAME), mastery, answered, right]
        })
        .collect();
    let held = &results.beliefs;
    html! {
        p data-class=(pupil.class) {
            @if !pupil.class.is_empty() { bdi { (clean(&pupil.class, NAME)) } ". " }
            (counted(tally.attempts, "answer")) ", " (percent(tally.share_right())) " right."
        }
        h2 { "Rounds" }
        (table(1, &["round", "answered", "right", "points"].map(Into::into), &rounds))
        h2 { "Topics" }
        (table(2, &["topic", "", "answered", "right"].map(Into::into), &topics))
        p.dim { (Mastery::MEANING) }
        @if !held.is_empty() {
            h2 { "What the answers show" }
            @for it in held {
                p { strong { (it.misconception.name()) } " (" (it.trend().name()) "). " (it.misconception.advice()) }
            }
        }
    }
}
