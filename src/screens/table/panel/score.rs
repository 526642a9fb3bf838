//! What is left on the board, what is owed, what the calls have brought.

use crate::game::{Colour, Game, Team};
use crate::screens::table::active_game::ActiveGame;
use crate::screens::table::words;
use crate::widgets::ink::token;
use crate::widgets::{Lines, Role};

/// The coins of each colour and the queen, in few rows.
pub(super) fn pieces(active: &ActiveGame, lines: &mut Lines) {
    let game = active.game();
    for colour in [Colour::White, Colour::Black] {
        let piece = words::coin(colour);
        let sign = token(words::role(piece), lines.charset());
        let left = format!(
            "{} {sign} {} left",
            colour.adjective(),
            game.play().on_board(colour)
        );
        let team = of(game, colour);
        let whose = if active.is_practice() {
            ""
        } else {
            active.options.team_name(team)
        };
        let turn = !active.is_practice() && team == game.team(active.seat());
        let role = if turn { Role::Title } else { Role::Dim };
        lines.pair(&left, whose, Role::Text, role);
    }
    let queen = words::queen(game, |team| active.options.team_name(team));
    lines.pair("queen Q", &queen, Role::Text, Role::Dim);
}

/// The team that plays a colour.
pub(super) fn of(game: &Game, colour: Colour) -> Team {
    if game.colour(Team::First) == colour {
        Team::First
    } else {
        Team::Second
    }
}

/// Pieces, dues, and the calls.
pub(super) fn draw(active: &ActiveGame, lines: &mut Lines) {
    pieces(active, lines);
    let game = active.game();
    for team in Team::BOTH {
        let owed = game.play().owed(team);
        if owed > 0 {
            let owes = words::does(active.options.team_name(team), "owes");
            lines.line(&format!("{owes} {owed}"), Role::Warn);
        }
    }
    calls(active, lines);
}

/// The tally of the calls; it is no part of the score.
pub(super) fn calls(active: &ActiveGame, lines: &mut Lines) {
    if !active.history.has_calls() {
        return;
    }
    let calls = active.history.calls();
    for team in Team::BOTH {
        let tally = calls[team];
        if tally.most > 0 {
            let name = format!("calls {}", active.options.team_name(team));
            let points = format!("{} of {}", tally.points, tally.most);
            lines.pair(&name, &points, Role::Dim, Role::Text);
        }
    }
}
