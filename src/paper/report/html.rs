//! The report as HTML.

use maud::{Markup, html};

use super::rows::{ReportCell, ReportSection, of};
use super::{Report, ReportPicture};
use crate::numbers::counted;
use crate::paper::{Paper, clean, html_page};
use crate::progress::ends_deg;
use crate::progress::words::{degrees, percent};

/// The maximum length of a name in a table, where a wide letter counts twice: tables stand side by
/// side, so there is little room.
const NAME: usize = 40;

impl Report<'_> {
    /// These reports as one HTML document that contains its pictures, each on its own page.
    pub fn html(reports: &[Self]) -> String {
        let whose = match reports {
            [one] => &one.name,
            _ => "carrom",
        };
        let title = format!("{whose}: glancing collisions");
        let sheets = reports.iter().map(sheet);
        html_page(&title, include_str!("report.css"), Paper::A4, sheets)
    }
}

fn sheet(report: &Report) -> Markup {
    html! {
        div.report {
            (head(report))
            @if report.attempts.is_empty() {
                p.nothing {
                    "There is nothing here yet: every game starts with a clean board. After a \
                     round of the quiz, "
                    "this page shows how the answers come closer to the true values."
                }
            } @else {
                (figures(report))
                (columns(report))
            }
            section.next { h2 { "What next" } p { (report.next) } }
            footer { (report.origin()) }
        }
    }
}

fn head(report: &Report) -> Markup {
    html! {
        header {
            p.dim { "carrom · glancing collisions" }
            h1 { bdi { (report.name) } }
            @if !report.attempts.is_empty() { p { (report.span()) } }
        }
    }
}

/// The most important numbers.
fn figures(report: &Report) -> Markup {
    let figure = |value: String, name: &str| {
        html! { div { strong { (value) } span.dim { (name) } } }
    };
    let angles = counted(report.all.angles(), "angle");
    html! {
        div.figures {
            (figure(report.all.attempts.to_string(), "answered"))
            (figure(percent(report.all.share_right()), "right"))
            @match ends_deg(report.attempts) {
                Some((first, last)) => {
                    (figure(format!("{first:.1}° → {last:.1}°"), &format!("mean error, first and last ten of {angles}")))
                }
                None => {
                    @if let Some(error) = report.all.mean_error_deg() {
                        (figure(degrees(Some(error)), &format!("mean error of {angles}")))
                    }
                }
            }
            (figure(report.solid.to_string(), "topics solid"))
            (figure(of(report.done), "chapters done"))
            (figure(of(report.stars), "stars"))
        }
    }
}

/// Two columns: the answers and the levels on the left, confidence and chapters on the right.
fn columns(report: &Report) -> Markup {
    let pictures = report.pictures();
    let picture = |name: &str| {
        let picture = pictures.iter().find(|it| it.name == name);
        html! { @if let Some(picture) = picture { (figure(picture)) } }
    };
    let with_table = |it: &ReportSection| section(it, &table(it.heads, &it.rows));
    let chapters = table(&["", "read", "right"], &report.chapters.rows);
    html! {
        div.columns {
            div {
                (picture("errors"))
                section { (with_table(&report.topics)) }
                section { (with_table(&report.beliefs)) }
                @if !report.seen.is_empty() {
                    section { h2 { "Observations" } p { (report.seen.join(" ")) } }
                }
                section { (section(&report.packs, &packs(&report.packs.rows))) }
            }
            div {
                (picture("calibration"))
                (picture("calibration-over-time"))
                section.chapters { (section(&report.chapters, &chapters)) }
            }
        }
    }
}

fn figure(picture: &ReportPicture) -> Markup {
    html! {
        figure {
            h2 { (picture.title) }
            (picture.svg)
            figcaption.dim { (picture.legend) }
        }
    }
}

/// A title above a table, or above a sentence if the table has no rows.
fn section(section: &ReportSection, table: &Markup) -> Markup {
    html! {
        h2 { (section.title) }
        @if section.rows.is_empty() { p.dim { (section.none) } }
        @else {
            (table)
            @if !section.notes.is_empty() { p.dim { (section.notes.join(". ")) } }
        }
    }
}

fn table(heads: &[&str], rows: &[Vec<ReportCell>]) -> Markup {
    let columns = rows.first().into_iter().flatten();
    let class = |cell: &ReportCell| matches!(cell, ReportCell::Number(_)).then_some("n");
    html! {
        table {
            thead {
                tr {
                    @for (head, cell) in heads.iter().zip(columns) { th class=[class(cell)] { (head) } }
                }
            }
            tbody { @for row in rows { tr { @for cell in row { (data(cell)) } } } }
        }
    }
}

fn data(cell: &ReportCell) -> Markup {
    html! {
        @match cell {
            ReportCell::Name(text) => td.name { (clean(text, NAME)) },
            ReportCell::Text(text) => td { (text) },
            ReportCell::Strong(text) => td { b { (text) } },
            ReportCell::Number(text) => td.n { (text) },
            ReportCell::Share(share, text) => td { (bar(*share)) (text) },
        }
    }
}

/// A share as a bar that is also clear in black and white.
fn bar(share: f64) -> Markup {
    let width = format!("width: {:.0}%", 100.0 * share.clamp(0.0, 1.0));
    html! { span.bar { span style=(width) {} } }
}

fn packs(rows: &[Vec<ReportCell>]) -> Markup {
    html! {
        div.packs {
            @for row in rows {
                @if let [pack, stars] = &row[..] {
                    p.pack { span { (pack.text()) } span.n { "★ " (stars.text()) } }
                }
            }
        }
    }
}
