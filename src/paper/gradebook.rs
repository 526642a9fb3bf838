//! The gradebook of a class, with a page for each pupil.

use maud::{Markup, Render, html};

use super::{Paper, clean, html_page};
use crate::gradebook::{
    ClassResults, FEWEST, Learning, Matched, NoGain, PupilResults, beliefs, items, learning,
};
use crate::numbers::{counted, fixed};
use crate::progress::words::percent;
use crate::progress::{HeldBelief, Mastery};

const STYLE: &str = include_str!("gradebook.css");
/// The maximum width, in characters, of a name, and of the name of a round or topic at the head of
/// a table column. A wide letter counts as two.
const NAME: usize = 44;
const HEAD: usize = 40;
/// The maximum width, in characters, of a question in a table. Only damaged files contain longer
/// questions.
const QUESTION: usize = 400;
/// The maximum number of round or topic columns in a table; the rest go into further tables.
const COLUMNS: usize = 6;

/// The gradebook as an HTML document: the results by pupil, what the class has learnt (if anyone
/// has begun a form before or after a unit), the results by question, the class's misconceptions,
/// then one page per pupil.
pub fn html(results: &ClassResults<'_>) -> String {
    let forms = learning(results);
    let mut sheets = vec![sheet("Gradebook", &overview(results))];
    if !forms.is_empty() {
        sheets.push(sheet("Did the class learn it?", &learnt(&forms)));
    }
    sheets.push(sheet("The questions", &questions(results)));
    sheets.push(sheet("What the class believes", &believed(results)));
    let pupils = results.pupils.iter();
    sheets.extend(pupils.map(|it| sheet(&clean(&it.pupil.name, NAME), &report(it))));
    html_page("carrom: gradebook", STYLE, Paper::A4, sheets)
}

fn sheet(title: &str, body: &Markup) -> Markup {
    html! {
        div.gradebook {
            header { p.dim { "carrom · glancing collisions" } h1 { bdi { (title) } } }
            (body)
        }
    }
}

/// A table with headings and rows. The first `texts` columns contain text, the others numbers.
fn table(
    texts: usize,
    heads: &[impl Render],
    rows: impl IntoIterator<Item = Vec<String>>,
) -> Markup {
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
        table(2, &heads, rows)
    });
    html! { h2 { (title) } @for table in tables { (table) } }
}

/// What the class has learnt, as shown by the forms before and after a unit.
fn learnt(forms: &[Learning<'_>]) -> Markup {
    html! {
        @for of in forms {
            @let [before, after] = &of.codes;
            @let pupils = of.matched.len();
            h2 { (before) " and " (after) }
            p {
                (counted(of.count, "question")) " before and as many parallel ones after. "
                (counted(pupils, "pupil")) " answered all of them"
                @if of.others > 0 { "; " (counted(of.others, "pupil")) " answered only some and " (if of.others == 1 { "is" } else { "are" }) " left out" }
                "."
            }
            p { strong { (of_the_class(of)) } }
            @if pupils > 0 {
                h3 { "By pupil" }
                (table(2, &["pupil", "class", "right before", "right after", "change"], by_pupil(of)))
            }
            @if of.gain.is_ok() || pupils >= FEWEST {
                h3 { "By misconception" }
                @let rows = by_misconception(of);
                @if rows.is_empty() { p { "No answer fits a misconception that both forms can show." } }
                @else {
                    (table(1, &["misconception", "fits before", "fits after"], rows))
                    p.dim { "How many answers fit the misconception, out of those that could have shown it." }
                }
            }
        }
        p.dim {
            "The normalized gain is (post − pre) / (100 % − pre) of the mean scores: the share of the "
            "possible improvement that the class achieved. carrom guide judging gives the exact "
            "definition. The forms are not a standardized test: do not compare the gain with "
            "published ones."
        }
    }
}

/// The gain of the class, or why none is stated.
fn of_the_class(of: &Learning<'_>) -> String {
    let pupils = of.matched.len();
    match &of.gain {
        Ok(it) => {
            let [before, after] = it.means.map(|mean| percent(Some(mean)));
            let [low, high] = it.interval.map(|end| fixed(end, 2));
            format!(
                "Normalized gain {}, 95 % confidence interval {low} to {high}, from {pupils} pupils: \
                 {before} right before, {after} right after.",
                fixed(it.gain, 2)
            )
        }
        Err(NoGain::TooFew) => {
            format!("Too few pupils to state a gain: {pupils}, but at least {FEWEST} are needed.")
        }
        Err(NoGain::NothingToLearn) => {
            format!("No gain can be measured: the {pupils} pupils made too few mistakes before.")
        }
    }
}

fn by_pupil(of: &Learning<'_>) -> Vec<Vec<String>> {
    let row = |it: &Matched<'_>| {
        let mut row = vec![clean(&it.pupil.name, NAME), clean(&it.pupil.class, 16)];
        row.extend(it.right.map(|right| format!("{right} of {}", of.count)));
        let [before, after] = it.right.map(|right| right as i64);
        row.push(match after - before {
            0 => "0".into(),
            change => format!("{change:+}"),
        });
        row
    };
    of.matched.iter().map(row).collect()
}

fn by_misconception(of: &Learning<'_>) -> Vec<Vec<String>> {
    let row = |it: &HeldBelief| {
        let name = it.misconception.name().to_owned();
        vec![name, it.before.to_string(), it.since.to_string()]
    };
    of.beliefs.iter().map(row).collect()
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
    html! {
        (table(4, &heads, rows))
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
    let rounds = results.rounds.iter().map(|(round, it)| {
        let [answered, right] = [it.attempts, it.right].map(|it| it.to_string());
        vec![clean(round, NAME), answered, right, fixed(it.points(), 1)]
    });
    let topics = results.topics.values().map(|it| {
        let [answered, right] = [it.all.attempts, it.all.right].map(|it| it.to_string());
        let mastery = it.mastery().name().to_owned();
        vec![clean(&it.name, NAME), mastery, answered, right]
    });
    let held = &results.beliefs;
    html! {
        p data-class=(pupil.class) {
            @if !pupil.class.is_empty() { bdi { (clean(&pupil.class, NAME)) } ". " }
            (counted(tally.attempts, "answer")) ", " (percent(tally.share_right())) " right."
        }
        h2 { "Rounds" }
        (table(1, &["round", "answered", "right", "points"], rounds))
        h2 { "Topics" }
        (table(2, &["topic", "", "answered", "right"], topics))
        p.dim { (Mastery::MEANING) }
        @if !held.is_empty() {
            h2 { "What the answers show" }
            @for it in held {
                p { strong { (it.misconception.name()) } " (" (it.trend().name()) "). " (it.misconception.advice()) }
            }
        }
    }
}
