//! How the quiz looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Phase, Quiz, Watched, panel, summary};
use crate::physics::Frame;
use crate::quiz::{Form, Illustration, Question};
use crate::screens::Context;
use crate::widgets::panel::draw_panel;
use crate::widgets::{Lines, Look, Role, SplitLayout, draw_question};

/// Columns of the look back at most, with its frame.
const WIDEST: u16 = 108;

/// The frame of the look back.
fn summary_frame(area: Rect) -> Rect {
    let width = area.width.min(WIDEST);
    Rect {
        x: area.x + (area.width - width) / 2,
        width,
        ..area
    }
}

/// Where picture and panel are: the panel alone for what is asked in words.
pub(super) fn layout(quiz: &Quiz, area: Rect) -> SplitLayout {
    match question(quiz).map(|question| &question.picture) {
        Some(Illustration::Nothing) => SplitLayout::card(area),
        _ => SplitLayout::new(area),
    }
}

/// The question at hand.
fn question(quiz: &Quiz) -> Option<&Question> {
    match &quiz.phase {
        Phase::Asked(asked) | Phase::Confidence(asked, _) => Some(&asked.question),
        Phase::Watch(watched) => Some(&watched.question),
        Phase::Summary(_) => None,
    }
}

/// Where the text of the phase at hand is.
pub(super) fn text_area(quiz: &Quiz, area: Rect, look: Look) -> Rect {
    let panel = match quiz.phase {
        Phase::Summary(_) => {
            let frame = summary_frame(area);
            Rect::new(
                frame.x + 1,
                frame.y + 1,
                frame.width.saturating_sub(2),
                frame.height.saturating_sub(2),
            )
        }
        _ => layout(quiz, area).panel,
    };
    // The notice has the top rows to itself.
    let notice = match quiz.leaving {
        true => {
            let mut scratch = Buffer::empty(panel);
            let lines = Lines::new(panel, &mut scratch, look);
            lines.rows_of(&quiz.parting()).min(panel.height)
        }
        false => 0,
    };
    Rect {
        y: panel.y + notice,
        height: panel.height - notice,
        ..panel
    }
}

/// Writes the text of the phase at hand.
pub(super) fn write(quiz: &Quiz, lines: &mut Lines, look: Look) {
    match &quiz.phase {
        Phase::Asked(asked) => panel::asked(asked, lines),
        Phase::Confidence(asked, chosen) => {
            panel::confidence(asked, *chosen, quiz.tells_at_end(), lines);
        }
        Phase::Watch(watched) if watched.telling.is_told() => {
            panel::told(watched, lines, look.charset);
        }
        Phase::Watch(watched) => panel::untold(watched, lines),
        Phase::Summary(at) => {
            summary::write(quiz, *at, lines);
        }
    }
}

/// Draws the quiz.
pub(super) fn draw(quiz: &Quiz, area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = layout(quiz, area);
    match &quiz.phase {
        Phase::Asked(asked) | Phase::Confidence(asked, _) => {
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
        Phase::Watch(watched) => {
            let side = if watched.telling.is_told() {
                "and why"
            } else {
                "watch"
            };
            draw_frames(&layout, buf, &look, &title(watched), side);
            match watched.telling.watch() {
                Some(watch) => watch.picture(layout.picture).draw(buf, &look),
                None => draw_question(layout.picture, buf, &look, &watched.question, None),
            }
        }
        Phase::Summary(_) => {
            let frame = summary_frame(area);
            draw_panel(buf, frame, "your round", look.charset, &look.theme);
        }
    }
    let text = text_area(quiz, area, look);
    if quiz.leaving {
        Lines::new(layout.panel, buf, look).paragraph(&quiz.parting(), Role::Warn);
    }
    quiz.scroll
        .draw(text, buf, look, |lines| write(quiz, lines, look));
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
pub(super) fn line_at(
    quiz: &Quiz,
    at: usize,
    area: Rect,
    look: Look,
    cell: (u16, u16),
) -> Option<usize> {
    let text = text_area(quiz, area, look);
    if !text.contains(cell.into()) {
        return None;
    }
    let scrolled = quiz
        .scroll
        .rows(text, look, |lines| write(quiz, lines, look));
    let row = cell.1 - text.y + scrolled;
    let line = usize::from(row.checked_sub(first_line(quiz, at, text, look))?);
    (line < quiz.answers.len()).then_some(line)
}

/// Row of the first line of the look back.
pub(super) fn first_line(quiz: &Quiz, at: usize, text: Rect, look: Look) -> u16 {
    let mut scratch = Buffer::empty(text);
    summary::write(quiz, at, &mut Lines::new(text, &mut scratch, look))
}

fn title(watched: &Watched) -> String {
    let Some(watch) = watched.telling.watch() else {
        return watched.question.family.name().into();
    };
    if let Form::Shot(aim) = &watched.question.form
        && watched.telling.is_told()
        && watch.frame() == Frame::Laboratory
    {
        let does_it = watch.collision().offset == aim.offset;
        return if does_it {
            "the shot that does it"
        } else {
            "your shot"
        }
        .into();
    }
    watch.title()
}
