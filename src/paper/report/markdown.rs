//! The report as Markdown.

use super::Report;
use super::rows::{ChapterRow, Cut, PackRow, of};
use crate::numbers::counted;
use crate::paper::{Markdown, clean};
use crate::progress::words::{degrees, percent};
use crate::quiz::NAMED_ODDS;

/// The maximum number of columns in a topic's name.
const TOPIC: usize = 60;

pub(super) fn document(report: &Report, folder: &str) -> String {
    let mut document = Markdown::new();
    document.heading(1, &report.name);
    document.paragraph("carrom · glancing collisions");
    if report.attempts.is_empty() {
        document.paragraph("There is nothing here yet: every game starts with a clean board.");
    } else {
        document.paragraph(&format!("{}.", report.span()));
        figures(report, &mut document);
        for picture in report.pictures() {
            let place = format!("{folder}/{}.svg", picture.name);
            document.heading(2, picture.title);
            document.picture(picture.svg.words(), &place);
            document.paragraph(&picture.legend);
        }
        tables(report, &mut document);
    }
    document.heading(2, "What next").paragraph(&report.next());
    document.rule().paragraph(&report.origin());
    document.text().to_owned()
}

fn figures(report: &Report, document: &mut Markdown) {
    let mut rows = Vec::new();
    let mut row = |name: &str, value| rows.push(vec![name.to_owned(), value]);
    row("answered", report.all.attempts.to_string());
    row("right", percent(report.all.share_right()));
    if let Some(error) = report.all.mean_error_deg() {
        let of = format!("mean error of {}", counted(report.all.angles(), "angle"));
        row(&of, degrees(Some(error)));
    }
    if let Some((first, last)) = report.ends() {
        row("mean error of the first ten", degrees(Some(first)));
        row("mean error of the last ten", degrees(Some(last)));
    }
    row("topics solid", report.solid.to_string());
    row("chapters done", of(report.done));
    row("stars", of(report.stars));
    document.table(&["overall", ""], rows);
}

fn tables(report: &Report, document: &mut Markdown) {
    let topics = &report.topics;
    if !topics.rows.is_empty() {
        let rows = topics.rows.iter().map(|topic| {
            vec![
                clean(&topic.name, TOPIC),
                topic.mastery().name().to_owned(),
                of((topic.all.right, topic.all.attempts)),
                of((topic.lately.right, topic.lately.attempts)),
                degrees(topic.all.mean_error_deg()),
            ]
        });
        let heads = ["topic", "state", "right", "of the last five", "error"];
        table(document, "Topics", &heads, topics, rows);
    }
    let beliefs = &report.beliefs;
    if beliefs.rows.is_empty() {
        document.heading(2, "Misconceptions");
        document.paragraph("No known misconception stands out in the answers.");
    } else {
        let rows = beliefs.rows.iter().map(|belief| {
            vec![
                belief.misconception.name().to_owned(),
                belief.before.to_string(),
                belief.since.to_string(),
                belief.trend().name().to_owned(),
            ]
        });
        let heads = ["what wrong answers had in common", "before", "since", ""];
        table(document, "Misconceptions", &heads, beliefs, rows);
        document.paragraph(&format!(
            "How many answers fitted the misconception, out of the questions that could have shown \
             it: in the first half of the answers, and since. A misconception is listed once it \
             explains the answers {NAMED_ODDS} times better than guessing does."
        ));
    }
    if !report.seen.is_empty() {
        document.heading(2, "Observations");
        document.paragraph(&report.seen.join(" "));
    }
    let chapters = &report.chapters;
    if !chapters.rows.is_empty() {
        let row = |it: &ChapterRow| vec![it.title.clone(), of(it.read), of(it.right)];
        let heads = ["chapter", "pages read", "questions right"];
        table(
            document,
            "Chapters",
            &heads,
            chapters,
            chapters.rows.iter().map(row),
        );
    }
    let packs = &report.packs;
    if !packs.rows.is_empty() {
        let row = |it: &PackRow| vec![it.title.clone(), of((it.stars, it.most))];
        table(
            document,
            "Levels",
            &["pack", "stars"],
            packs,
            packs.rows.iter().map(row),
        );
    }
}

/// A table under its title, followed by the number of rows left out.
fn table<T>(
    document: &mut Markdown,
    title: &str,
    heads: &[&str],
    cut: &Cut<T>,
    rows: impl Iterator<Item = Vec<String>>,
) {
    document.heading(2, title).table(heads, rows);
    if let Some(more) = cut.and_more() {
        document.paragraph(&more);
    }
}
