//! How the truth is told.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::play::ClassPlay;
use super::shown::ClassReveal;
use super::view::{Text, teams};
use crate::class::Vote;
use crate::quiz::{Illustration, Question, Response, letter};
use crate::widgets::hit::Watch;
use crate::widgets::{Lines, Look, Role, SplitLayout, draw_question};

/// Draws the hit; gives the truth and why it is true.
pub(super) fn draw<'a>(
    play: &'a ClassPlay,
    question: &'a Question,
    shown: &'a ClassReveal,
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
) -> Text<'a> {
    let watch = shown.reveal.watch();
    let layout = match question.picture {
        Illustration::Nothing if watch.is_none() => SplitLayout::text_alone(area),
        _ => SplitLayout::square(area),
    };
    let title = watch.map_or_else(|| question.family.name().into(), Watch::slowed_title);
    let aside = match shown.reveal.is_telling() {
        true => "watch",
        false => "and why",
    };
    layout.draw(buf, look, &title, aside);
    match watch {
        Some(watch) => watch.picture(layout.picture).draw(buf, look),
        None => draw_question(layout.picture, buf, look, question, None),
    }
    let write = move |lines: &mut Lines| write(play, question, shown, lines);
    (layout.panel, Box::new(write))
}

fn write(play: &ClassPlay, question: &Question, shown: &ClassReveal, lines: &mut Lines) {
    if shown.reveal.is_telling() {
        lines.paragraph(&question.text, Role::Dim);
        if let Some(watch) = shown.reveal.watch() {
            lines.gap();
            watch.write_telling(lines);
        }
        return;
    }
    let truth = question.form.truth();
    let mut words = question.form.words(&truth);
    if let Response::Choice(i) = truth {
        words = format!("{}: {words}", letter(i));
    }
    lines.paragraph(&words, Role::Title);
    lines.gap();
    for (name, vote) in [
        ("right at first", Vote::First),
        ("after talking", Vote::Second),
    ] {
        let grades = play.round.grades(play.number(), vote);
        let right = grades.iter().filter(|grade| grade.right).count();
        let right = format!("{right} of {}", grades.len());
        lines.pair(name, &right, Role::Text, Role::Title);
    }
    if let Some((name, count)) = &shown.held {
        lines.gap();
        let words = format!("{}: {name}.", teams(*count));
        lines.paragraph(&words, Role::Title);
    }
    lines.gap();
    lines.paragraph(&shown.why, Role::Text);
}
