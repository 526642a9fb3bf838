//! The panel while aiming.

use super::{notice, score};
use crate::game::Game;
use crate::numbers::{capital, fixed};
use crate::screens::table::active_game::{ActiveGame, Hinted, ShownStroke};
use crate::screens::table::aim::{Aim, SPEEDS};
use crate::screens::table::preview::{FirstHit, Preview, WayEnd};
use crate::screens::table::words;
use crate::widgets::bar::bar;
use crate::widgets::{Lines, Role, Words};

/// Most cells of the bar of strength.
const BAR: u16 = 10;
/// Columns of the name and the number beside it.
const NAME_AND_SPEED: u16 = 18;

/// The aim, what it will meet first, and how the game stands.
pub(super) fn draw(active: &ActiveGame, lines: &mut Lines) {
    let game = active.game();
    turn(active, lines);
    let aim = active.aimed();
    let direction = if active.entry.is_open() {
        format!("{}_", active.entry.text())
    } else {
        direction(active, &aim)
    };
    lines.fact("aim", &direction);
    strength(&aim, lines);
    lines.fact("place", &aim.place_words(game));
    if active.entry.is_open() {
        lines.paragraph("[ ]: as the place, +: as the strength", Role::Key);
    }
    if active.is_pulling() {
        let what = match active.is_drawn() {
            true => "Let go: strike. Back to the striker: not now.",
            false => "Pull farther back to strike.",
        };
        lines.paragraph(what, Role::Key);
    }
    lines.gap();
    if active.notice.is_some() {
        notice(active, lines);
    } else if let Some(hinted) = &active.hint {
        hint(hinted, lines);
    } else if let Err(why) = aim.check(game) {
        lines.paragraph(&format!("Not from here: {why}."), Role::Warn);
    } else {
        ahead(active, lines);
    }
    lines.gap();
    score::draw(active, lines);
}

/// A stroke of the computer before it is struck: as much of it as is seen.
pub(super) fn show(active: &ActiveGame, shown: &ShownStroke, lines: &mut Lines) {
    turn(active, lines);
    let aim = &shown.stroke.aim;
    lines.fact("place", &aim.place_words(active.game()));
    if shown.parts > 1 {
        lines.fact("aim", &direction(active, aim));
    }
    if shown.parts > 2 {
        strength(aim, lines);
    }
    lines.gap();
    let hit = shown.stroke.preview.as_ref().and_then(Preview::first_hit);
    if let Some(hit) = hit.filter(|_| shown.parts > 2) {
        first_hit(active.game(), &hit, false, lines);
    }
    lines.gap();
    lines.paragraph("What will happen? Say it first.", Role::Text);
    lines.paragraph("c: your call.  Space: strike.", Role::Key);
    lines.gap();
    score::draw(active, lines);
}

fn direction(active: &ActiveGame, aim: &Aim) -> String {
    format!("{:.1}°", aim.shown_deg(active.seat()))
}

fn strength(aim: &Aim, lines: &mut Lines) {
    let bar_width = lines.width().saturating_sub(NAME_AND_SPEED).min(BAR);
    let bar = bar(aim.speed / SPEEDS.1, bar_width, lines.charset());
    let speed = format!("{:.1} m/s", aim.speed);
    lines.written_as(
        |_| Words::meter("strength", aim.speed / SPEEDS.1, &speed, Role::Text),
        |lines| lines.fact("strength", &format!("{bar} {speed}")),
    );
}

/// Whose turn it is, with what colour, and what the laws ask of the stroke.
fn turn(active: &ActiveGame, lines: &mut Lines) {
    if active.is_practice() {
        return;
    }
    let game = active.game();
    let colour = game.colour(game.team(active.seat()));
    let name = active.options.seat_name(active.seat());
    let does = match game.play().is_unbroken() {
        true => "breaks",
        false => "plays",
    };
    let turn = format!("{}, {}", words::does(name, does), colour.adjective());
    lines.line(&capital(&turn), Role::Title);
}

/// The hint: first where to look, then all of it.
fn hint(hinted: &Hinted, lines: &mut Lines) {
    let (words, key) = match hinted.whole {
        false => (hinted.hint.which(), "h: tell me more"),
        true => (hinted.hint.how(), "h: set it so"),
    };
    lines.paragraph(&words, Role::Good);
    lines.line(key, Role::Key);
}

/// What the striker will meet first.
fn ahead(active: &ActiveGame, lines: &mut Lines) {
    let Some(preview) = &active.preview else {
        return;
    };
    match &preview.end {
        // While one calls, the impact angle is the coin's answer.
        WayEnd::Meets(hit) => first_hit(active.game(), hit, !active.options.call, lines),
        WayEnd::Falls => lines.line("no hit: into the pocket", Role::Warn),
        WayEnd::Stops => lines.line("no hit", Role::Dim),
        WayEnd::TooSoft(coin) => {
            let text = format!("too soft to reach the {}", piece(active.game(), *coin));
            lines.line(&text, Role::Warn);
        }
    }
    if active.options.call {
        lines.line("you will call this hit", Role::Key);
    }
}

/// What a coin is.
fn piece(game: &Game, coin: usize) -> &'static str {
    let coin = game.coins().get(coin);
    coin.map_or("coin", |coin| coin.piece.into())
}

/// A first hit in numbers: which coin, b, and α if it may be told.
fn first_hit(game: &Game, hit: &FirstHit, tells_angle: bool, lines: &mut Lines) {
    lines.fact("first hit", piece(game, hit.coin));
    let collision = &hit.impact.collision;
    let offset = (collision.offset * 1000.0 * 10.0).round() / 10.0;
    lines.fact("  offset b", &format!("{} mm", fixed(offset, 1)));
    if let Some(alpha) = collision.alpha().filter(|_| tells_angle) {
        lines.fact("  angle α", &format!("{:.1}°", alpha.to_degrees().abs()));
    }
}
