//! What is left on the board, what is owed, what the calls have brought.

use crate::game::{Colour, Team};
use crate::screens::table::active_game::ActiveGame;
use crate::screens::table::words;
use crate::widgets::ink::token;
use crate::widgets::{Lines, Role};

/// The coins of each colour and the queen, in few rows.
pub(super) fn pieces(active: &ActiveGame, lines: &mut Lines) {
    let game = active.game();
    for colour in [Colour::White, Colour::Black] {
        let sign = token(words::role(colour.piece()), lines.charset());
        let count = game.play().on_board(colour);
        let left = format!("{} {sign} {count} left", colour.adjective());
        let team = Team::BOTH[usize::from(game.colour(Team::First) != colour)];
        let (whose, role) = match team == game.team(active.seat()) {
            _ if active.is_practice() => ("", Role::Dim),
            true => (active.options.team_name(team), Role::Title),
            false => (active.options.team_name(team), Role::Dim),
        };
        lines.pair(&left, whose, Role::Text, role);
    }
    let queen = match game.play().queen_covered_by {
        Some(team) => format!("with {}", active.options.team_name(team)),
        None if game.play().queen_on_board() => "on the board".into(),
        None => "to be covered".into(),
    };
    lines.pair("queen Q", &queen, Role::Text, Role::Dim);
}

/// Pieces, dues, and the calls.
pub(super) fn draw(active: &ActiveGame, lines: &mut Lines) {
    pieces(active, lines);
    let game = active.game();
    for team in Team::BOTH {
        let owed = game.play().owed[team];
        if owed > 0 {
            let owes = words::does(active.options.team_name(team), "owes");
            lines.line(&format!("{owes} {owed}"), Role::Warn);
        }
    }
    calls(active, lines);
}

/// The tally of the calls; it is no part of the score.
pub(super) fn calls(active: &ActiveGame, lines: &mut Lines) {
    let calls = active.calls();
    for team in Team::BOTH.into_iter().filter(|team| calls[*team].most > 0) {
        let name = format!("calls {}", active.options.team_name(team));
        let points = format!("{} of {}", calls[team].points, calls[team].most);
        lines.fact(&name, &points);
    }
}
