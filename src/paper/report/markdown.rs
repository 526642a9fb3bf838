//! The report as Markdown.

use super::Report;
use super::rows::{ReportCell, ReportSection, of};
use crate::numbers::counted;
use crate::paper::Markdown;
use crate::progress::ends_deg;
use crate::progress::words::{degrees, percent};

impl Report<'_> {
    /// The report as a Markdown document. Its pictures are in `folder`, a path relative to the
    /// document.
    pub fn markdown(&self, folder: &str) -> String {
        let mut document = Markdown::new();
        document.heading(1, &self.name);
        document.paragraph("carrom · glancing collisions");
        if self.attempts.is_empty() {
            document.paragraph("There is nothing here yet: every game starts with a clean board.");
        } else {
            document.paragraph(&format!("{}.", self.span()));
            figures(self, &mut document);
            for picture in self.pictures() {
                let place = format!("{folder}/{}.svg", picture.name);
                document.heading(2, picture.title);
                document.picture(picture.svg.words(), &place);
                document.paragraph(&picture.legend);
            }
            tables(self, &mut document);
        }
        document.heading(2, "What next").paragraph(&self.next);
        document.rule().paragraph(&self.origin());
        document.text().to_owned()
    }
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
    if let Some((first, last)) = ends_deg(report.attempts) {
        row("mean error of the first ten", degrees(Some(first)));
        row("mean error of the last ten", degrees(Some(last)));
    }
    row("topics solid", report.solid.to_string());
    row("chapters done", of(report.done));
    row("stars", of(report.stars));
    document.table(&["overall", ""], rows);
}

fn tables(report: &Report, document: &mut Markdown) {
    table(&report.topics, document);
    if report.beliefs.rows.is_empty() {
        let beliefs = &report.beliefs;
        document.heading(2, beliefs.title).paragraph(beliefs.none);
    }
    table(&report.beliefs, document);
    if !report.seen.is_empty() {
        document.heading(2, "Observations");
        document.paragraph(&report.seen.join(" "));
    }
    table(&report.chapters, document);
    table(&report.packs, document);
}

/// A table under its title; nothing if the table has no rows.
fn table(section: &ReportSection, document: &mut Markdown) {
    if section.rows.is_empty() {
        return;
    }
    let row = |row: &Vec<ReportCell>| row.iter().map(|cell| cell.text().to_owned()).collect();
    document.heading(2, section.title);
    document.table(section.heads, section.rows.iter().map(row));
    for note in &section.notes {
        document.paragraph(note);
    }
}
