//! The panel while a stroke is watched: what the referee says, or its impacts.

use ratatui::layout::Rect;

use super::{notice, score};
use crate::game::Piece;
use crate::screens::table::calls::Called;
use crate::screens::table::replay::Replay;
use crate::screens::table::sitting::Sitting;
use crate::screens::table::words;
use crate::widgets::ink::token;
use crate::widgets::panels::said_and_true;
use crate::widgets::{Lines, Role};

/// Columns from which on the list has room for names.
const ROOMY: u16 = 31;
/// Rows above the list of impacts.
const HEAD: usize = 2;

/// What came of the stroke, once it is over.
pub(super) fn draw(sitting: &Sitting, replay: &Replay, lines: &mut Lines) {
    let Some(past) = sitting.session.past(replay.number) else {
        return;
    };
    if !replay.clock.is_over() {
        let name = sitting.options.seat_name(past.before.seat());
        let speed = replay.shot.start(0).velocity.length();
        lines.pair("stroke of", name, Role::Dim, Role::Text);
        lines.pair("at", &format!("{speed:.1} m/s"), Role::Dim, Role::Text);
        let so_far = replay
            .impacts
            .iter()
            .filter(|impact| impact.time <= replay.clock.time());
        lines.pair(
            "impacts",
            &so_far.count().to_string(),
            Role::Dim,
            Role::Text,
        );
        lines.gap();
        left(replay, lines);
        return;
    }
    for ruling in &past.rulings {
        lines.paragraph(&words::ruling(ruling), Role::Text);
    }
    lines.gap();
    if let Some(told) = &past.told {
        let name = sitting.options.seat_name(past.before.seat());
        lines.line(&format!("{}:", words::sentence(name)), Role::Title);
        lines.paragraph(told, Role::Text);
        lines.gap();
    }
    if let Some(called) = &past.called {
        call(called, lines);
    }
    notice(sitting, lines);
    if replay.number + 1 == sitting.session.len() {
        score::draw(sitting, lines);
    }
    lines.gap();
    let enter = match sitting.session.stroke_after(replay.number) {
        Some(_) => "Enter: the next stroke.  Esc: back to the game.",
        None => "Enter: go on.",
    };
    lines.paragraph(enter, Role::Key);
    lines.paragraph("i: look into the impacts.", Role::Key);
}

/// What lies on the board at this moment.
fn left(replay: &Replay, lines: &mut Lines) {
    for piece in [Piece::White, Piece::Black, Piece::Queen] {
        let sign = token(words::role(piece), lines.charset());
        let count = replay
            .discs()
            .filter(|(_, other, _)| *other == piece)
            .count();
        let name = format!("{} {sign}", words::short(piece));
        lines.pair(&name, &count.to_string(), Role::Text, Role::Text);
    }
}

/// What was called and what was true.
fn call(called: &Called, lines: &mut Lines) {
    let points = format!("{} of {}", called.points(), Called::MOST);
    lines.pair("your call", &points, Role::Title, Role::Title);
    let names = ["striker", "coin"].map(Some);
    said_and_true(&called.collision, &called.said, names, false, lines);
    lines.gap();
}

/// All impacts of the stroke, the chosen one marked.
pub(super) fn list(replay: &Replay, lines: &mut Lines) {
    lines.line("Choose one, Enter looks closer.", Role::Key);
    lines.gap();
    let chosen = replay.chosen.unwrap_or(0);
    let rows = usize::from(lines.left());
    let roomy = lines.width() >= ROOMY;
    let charset = lines.charset();
    let first = first_row(chosen, rows, replay.impacts.len());
    for (i, impact) in replay.impacts.iter().enumerate().skip(first).take(rows) {
        let name = |disc: usize| {
            let piece = replay.pieces.get(disc).copied().unwrap_or(Piece::White);
            if roomy {
                words::short(piece)
            } else {
                token(words::role(piece), charset)
            }
        };
        let [a, b] = impact.discs.map(name);
        let (mark, role) = if i == chosen {
            (">", Role::Selected)
        } else {
            (" ", Role::Text)
        };
        let text = format!("{mark}{:2} {a} on {b}", i + 1);
        lines.pair(&text, &format!("{:.5} s", impact.time), role, role);
    }
}

/// The first row of a list of `count` in which `chosen` is to be seen.
fn first_row(chosen: usize, rows: usize, count: usize) -> usize {
    let last_start = count.saturating_sub(rows);
    chosen.saturating_sub(rows / 2).min(last_start)
}

/// Which impact of the list is at a cell of the panel.
pub(in crate::screens::table) fn impact_at(
    replay: &Replay,
    panel: Rect,
    (column, row): (u16, u16),
) -> Option<usize> {
    let chosen = replay.chosen?;
    if !panel.contains((column, row).into()) {
        return None;
    }
    let rows = usize::from(panel.height).saturating_sub(HEAD);
    let line = usize::from(row - panel.y).checked_sub(HEAD)?;
    let number = first_row(chosen, rows, replay.impacts.len()) + line;
    (number < replay.impacts.len()).then_some(number)
}
