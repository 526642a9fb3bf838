//! The report as HTML.

use maud::{Markup, Render, html};

use super::rows::{ChapterRow, Cut, PackRow, of};
use super::{Report, ReportPicture};
use crate::numbers::counted;
use crate::paper::{Paper, clean, html_page};
use crate::progress::words::{degrees, percent};
use crate::progress::{LATELY, Mastery, TopicStanding, Trend};
use crate::quiz::NAMED_ODDS;

/// The maximum number of columns in a topic's name.
const TOPIC: usize = 40;

pub(super) fn document(reports: &[Report]) -> String {
    let whose = match reports {
        [one] => &one.name,
        _ => "carrom",
    };
    let title = format!("{whose}: glancing collisions");
    let sheets = reports.iter().map(sheet);
    html_page(&title, include_str!("report.css"), Paper::A4, sheets)
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
            (next(report))
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
            @match report.ends() {
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

/// Two columns: the answers on the left, the confidence and the chapters on the right.
fn columns(report: &Report) -> Markup {
    let pictures = report.pictures();
    let picture = |name: &str| {
        let picture = pictures.iter().find(|it| it.name == name);
        html! { @if let Some(picture) = picture { (figure(picture)) } }
    };
    html! {
        div.columns {
            div {
                (picture("errors"))
                section { (listed("Topics", &report.topics, "No quiz questions yet.", topics)) }
                section { (beliefs(report)) }
                @if !report.seen.is_empty() {
                    section { h2 { "Observations" } p { (report.seen.join(" ")) } }
                }
                section { (listed("Levels", &report.packs, "No stars yet.", packs)) }
            }
            div {
                (picture("calibration"))
                (picture("calibration-over-time"))
                section.chapters {
                    (listed("Chapters", &report.chapters, "None started yet.", chapters))
                }
            }
        }
    }
}

fn figure(picture: &ReportPicture) -> Markup {
    html! {
        figure {
            h2 { (picture.title) }
            (picture.svg.render())
            figcaption.dim { (picture.legend) }
        }
    }
}

fn more<T>(cut: &Cut<T>) -> Markup {
    html! { @if let Some(more) = cut.and_more() { p.dim { (more) } } }
}

/// A title above a table of rows, or above a sentence if there are no rows.
fn listed<T>(title: &str, cut: &Cut<T>, none: &str, table: fn(&[T]) -> Markup) -> Markup {
    html! {
        h2 { (title) }
        @if cut.rows.is_empty() { p.dim { (none) } }
        @else { (table(&cut.rows)) (more(cut)) }
    }
}

/// A share as a bar that is also clear in black and white.
fn bar(share: f64) -> Markup {
    let width = format!("width: {:.0}%", 100.0 * share.clamp(0.0, 1.0));
    html! { span.bar { span style=(width) {} } }
}

fn topics(topics: &[TopicStanding]) -> Markup {
    html! {
        table {
            thead { tr {
                th { "topic" } th { "state" } th.n { "right" } th { "of the last five" }
                th.n { "error" }
            } }
            tbody {
                @for topic in topics { tr {
                    td.name { (clean(&topic.name, TOPIC)) }
                    td {
                        @if topic.mastery() == Mastery::Solid { b { "solid" } }
                        @else { (topic.mastery().name()) }
                    }
                    td.n { (of((topic.all.right, topic.all.attempts))) }
                    td {
                        (bar(topic.lately.right as f64 / LATELY as f64))
                        (of((topic.lately.right, topic.lately.attempts)))
                    }
                    td.n { (degrees(topic.all.mean_error_deg())) }
                } }
            }
        }
    }
}

fn beliefs(report: &Report) -> Markup {
    html! {
        h2 { "Misconceptions" }
        @if report.beliefs.rows.is_empty() {
            p.dim { "No known misconception stands out in the answers." }
        } @else {
            table {
                thead { tr { th { "what wrong answers had in common" } th.n { "before" } th.n { "since" } th { "" } } }
                tbody {
                    @for belief in &report.beliefs.rows { tr {
                        td { (belief.misconception.name()) }
                        td.n { (belief.before.to_string()) }
                        td.n { (belief.since.to_string()) }
                        td { @match belief.trend() {
                            held @ (Trend::New | Trend::Held) => b { (held.name()) },
                            trend => (trend.name()),
                        } }
                    } }
                }
            }
            p.dim {
                @if let Some(more) = report.beliefs.and_more() { (more) ". " }
                "How many answers fitted the misconception, out of the questions that could have "
                "shown it: in the first half of the answers, and since. A misconception is listed "
                "once it explains the answers " (NAMED_ODDS)
                " times better than guessing does."
            }
        }
    }
}

fn chapters(chapters: &[ChapterRow]) -> Markup {
    html! {
        table {
            thead { tr { th {} th.n { "read" } th.n { "right" } } }
            tbody {
                @for chapter in chapters { tr {
                    td.name { (chapter.title) }
                    td.n { (of(chapter.read)) }
                    td.n { (of(chapter.right)) }
                } }
            }
        }
    }
}

fn packs(packs: &[PackRow]) -> Markup {
    html! {
        div.packs {
            @for pack in packs { p.pack {
                span { (pack.title) }
                span.n { "★ " (of((pack.stars, pack.most))) }
            } }
        }
    }
}

fn next(report: &Report) -> Markup {
    html! { section.next { h2 { "What next" } p { (report.next()) } } }
}
