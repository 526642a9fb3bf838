//! The panel beside the board.

mod aim;
mod call;
mod impact;
mod over;
mod score;
mod stroke;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

pub(super) use stroke::impact_at;

use super::sitting::{Phase, Sitting};
use super::words;
use crate::screens::Context;
use crate::widgets::{Lines, Role};

/// Draws what belongs to what is being done.
pub(super) fn draw(sitting: &Sitting, area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    sitting
        .scroll
        .draw(area, buf, look, |lines| write(sitting, lines));
}

/// Writes what belongs to what is being done.
pub(super) fn write(sitting: &Sitting, lines: &mut Lines) {
    if let Some(trouble) = sitting.keeping.trouble() {
        lines.paragraph(trouble, Role::Warn);
        lines.gap();
    }
    if sitting.leaving {
        lines.paragraph("Leave this game?", Role::Warn);
        lines.gap();
        if sitting.keeping.is_safe() {
            let kept = "It is saved: on the page of a new game, s brings it back.";
            lines.paragraph(kept, Role::Text);
            lines.gap();
        }
        lines.paragraph("Esc or y: leave it. Any other key: play on.", Role::Key);
        return;
    }
    match &sitting.phase {
        Phase::Aim => aim::draw(sitting, lines),
        Phase::Think { .. } => thinking(sitting, lines),
        Phase::Call(calling) => call::draw(calling, lines),
        Phase::Watch(replay) if replay.chosen.is_some() => stroke::list(replay, lines),
        Phase::Watch(replay) => stroke::draw(sitting, replay, lines),
        Phase::Impact(zoom) => impact::draw(zoom, lines),
        Phase::Arrange(arrange) => arrange_help(sitting, arrange.held.is_some(), lines),
        Phase::Over => over::draw(sitting, lines),
    }
}

/// What just has to be said.
fn notice(sitting: &Sitting, lines: &mut Lines) {
    if let Some(notice) = &sitting.notice {
        lines.paragraph(notice, Role::Warn);
    }
}

fn thinking(sitting: &Sitting, lines: &mut Lines) {
    let name = sitting.options.seat_name(sitting.seat());
    let thinks = words::does(name, "thinks");
    lines.line(&format!("{} …", words::sentence(&thinks)), Role::Title);
    lines.gap();
    notice(sitting, lines);
    lines.gap();
    score::draw(sitting, lines);
}

fn arrange_help(sitting: &Sitting, holding: bool, lines: &mut Lines) {
    let what = if holding {
        "Move the coin and lay it down with Space."
    } else {
        "Put the hand over a coin and take it with Space, or drag it with the mouse."
    };
    lines.paragraph(what, Role::Text);
    lines.gap();
    notice(sitting, lines);
    lines.gap();
    score::pieces(sitting, lines);
    lines.gap();
    lines.paragraph("p: done", Role::Key);
}
