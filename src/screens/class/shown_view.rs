//! How the truth is told.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::heading::Heading;
use super::play::ClassPlay;
use super::shown::ClassReveal;
use super::view::{Text, teams};
use crate::class::{ClassRound, Vote};
use crate::quiz::{Question, Response, letter};
use crate::widgets::{Lines, Look, Role, SplitLayout, draw_question};

/// Rows of a body from which on there is a heading above the picture, too.
const HEADED_FROM: u16 = 34;

const HEADING: Heading<'static> = Heading::new(&["The shot"], "");

/// Where picture and panel are.
fn layout(question: &Question, shown: &ClassReveal, area: Rect, look: &Look) -> SplitLayout {
    let rest = if area.height >= HEADED_FROM {
        HEADING.rest(area, look)
    } else {
        area
    };
    let pictured =
        shown.telling.watch().is_some() || question.picture != crate::quiz::Illustration::Nothing;
    if pictured {
        SplitLayout::square(rest)
    } else {
        SplitLayout::text_alone(rest)
    }
}

/// Draws the hit.
pub(super) fn draw(
    play: &ClassPlay,
    shown: &ClassReveal,
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
) {
    let Some(question) = play.question() else {
        return;
    };
    if area.height >= HEADED_FROM {
        HEADING.draw(area, buf, look);
    }
    let layout = layout(question, shown, area, look);
    let title = match shown.telling.watch() {
        Some(watch) => watch.title(),
        None => question.family.name().into(),
    };
    let aside = if shown.telling.is_told() {
        "and why"
    } else {
        "watch"
    };
    layout.draw(buf, look, &title, aside);
    match shown.telling.watch() {
        Some(watch) => watch.picture(layout.picture).draw(buf, look),
        None => draw_question(layout.picture, buf, look, question, None),
    }
}

/// The truth and why it is true.
pub(super) fn text<'a>(
    play: &'a ClassPlay,
    shown: &'a ClassReveal,
    area: Rect,
    look: &Look,
) -> Text<'a> {
    let place = play
        .question()
        .map(|question| layout(question, shown, area, look).panel)
        .unwrap_or_default();
    let write = move |lines: &mut Lines| {
        if let Some(question) = play.question() {
            write(play, question, shown, lines);
        }
    };
    (place, Box::new(write))
}

fn write(play: &ClassPlay, question: &Question, shown: &ClassReveal, lines: &mut Lines) {
    if !shown.telling.is_told() {
        lines.paragraph(&question.text, Role::Dim);
        if let Some(watch) = shown.telling.watch() {
            lines.gap();
            lines.paragraph(watch.telling(), Role::Text);
        }
        return;
    }
    let truth = question.form.truth();
    let words = match truth {
        Response::Choice(i) => format!("{}: {}", letter(i), question.form.words(&truth)),
        _ => question.form.words(&truth),
    };
    lines.paragraph(&words, Role::Title);
    lines.gap();
    let number = play.number();
    let right = |vote| right(&play.round, number, vote);
    lines.pair(
        "right at first",
        &right(Vote::First),
        Role::Text,
        Role::Title,
    );
    lines.pair(
        "after talking",
        &right(Vote::Second),
        Role::Text,
        Role::Title,
    );
    if let Some((misconception, count)) = shown.held {
        lines.gap();
        let words = format!("{}: {}.", teams(count), misconception.name());
        lines.paragraph(&words, Role::Title);
    }
    lines.gap();
    lines.paragraph(&shown.why, Role::Text);
}

/// How many of the teams that voted were right: "2 of 3".
fn right(round: &ClassRound, question: usize, vote: Vote) -> String {
    let grades: Vec<_> = (0..round.teams().len())
        .filter_map(|team| {
            let ballot = round.ballot(question, team);
            let said = match vote {
                Vote::First => ballot.first,
                Vote::Second => ballot.counts(),
            };
            round.grade(question, said)
        })
        .collect();
    let count = grades.iter().filter(|grade| grade.right).count();
    format!("{count} of {}", grades.len())
}
