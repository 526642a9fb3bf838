//! What is left on the board, what is owed, what the calls have brought.

use crate::game::{Colour, Game, Team};
use crate::screens::table::sitting::Sitting;
use crate::screens::table::words;
use crate::widgets::ink::token;
use crate::widgets::{Lines, Role};

/// The coins of each colour and the queen, in few rows.
pub(super) fn pieces(sitting: &Sitting, lines: &mut Lines) {
    let game = sitting.game();
    for colour in [Colour::White, Colour::Black] {
        let piece = words::coin(colour);
        let sign = token(words::role(piece), lines.charset());
        let left = format!(
            "{} {sign} {} left",
            colour.adjective(),
            game.play().on_board(colour)
        );
        let team = of(game, colour);
        let whose = if sitting.is_practice() {
            ""
        } else {
            sitting.options.team_name(team)
        };
        let turn = !sitting.is_practice() && team == game.team(sitting.seat());
        let role = if turn { Role::Title } else { Role::Dim };
        lines.pair(&left, whose, Role::Text, role);
    }
    let queen = words::queen(game, |team| sitting.options.team_name(team));
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
pub(super) fn draw(sitting: &Sitting, lines: &mut Lines) {
    pieces(sitting, lines);
    let game = sitting.game();
    for team in Team::BOTH {
        let owed = game.play().owed(team);
        if owed > 0 {
            let owes = words::does(sitting.options.team_name(team), "owes");
            lines.line(&format!("{owes} {owed}"), Role::Warn);
        }
    }
    calls(sitting, lines);
}

/// The tally of the calls; it is no part of the score.
pub(super) fn calls(sitting: &Sitting, lines: &mut Lines) {
    if !sitting.session.has_calls() {
        return;
    }
    let calls = sitting.session.calls();
    for team in Team::BOTH {
        let tally = calls[team];
        if tally.most > 0 {
            let name = format!("calls {}", sitting.options.team_name(team));
            let points = format!("{} of {}", tally.points, tally.most);
            lines.pair(&name, &points, Role::Dim, Role::Text);
        }
    }
}
