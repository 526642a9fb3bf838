//! How a page looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Reading, panel};
use crate::screens::Context;
use crate::widgets::{Lines, Role, Room, SplitLayout};

/// Where figure and text are.
pub(super) fn layout(reading: &Reading, room: Room) -> SplitLayout {
    let mut layout = match reading.figure {
        Some(_) => SplitLayout::square(room),
        None => SplitLayout::text_alone(room),
    };
    if reading.notice.is_some() {
        // It has the last row of the text to itself.
        layout.panel.height = layout.panel.height.saturating_sub(1);
    }
    layout
}

/// Draws the page.
pub(super) fn draw(reading: &Reading, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = layout(reading, cx.room());
    if !reading.is_open {
        layout.draw(buf, &look, "", &reading.chapter.title);
        return Lines::new(layout.panel, buf, look).line("Looking …", Role::Dim);
    }
    let question = reading.question.as_ref();
    let question = question.filter(|_| reading.answer.is_none());
    let rays = question.and_then(super::CheckpointInput::rays);
    let figure_title = match &reading.figure {
        Some(_) if rays.is_some() => "where will they go?".into(),
        Some(figure) => figure.title(),
        None => String::new(),
    };
    let page_title = reading.page().map_or("", |page| &page.title);
    let marked = |title: &str, here: bool| match here && reading.figure.is_some() {
        true => format!("> {title}"),
        false => title.to_owned(),
    };
    let picture = marked(&figure_title, reading.on_figure);
    let text = marked(page_title, !reading.on_figure);
    layout.draw(buf, &look, &picture, &text);
    if let Some(figure) = &reading.figure {
        figure.draw(layout.picture, buf, &look, rays);
    }
    reading.scroll.draw(layout.panel, buf, look, |lines| {
        panel::write(reading, lines);
    });
    if let Some(notice) = &reading.notice {
        let row = Rect {
            y: layout.panel.bottom(),
            height: 1,
            ..layout.panel
        };
        Lines::new(row, buf, look).line(notice, Role::Key);
    }
}
