//! The panel while aiming.

use super::{notice, score};
use crate::game::Game;
use crate::numbers::{capital, fixed};
use crate::screens::table::active_game::{ActiveGame, Hinted};
use crate::screens::table::aim::SPEEDS;
use crate::screens::table::preview::{FirstHit, WayEnd};
use crate::screens::table::words;
use crate::widgets::bar::bar;
use crate::widgets::{Lines, Role};

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
        format!("{:.1}°", aim.direction_deg)
    };
    lines.fact("aim", &direction);
    let bar_width = lines.width().saturating_sub(NAME_AND_SPEED).min(BAR);
    let bar = bar(aim.speed / SPEEDS.1, bar_width, lines.charset());
    lines.fact("strength", &format!("{bar} {:.1} m/s", aim.speed));
    lines.fact("place", &aim.place_words(game));
    if active.entry.is_open() {
        lines.paragraph("[ ]: as the place, +: as the strength", Role::Key);
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
    match hinted {
        Hinted::Asked { .. } => lines.line("looking for a stroke …", Role::Dim),
        Hinted::Told { hint, whole, .. } => {
            let (words, key) = match whole {
                false => (hint.which(), "h: tell me more"),
                true => (hint.how(), "h: set it so"),
            };
            lines.paragraph(&words, Role::Good);
            lines.line(key, Role::Key);
        }
    }
}

/// What the striker will meet first.
fn ahead(active: &ActiveGame, lines: &mut Lines) {
    let Some(preview) = &active.preview else {
        return;
    };
    match &preview.end {
        WayEnd::Meets(hit) => first_hit(active.game(), hit, lines),
        WayEnd::Falls => lines.line("no hit: into the pocket", Role::Warn),
        WayEnd::Stops => lines.line("no hit", Role::Dim),
    }
    if active.options.call {
        lines.line("you will call this hit", Role::Key);
    }
}

/// A first hit in numbers: which coin, b and α.
fn first_hit(game: &Game, hit: &FirstHit, lines: &mut Lines) {
    let piece = game.coins().get(hit.coin).map(|coin| coin.piece);
    lines.fact("first hit", piece.map_or("coin", Into::into));
    let collision = &hit.impact.collision;
    let offset = (collision.offset * 1000.0 * 10.0).round() / 10.0;
    lines.fact("  offset b", &format!("{} mm", fixed(offset, 1)));
    if let Some(alpha) = collision.alpha() {
        lines.fact("  angle α", &format!("{:.1}°", alpha.to_degrees().abs()));
    }
}
