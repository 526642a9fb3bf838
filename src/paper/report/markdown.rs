//! The report as Markdown.

use super::Report;
use super::rows::of;
use crate::paper::{Markdown, clean};
use crate::progress::words::{angles, degrees, percent};

/// Columns of a topic's name.
const TOPIC: usize = 60;

pub(super) fn document(report: &Report, folder: &str) -> String {
    let mut document = Markdown::new();
    document.heading(1, &report.name);
    document.paragraph("carrom · glancing collisions");
    if report.attempts.is_empty() {
        document.paragraph("Nothing here yet: every beginning is a clean board.");
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
    let mut rows = vec![
        vec!["answered".to_owned(), report.all.attempts.to_string()],
        vec!["right".to_owned(), percent(report.all.share_right())],
    ];
    if let Some(error) = report.all.mean_error_deg() {
        let of = format!("mean error of {}", angles(report.all.angles()));
        rows.push(vec![of, degrees(Some(error))]);
    }
    if let Some((first, last)) = report.ends() {
        rows.push(vec![
            "mean error of the first ten".to_owned(),
            degrees(Some(first)),
        ]);
        rows.push(vec![
            "mean error of the last ten".to_owned(),
            degrees(Some(last)),
        ]);
    }
    rows.push(vec!["topics solid".to_owned(), report.solid.to_string()]);
    rows.push(vec!["chapters done".to_owned(), of(report.done)]);
    rows.push(vec!["stars".to_owned(), of(report.stars)]);
    document.table(&["all in all", ""], rows);
}

fn tables(report: &Report, document: &mut Markdown) {
    let more = |document: &mut Markdown, more: Option<String>| {
        if let Some(more) = more {
            document.paragraph(&more);
        }
    };
    if !report.topics.rows.is_empty() {
        document.heading(2, "Topics");
        let rows = report.topics.rows.iter().map(|topic| {
            vec![
                clean(&topic.name, TOPIC),
                topic.mastery().name().to_owned(),
                format!("{} of {}", topic.all.right, topic.all.attempts),
                format!("{} of {}", topic.lately.right, topic.lately.attempts),
                degrees(topic.all.mean_error_deg()),
            ]
        });
        document.table(
            &["topic", "stands", "right", "of the last five", "off by"],
            rows,
        );
        more(document, report.topics.and_more());
    }
    document.heading(2, "Misconceptions");
    if report.beliefs.rows.is_empty() {
        document.paragraph("No answer fitted a known misconception.");
    } else {
        let rows = report.beliefs.rows.iter().map(|belief| {
            vec![
                belief.misconception.name().to_owned(),
                belief.before.to_string(),
                belief.since.to_string(),
                belief.trend().name().to_owned(),
            ]
        });
        let heads = ["what wrong answers had in common", "before", "since", ""];
        document.table(&heads, rows);
        more(document, report.beliefs.and_more());
        document.paragraph(
            "Of how many questions could have shown it, before the middle of all answers and \
             since.",
        );
    }
    if !report.chapters.rows.is_empty() {
        document.heading(2, "Chapters");
        let rows = report
            .chapters
            .rows
            .iter()
            .map(|chapter| vec![chapter.title.clone(), of(chapter.read), of(chapter.right)]);
        document.table(&["chapter", "pages read", "questions right"], rows);
        more(document, report.chapters.and_more());
    }
    if !report.packs.rows.is_empty() {
        document.heading(2, "Levels");
        let rows = report.packs.rows.iter().map(|pack| {
            let stars = format!("{} of {}", pack.stars, pack.most);
            vec![pack.title.clone(), stars]
        });
        document.table(&["pack", "stars"], rows);
        more(document, report.packs.and_more());
    }
}
