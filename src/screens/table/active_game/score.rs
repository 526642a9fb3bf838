//! The coins left on the board, the coins owed, and the points of the calls.

use super::ActiveGame;
use crate::game::{ByTeam, Colour, Piece, Rules, Team};
use crate::screens::table::calls::Called;
use crate::screens::table::game_history::Past;
use crate::screens::table::words;
use crate::widgets::ink::token;
use crate::widgets::panel::Panel;
use crate::widgets::{Charset, Role};

impl ActiveGame {
    /// The points of each team's calls, which are not part of the score.
    pub(super) fn calls(&self) -> ByTeam<Vec<u32>> {
        let mut calls = ByTeam::<Vec<u32>>::default();
        for Past { before, called, .. } in self.history.moves() {
            let team = self.options.caller(before, before.seat());
            calls[team].extend(called.as_ref().map(Called::points));
        }
        calls
    }
}

/// Writes the coins of each colour and the queen, in as few rows as possible.
pub(super) fn write_pieces<A>(active: &ActiveGame, charset: Charset, panel: &mut Panel<A>) {
    let game = active.game();
    if active.board_code().is_some() {
        let sign = token(words::role(Piece::White), charset);
        panel.fact(format!("coins {sign} left"), game.coins().len().to_string());
        return;
    }
    let is_points = game.setup().rules == Rules::Points;
    for colour in [Colour::White, Colour::Black] {
        let sign = token(words::role(colour.piece()), charset);
        let count = game.play().on_board(colour);
        let left = format!("{} {sign} {count} left", colour.adjective());
        let team = Team::BOTH[usize::from(game.colour(Team::First) != colour)];
        let (whose, role) = match team == game.team(active.seat()) {
            _ if active.is_practice() => ("", Role::Dim),
            _ if is_points && colour == Colour::White => ("2 points each", Role::Dim),
            _ if is_points => ("1 point each", Role::Dim),
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
    if is_points {
        panel.fact("points", active.options.score(game));
    }
}

/// Warns the player who strikes next about the two situations that cost the most.
pub(super) fn write_warning<A>(active: &ActiveGame, panel: &mut Panel<A>) {
    let (game, play) = (active.game(), active.game().play());
    let own = play.on_board(game.colour(game.team(active.seat())));
    let queen = (play.queen_to_cover(), play.queen_on_board());
    panel.warning(warning(game.setup().rules, queen, own));
}

/// The warning for a player with `own` coins left. `queen` says whether the queen has to be
/// covered, and whether she is on the board.
const fn warning(rules: Rules, queen: (bool, bool), own: u8) -> Option<&'static str> {
    match (rules, queen, own) {
        (Rules::Tournament | Rules::Friendly, (true, _), _) => {
            Some("Cover the queen: pocket one of your coins now, or she goes back.")
        }
        (Rules::Points, (true, _), _) => {
            Some("Cover the queen: pocket any coin now, or she goes back.")
        }
        (Rules::Tournament, (_, true), 1) => {
            Some("Do not pocket your last coin before the queen: you would lose the board.")
        }
        _ => None,
    }
}

/// Writes the pieces, the coins owed, and the points of the calls.
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

/// Writes the points of the calls, which are not part of the score.
pub(super) fn write_calls<A>(active: &ActiveGame, panel: &mut Panel<A>) {
    let calls = active.calls();
    for team in Team::BOTH {
        let (count, points) = (calls[team].len() as u32, calls[team].iter().sum::<u32>());
        if count > 0 {
            let whose = words::whose(active.options.team_name(team), "calls");
            panel.fact(whose, format!("{points} of {}", Called::MOST * count));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_coin_and_an_uncovered_queen_are_warned_of_where_they_cost_something() {
        let warns = |rules, queen, own, of: &str| {
            warning(rules, queen, own).is_some_and(|words| words.contains(of))
        };
        assert!(warns(
            Rules::Tournament,
            (true, false),
            4,
            "Cover the queen"
        ));
        assert!(warns(Rules::Friendly, (true, false), 1, "Cover the queen"));
        assert!(warns(Rules::Points, (true, false), 1, "any coin"));
        assert_eq!(warning(Rules::Points, (false, true), 1), None);
        assert!(warns(Rules::Tournament, (false, true), 1, "your last coin"));
        assert_eq!(warning(Rules::Tournament, (false, true), 2), None);
        assert_eq!(warning(Rules::Tournament, (false, false), 1), None);
        assert_eq!(warning(Rules::Friendly, (false, true), 1), None);
        assert_eq!(warning(Rules::Practice, (true, false), 1), None);
    }
}
