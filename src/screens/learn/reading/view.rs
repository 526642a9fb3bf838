//! How a page looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Reading, panel};
use crate::screens::Context;
use crate::widgets::{Beside, Lines, Role};

/// Where figure and text are.
pub(super) fn layout(reading: &Reading, area: Rect) -> Beside {
    let mut layout = Beside::square(area);
    if reading.notice.is_some() {
        // It has the last row of the text to itself.
        layout.panel.height = layout.panel.height.saturating_sub(1);
    }
    layout
}

/// Draws the page.
pub(super) fn draw(reading: &Reading, area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = layout(reading, area);
    let figure_title = reading
        .figure
        .as_ref()
        .map_or(String::new(), super::Shown::title);
    let page_title = reading.page().map_or("", |page| &page.title);
    let marked = |title: &str, here: bool| {
        let mark = if here && reading.figure.is_some() {
            "> "
        } else {
            ""
        };
        format!("{mark}{title}")
    };
    let picture = marked(&figure_title, reading.on_figure);
    let text = marked(page_title, !reading.on_figure);
    layout.draw(buf, &look, &picture, &text);
    if let Some(figure) = &reading.figure {
        let question = reading
            .question
            .as_ref()
            .filter(|_| reading.answer.is_none());
        let rays = question.and_then(super::Question::rays);
        figure.draw(layout.picture, buf, &look, rays);
    }
    reading.scroll.draw(layout.panel, buf, look, |lines| {
        panel::write(reading, lines)
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
