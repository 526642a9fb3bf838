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

use super::active_game::{ActiveGame, TablePhase};
use super::game_history::Past;
use crate::game::Ruling;
use crate::screens::Context;
use crate::widgets::panel::written;
use crate::widgets::{Lines, Role};

/// Draws what belongs to what is being done.
pub(super) fn draw(active: &ActiveGame, area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    active
        .scroll
        .draw(area, buf, look, |lines| write(active, lines));
}

/// Writes what belongs to what is being done.
pub(super) fn write(active: &ActiveGame, lines: &mut Lines) {
    if let Some(trouble) = &active.keeping.trouble {
        lines.paragraph(trouble, Role::Warn);
        lines.gap();
    }
    match &active.phase {
        TablePhase::Aim => aim::draw(active, lines),
        TablePhase::Show(shown) => aim::show(active, shown, lines),
        TablePhase::Call(calling) => call::draw(calling, lines),
        TablePhase::Watch(replay) if replay.player.list().is_some() => stroke::list(replay, lines),
        TablePhase::Watch(replay) => match replay.player.zoom() {
            Some(watch) => {
                written::<()>(lines, |panel| impact::write(replay, watch, panel));
            }
            None => stroke::draw(active, replay, lines),
        },
        TablePhase::Arrange(arrange) => arrange_help(active, arrange.held.is_some(), lines),
        TablePhase::Over => over::draw(active, lines),
    }
}

/// What just has to be said.
fn notice(active: &ActiveGame, lines: &mut Lines) {
    if let Some(notice) = &active.notice {
        lines.paragraph(notice, Role::Warn);
    }
}

/// What the referee announced of a move, with the numbers of the laws.
fn rulings(past: &Past, lines: &mut Lines) {
    for Ruling { law, text, .. } in &past.rulings {
        let law = law.map_or(String::new(), |law| format!(" (law {law})"));
        lines.paragraph(&format!("{text}{law}"), Role::Text);
    }
    lines.gap();
}

fn arrange_help(active: &ActiveGame, holding: bool, lines: &mut Lines) {
    let what = if holding {
        "Move the coin and put it down with Space."
    } else {
        "Put the hand over a coin and pick it up with Space, or drag it with the mouse."
    };
    lines.paragraph(what, Role::Text);
    lines.gap();
    notice(active, lines);
    lines.gap();
    score::pieces(active, lines);
    lines.gap();
    lines.paragraph("p: done", Role::Key);
}
