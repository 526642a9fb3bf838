//! The panel at the end of a board, a game or the match.

use super::{notice, rulings, score};
use crate::game::{Game, GameStage, Rules, Seat, Team};
use crate::numbers::capital;
use crate::screens::table::active_game::ActiveGame;
use crate::screens::table::words;
use crate::widgets::{Lines, Role};

/// Who won what, and what follows.
pub(super) fn draw(active: &ActiveGame, lines: &mut Lines) {
    let game = active.game();
    let name = |team: Team| active.options.team_name(team);
    let headline = match game.stage() {
        GameStage::MatchOver(team) => format!("{}!", active.options.wins(team, "match")),
        GameStage::GameOver(team) => format!("{}!", active.options.wins(team, "game")),
        GameStage::BoardOver(_) if active.is_practice() => "The board is empty.".into(),
        GameStage::BoardOver(won) => format!("The board goes to {}.", name(won.winner)),
        GameStage::Playing => String::new(),
    };
    lines.line(&headline, Role::Title);
    lines.gap();
    if let Some(last) = active.history.last() {
        rulings(last, lines);
    }
    let score = game.score();
    if game.setup().rules == Rules::Tournament {
        if let Some(won) = game.play().won {
            lines.fact("this board", &format!("+{}", won.points));
        }
        for team in Team::BOTH {
            lines.fact(name(team), &format!("{} points", score.points[team]));
        }
        let [first, second] = Team::BOTH.map(|team| score.games[team]);
        lines.fact("games before this", &format!("{first} : {second}"));
    }
    score::calls(active, lines);
    notice(active, lines);
    lines.gap();
    if let Some(breaker) = next_breaker(game) {
        let breaks = words::does(active.options.seat_name(breaker), "breaks");
        lines.line(&format!("{} next.", capital(&breaks)), Role::Text);
    }
    let next = match game.stage() {
        GameStage::MatchOver(_) => "Enter: a new game.",
        GameStage::GameOver(_) => "Enter: the next game.",
        _ => "Enter: the next board.",
    };
    lines.paragraph(next, Role::Key);
    lines.paragraph("i: look at the strokes again.", Role::Key);
}

/// Who breaks the next board, if there is one with sides.
fn next_breaker(game: &Game) -> Option<Seat> {
    if game.setup().rules == Rules::Practice {
        return None;
    }
    let mut next = game.clone();
    next.next_board().ok()?;
    Some(next.seat())
}
