//! What is left on the board, what is owed, what the calls have brought.

use super::ActiveGame;
use crate::game::{ByTeam, Colour, Team};
use crate::screens::table::game_history::CallTally;
use crate::screens::table::words;
use crate::widgets::ink::token;
use crate::widgets::panel::Panel;
use crate::widgets::{Charset, Role};

impl ActiveGame {
    /// What the calls have brought.
    pub(super) fn calls(&self) -> ByTeam<CallTally> {
        self.history
            .calls(|game, seat| self.options.caller(game, seat))
    }
}

/// Writes the coins of each colour and the queen, in few rows.
pub(super) fn write_pieces<A>(active: &ActiveGame, charset: Charset, panel: &mut Panel<A>) {
    let game = active.game();
    for colour in [Colour::White, Colour::Black] {
        let sign = token(words::role(colour.piece()), charset);
        let count = game.play().on_board(colour);
        let left = format!("{} {sign} {count} left", colour.adjective());
        let team = Team::BOTH[usize::from(game.colour(Team::First) != colour)];
        let (whose, role) = match team == game.team(active.seat()) {
            _ if active.is_practice() => ("", Role::Dim),
            true => (active.options.team_name(team), Role::Title),
            false => (active.options.team_name(team), Role::Dim),
        };
        panel.pair((left, Role::Text), (whose, role));
    }
    let queen = match game.play().queen_covered_by {
        Some(team) => format!("with {}", active.options.team_name(team)),
        None if game.play().queen_on_board() => "on the board".into(),
        None => "to be covered".into(),
    };
    panel.pair(("queen Q", Role::Text), (queen, Role::Dim));
}

/// Writes pieces, dues, and the calls.
pub(super) fn write<A>(active: &ActiveGame, charset: Charset, panel: &mut Panel<A>) {
    write_pieces(active, charset, panel);
    for team in Team::BOTH {
        let owed = active.game().play().owed[team];
        if owed > 0 {
            let owes = words::does(active.options.team_name(team), "owes");
            panel.line(format!("{owes} {owed}"), Role::Warn);
        }
    }
    write_calls(active, panel);
}

/// Writes the tally of the calls; it is no part of the score.
pub(super) fn write_calls<A>(active: &ActiveGame, panel: &mut Panel<A>) {
    let calls = active.calls();
    for team in Team::BOTH.into_iter().filter(|team| calls[*team].most > 0) {
        let points = format!("{} of {}", calls[team].points, calls[team].most);
        panel.fact(format!("calls {}", active.options.team_name(team)), points);
    }
}
