//! How the quiz looks.

use ratatui::buffer::Buffer;
use ratatui::layout::{Margin, Rect};

use super::{AnsweredQuestion, Quiz, QuizPhase, panel, summary};
use crate::quiz::{CourseKind, Form, Illustration, Question};
use crate::screens::Context;
use crate::widgets::input::ListView;
use crate::widgets::panels::draw_panel;
use crate::widgets::{Lines, Look, Room, SplitLayout, areas, draw_question, rehearsed};

/// Columns of the look back at most, with its frame.
const WIDEST: u16 = 108;

/// The frame of the look back.
fn summary_frame(area: Rect) -> Rect {
    areas::middle(area, WIDEST)
}

/// Where picture and panel are: the panel alone for what is asked in words.
pub(super) fn layout(quiz: &Quiz, room: Room) -> SplitLayout {
    match question(quiz).map(|question| &question.picture) {
        Some(Illustration::Nothing) => SplitLayout::card(room),
        _ => SplitLayout::new(room),
    }
}

/// The question at hand.
fn question(quiz: &Quiz) -> Option<&Question> {
    match &quiz.phase {
        QuizPhase::Asked(asked) => Some(&asked.question),
        QuizPhase::Watch(watched) => Some(&watched.question),
        QuizPhase::Summary(_) => None,
    }
}

/// Where the text of the phase at hand is.
pub(super) fn text_area(quiz: &Quiz, room: Room) -> Rect {
    match quiz.phase {
        QuizPhase::Summary(_) => summary_frame(room.area).inner(Margin::new(1, 1)),
        _ => layout(quiz, room).panel,
    }
}

/// Writes the text of the phase at hand.
pub(super) fn write(quiz: &Quiz, lines: &mut Lines, cx: &Context) {
    match &quiz.phase {
        QuizPhase::Asked(asked) => match asked.sure {
            None => panel::asked(asked, lines),
            Some(chosen) => panel::confidence(asked, chosen, quiz.tells_at_end(), lines),
        },
        QuizPhase::Watch(watched) if !watched.reveal.is_telling() => {
            panel::told(watched, lines, &cx.book);
        }
        QuizPhase::Watch(watched) => panel::untold(watched, lines),
        QuizPhase::Summary(list) => {
            summary::write(quiz, list.chosen(quiz.answers.len()), &cx.book, lines);
        }
    }
}

/// Draws the quiz.
pub(super) fn draw(quiz: &Quiz, area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = layout(quiz, cx.room());
    match &quiz.phase {
        QuizPhase::Asked(asked) => {
            let title = asked.question.family.name();
            draw_frames(&layout, buf, &look, title, "say it first");
            draw_question(
                layout.picture,
                buf,
                &look,
                &asked.question,
                Some(&asked.input),
            );
        }
        QuizPhase::Watch(watched) => {
            let side = if watched.reveal.is_telling() {
                "watch"
            } else {
                "and why"
            };
            draw_frames(&layout, buf, &look, &title(watched), side);
            match watched.reveal.watch() {
                Some(watch) => watch.picture(layout.picture).draw(buf, &look),
                None => draw_question(layout.picture, buf, &look, &watched.question, None),
            }
        }
        QuizPhase::Summary(_) => {
            let frame = summary_frame(area);
            let title = match quiz.round.course().kind {
                CourseKind::FindOut => "what you seem to believe",
                _ => "your round",
            };
            draw_panel(buf, frame, title, look.charset, &look.theme);
        }
    }
    let text = text_area(quiz, cx.room());
    quiz.scroll
        .draw(text, buf, look, |lines| write(quiz, lines, cx));
}

/// The frames with their titles; where there is no picture its title goes to the text.
fn draw_frames(layout: &SplitLayout, buf: &mut Buffer, look: &Look, picture: &str, panel: &str) {
    let panel = if layout.picture.is_empty() {
        picture
    } else {
        panel
    };
    layout.draw(buf, look, picture, panel);
}

/// The line of the look back at a cell.
pub(super) fn line_at(quiz: &Quiz, cx: &Context, cell: (u16, u16)) -> Option<usize> {
    let (text, look) = (text_area(quiz, cx.room()), cx.settings.look());
    let row = ListView::row_at(text, cell)?;
    let scrolled = quiz.scroll.rows(text, look, |lines| write(quiz, lines, cx));
    let first = usize::from(first_line(quiz, text, cx));
    let line = (row + usize::from(scrolled)).checked_sub(first)?;
    (line < quiz.answers.len()).then_some(line)
}

/// Row of the first line of the look back.
pub(super) fn first_line(quiz: &Quiz, text: Rect, cx: &Context) -> u16 {
    let look = cx.settings.look();
    rehearsed(text, look, |lines| summary::write(quiz, 0, &cx.book, lines))
}

fn title(watched: &AnsweredQuestion) -> String {
    let Some(watch) = watched.reveal.watch() else {
        return watched.question.family.name().into();
    };
    if let Form::Shot(aim) = &watched.question.form
        && watched.reveal.is_revealed()
    {
        return watch.title(match watch.collision().offset == aim.offset {
            true => "the shot that does it",
            false => "your shot",
        });
    }
    watch.slowed_title()
}
