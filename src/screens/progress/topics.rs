//! The state of each topic.

use super::ProgressAction;
use crate::lessons::Book;
use crate::messages::History;
use crate::progress::words::percent;
use crate::progress::{Due, LESSON, Mastery, TopicStanding, reviews, topics};
use crate::quiz::Topic;
use crate::widgets::bar::bar;
use crate::widgets::panel::{Panel, TableColumn, TableRow};
use crate::widgets::{Look, Role, text};

/// The width of a topic's name, in columns.
const NAME: u16 = 26;
const BAR: u16 = 20;
/// The largest number of names in a list.
const LISTED: usize = 6;

/// One row per topic, with the last answers as a bar if there is room.
pub(super) fn table(
    history: &History,
    book: &Book,
    look: &Look,
    panel: &mut Panel<ProgressAction>,
) {
    let columns = vec![
        TableColumn::words("", 2),
        TableColumn::words("", NAME),
        TableColumn::numbers("of", 4),
        TableColumn::numbers("right", 6).from(38),
        TableColumn::numbers("off °", 8).from(46),
        TableColumn {
            drawn: true,
            ..TableColumn::words("lately", BAR).from(77)
        },
    ];
    let rows = topics_of_the_quiz(history).into_iter().map(|topic| {
        let off = topic.all.mean_error_deg();
        let lately = topic.lately.share_right().unwrap_or(0.0);
        let cells = vec![
            topic.mastery().mark().into(),
            text::clipped(&topic.name, NAME.into()),
            topic.all.attempts.to_string(),
            percent(topic.all.share_right()),
            off.map_or("-".into(), |off| format!("{off:.1}")),
            bar(lately, BAR, look.charset),
        ];
        let role = match topic.mastery() {
            Mastery::Solid => Role::Good,
            _ => Role::Text,
        };
        TableRow::of(cells, role)
    });
    panel.table(columns, rows.collect(), None);
    panel.gap();
    panel.paragraph(Mastery::legend(), Role::Dim);
    chapters(book, panel);
}

/// The topics of the quiz only; the state of chapters is shown separately.
fn topics_of_the_quiz(history: &History) -> Vec<TopicStanding> {
    topics(history.attempts.iter().filter(|it| it.family != LESSON))
}

/// The chapters that the player has opened, with their state in Learn.
fn chapters(book: &Book, panel: &mut Panel<ProgressAction>) {
    let chapters = book.library().chapters.iter();
    let opened = chapters.filter_map(|chapter| Some((chapter, book.mark(&chapter.id)?)));
    let opened: Vec<_> = opened.collect();
    if opened.is_empty() {
        return;
    }
    panel.gap();
    let done = format!("{} done", book.done());
    panel.pair(("Chapters", Role::Title), (done, Role::Dim));
    for (chapter, mark) in opened {
        let title = format!("{} {}", chapter.number, chapter.title);
        panel.pair((title, Role::Text), (mark.words(chapter), Role::Dim));
    }
}

/// Writes the number of solid topics, the topics that are due now, the one due next, and the
/// chapters to look at again.
pub(super) fn panel(history: &History, panel: &mut Panel<ProgressAction>) {
    let topics = topics_of_the_quiz(history).into_iter();
    let solid = topics.filter(|it| it.mastery() == Mastery::Solid).count();
    if solid > 0 {
        panel.coloured_fact("solid", solid.to_string(), Role::Good);
        panel.gap();
    }
    let Some(today) = history.calendar.today() else {
        let text = "What you know comes back after a while; what you missed comes back soon. The \
                    dates will appear here.";
        return panel.paragraph(text, Role::Text);
    };
    let due = Due::of(&history.attempts, &history.calendar);
    if due.now.is_empty() {
        panel.heading("nothing due");
    } else {
        panel.heading(format!("{} due", due.now.len()));
        listed(due.now.iter().map(Topic::name).collect(), panel);
    }
    if let Some((topic, when)) = due.next {
        panel.gap();
        panel.heading(when);
        listed(vec![topic.name()], panel);
    }
    let mut reviews = reviews(&history.attempts, &history.calendar);
    reviews.retain(|review| review.family == LESSON && review.is_due(today));
    let chapters: Vec<String> = reviews.into_iter().map(|it| it.topic).collect();
    if !chapters.is_empty() {
        panel.gap();
        panel.heading("chapters to look at again");
        listed(chapters, panel);
    }
    panel.gap();
    let text = "Coming back after a rest feels harder, but it helps you remember.";
    panel.paragraph(text, Role::Dim);
}

/// Lists the first few of these names, and how many more there are.
fn listed(names: Vec<String>, panel: &mut Panel<ProgressAction>) {
    let more = names.len().saturating_sub(LISTED);
    for name in names.into_iter().take(LISTED) {
        panel.item(name, Role::Text);
    }
    if more > 0 {
        panel.line(format!("and {more} more"), Role::Dim);
    }
}
