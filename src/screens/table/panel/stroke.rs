//! The panel while a stroke is watched: what the referee says, or its impacts.

use ratatui::layout::Rect;

use super::{notice, rulings, score};
use crate::game::Piece;
use crate::numbers::capital;
use crate::screens::table::active_game::ActiveGame;
use crate::screens::table::calls::Called;
use crate::screens::table::replay::StrokeReplay;
use crate::screens::table::words;
use crate::widgets::ink::token;
use crate::widgets::input::ListView;
use crate::widgets::panel::written;
use crate::widgets::panels::said_and_true;
use crate::widgets::{Lines, Role};

/// Columns from which on the list has room for names.
const ROOMY: u16 = 31;
/// Rows above the list of impacts.
const HEAD: usize = 2;

/// What came of the stroke, once it is over.
pub(super) fn draw(active: &ActiveGame, replay: &StrokeReplay, lines: &mut Lines) {
    let Some(past) = active.history.past(replay.number) else {
        return;
    };
    let (player, clock) = (&replay.player, replay.player.clock());
    let name = active.options.seat_name(past.before.seat());
    if !clock.is_over() {
        let speed = player.shot().start(0).velocity.length();
        lines.fact("struck by", name);
        lines.fact("at", &format!("{speed:.1} m/s"));
        let so_far = player.impacts().iter().filter(|it| it.time <= clock.time());
        lines.fact("impacts", &so_far.count().to_string());
        lines.gap();
        left(replay, lines);
        return;
    }
    rulings(past, lines);
    if let (Some(meant), Some(played)) = (&past.meant, &past.story) {
        lines.line(&format!("{}:", capital(name)), Role::Title);
        lines.paragraph(&meant.decision.afterwards(played), Role::Text);
        lines.gap();
    }
    if let Some(called) = &past.called {
        call(called, lines);
    }
    notice(active, lines);
    if replay.number + 1 == active.history.len() {
        score::draw(active, lines);
    }
    lines.gap();
    let next = match active.history.stroke_from(replay.number + 1) {
        Some(_) => "Enter: the next stroke.  Esc: back to the game.",
        None => "Enter: go on.  i: the impacts.",
    };
    lines.paragraph(next, Role::Key);
}

/// What lies on the board at this moment.
fn left(replay: &StrokeReplay, lines: &mut Lines) {
    for piece in [Piece::White, Piece::Black, Piece::Queen] {
        let sign = token(words::role(piece), lines.charset());
        let name = format!("{} {sign}", <&str>::from(piece));
        let there = replay.discs().filter(|(other, _)| *other == piece);
        lines.pair(&name, &there.count().to_string(), Role::Text, Role::Text);
    }
}

/// What was called and what was true.
fn call(called: &Called, lines: &mut Lines) {
    let points = format!("{} of {}", called.points(), Called::MOST);
    lines.pair("your call", &points, Role::Title, Role::Title);
    let names = ["striker", "coin"].map(Some);
    written::<()>(lines, |panel| {
        said_and_true(&called.collision, &called.said, names, false, panel);
    });
    lines.gap();
}

/// All impacts of the stroke, the chosen one marked.
pub(super) fn list(replay: &StrokeReplay, lines: &mut Lines) {
    lines.line("Choose one, Enter looks closer.", Role::Key);
    lines.gap();
    let chosen = replay.player.chosen().map_or(0, |(number, _)| number);
    let (rows, charset) = (lines.left(), lines.charset());
    let roomy = lines.width() >= ROOMY;
    let name = |disc: usize| {
        let piece = replay.pieces.get(disc).copied().unwrap_or(Piece::White);
        match roomy {
            true => piece.into(),
            false => token(words::role(piece), charset),
        }
    };
    let impacts = replay.player.impacts();
    let shown = impacts.iter().enumerate();
    let first = ListView::first_shown(chosen, impacts.len(), rows);
    for (i, impact) in shown.skip(first).take(rows.into()) {
        let [a, b] = impact.discs.map(name);
        lines.choice(i == chosen, Role::Text, |lines, mark, role| {
            let text = format!("{mark}{:2} {a} on {b}", i + 1);
            lines.pair(&text, &format!("{:.5} s", impact.time), role, role);
        });
    }
}

/// Which impact of the list is at a cell of the panel.
pub(in crate::screens::table) fn impact_at(
    replay: &StrokeReplay,
    panel: Rect,
    cell: (u16, u16),
) -> Option<usize> {
    let count = replay.player.impacts().len();
    let chosen = replay.player.list()?.chosen(count);
    let rows = panel.height.saturating_sub(HEAD as u16);
    let line = ListView::row_at(panel, cell)?.checked_sub(HEAD)?;
    let number = ListView::first_shown(chosen, count, rows) + line;
    (number < count).then_some(number)
}
