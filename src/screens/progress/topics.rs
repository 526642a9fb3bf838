//! How each topic stands.

use super::words::{brief, degrees, padded, percent};
use crate::lessons::Book;
use crate::messages::History;
use crate::progress::{Due, LESSON, Mastery, TopicStanding, reviews, topics};
use crate::quiz::Topic;
use crate::widgets::bar::bar;
use crate::widgets::flow::Run;
use crate::widgets::{Lines, Role, Words, text};

/// Columns of a topic's name.
const NAME: usize = 26;
/// Columns of a row with all its figures.
const ROW: u16 = 46;
/// Columns of the bar, where there is room for it.
const BAR: u16 = 20;
/// How many names are listed.
const LISTED: usize = 6;

/// A row a topic, or two where the place is narrow.
pub(super) fn table(history: &History, book: &Book, lines: &mut Lines) {
    let wide = lines.width() >= ROW;
    let charted = lines.width() >= ROW + BAR + 3;
    if wide {
        // The sign for degrees may be a word.
        let off = lines.charset().text("off °").into_owned();
        let head = format!("  {:NAME$}{:>4}{:>6}{off:>8}", "", "of", "right");
        let chart = if charted { "   lately" } else { "" };
        let recorded = |charset| {
            let cells = ["of", "right", "off °"].map(|it| Run::new(it, Role::Dim).spelt(charset));
            Words::Columns {
                name: Run::new("", Role::Dim),
                values: cells.into(),
            }
        };
        lines.written_as(recorded, |lines| lines.line(&(head + chart), Role::Dim));
    }
    for topic in topics_of_the_quiz(history) {
        let mark = topic.mastery().mark();
        let role = match topic.mastery() {
            Mastery::Solid => Role::Good,
            _ => Role::Text,
        };
        let count = topic.all.attempts;
        let right = percent(topic.all.share_right());
        let off = topic.all.mean_error_deg();
        if wide {
            let off = off.map_or("-".into(), |off| format!("{off:.1}"));
            let name = padded(&brief(&topic.name, NAME), NAME);
            let share = topic.lately.share_right().unwrap_or(0.0);
            let chart = if charted {
                format!("   {}", bar(share, BAR, lines.charset()))
            } else {
                String::new()
            };
            let row = format!("{mark} {name}{count:>4}{right:>6}{off:>8}{chart}");
            let cells = [count.to_string(), right, off];
            let recorded = |charset| Words::Columns {
                name: Run::new(format!("{mark} {}", topic.name), role).spelt(charset),
                values: cells.map(|it| Run::new(it, role).spelt(charset)).into(),
            };
            lines.written_as(recorded, |lines| lines.line(&row, role));
        } else {
            let room = usize::from(lines.width()).saturating_sub(2);
            lines.line(&format!("{mark} {}", brief(&topic.name, room)), role);
            let figures = format!("  {count}: {right} right, {} off", degrees(off));
            lines.line(&figures, Role::Dim);
        }
    }
    lines.gap();
    lines.paragraph(&Mastery::legend(), Role::Dim);
    chapters(book, lines);
}

/// What was asked by the quiz; the chapters are told of by their own measure.
fn topics_of_the_quiz(history: &History) -> Vec<TopicStanding> {
    topics(history.attempts.iter().filter(|it| it.family != LESSON))
}

/// The chapters that were opened, as they stand in Learn.
fn chapters(book: &Book, lines: &mut Lines) {
    let chapters = book.library().chapters.iter();
    let opened: Vec<_> = chapters
        .filter_map(|chapter| Some((chapter, book.mark(&chapter.id)?)))
        .collect();
    if opened.is_empty() {
        return;
    }
    lines.gap();
    let done = format!("{} done", book.done());
    lines.pair("Chapters", &done, Role::Title, Role::Dim);
    let room = usize::from(lines.width());
    for (chapter, mark) in opened {
        let standing = mark.words(chapter);
        let title = format!("{:>2} {}", chapter.number, chapter.title);
        if text::width(&title) + text::width(&standing) + 4 <= room {
            lines.pair(&title, &standing, Role::Text, Role::Dim);
        } else {
            lines.line(&brief(&title, room), Role::Text);
            lines.line(&format!("   {standing}"), Role::Dim);
        }
    }
}

/// How many topics are solid; what is due now, and what comes next.
pub(super) fn panel(history: &History, lines: &mut Lines) {
    let solid = topics_of_the_quiz(history)
        .iter()
        .filter(|topic| topic.mastery() == Mastery::Solid)
        .count();
    if solid > 0 {
        lines.pair("solid", &solid.to_string(), Role::Dim, Role::Good);
        lines.gap();
    }
    let Some(today) = history.calendar.today() else {
        lines.paragraph(
            "What you know may rest for a while; what you missed comes back soon. Here it \
             will say when.",
            Role::Text,
        );
        return;
    };
    let due = Due::of(&history.attempts, &history.calendar);
    if due.now.is_empty() {
        lines.line("nothing due", Role::Title);
    } else {
        lines.line(&format!("{} due", due.now.len()), Role::Title);
        listed(due.now.iter().map(Topic::name).collect(), lines);
    }
    if let Some((topic, when)) = due.next {
        lines.gap();
        lines.line(&when, Role::Title);
        listed(vec![topic.name()], lines);
    }
    let chapters: Vec<String> = reviews(&history.attempts, &history.calendar)
        .into_iter()
        .filter(|review| review.family == LESSON && review.is_due(today))
        .map(|review| review.topic)
        .collect();
    if !chapters.is_empty() {
        lines.gap();
        lines.line("chapters to look at again", Role::Title);
        listed(chapters, lines);
    }
    lines.gap();
    lines.paragraph(
        "Coming back after a rest feels harder, and is what makes it stay.",
        Role::Dim,
    );
}

/// The first of these, and how many more there are.
fn listed(names: Vec<String>, lines: &mut Lines) {
    let room = usize::from(lines.width()).saturating_sub(2);
    let more = names.len().saturating_sub(LISTED);
    for name in names.into_iter().take(LISTED) {
        lines.line(&format!(" {}", brief(&name, room)), Role::Text);
    }
    if more > 0 {
        lines.line(&format!(" and {more} more"), Role::Dim);
    }
}
