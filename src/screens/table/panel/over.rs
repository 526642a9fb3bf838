//! The panel at the end of a board, a game or the match.

use super::{notice, rulings, score};
use crate::game::{Game, GameStage, Rules, Seat, Team};
use crate::numbers::{capital, counted};
use crate::screens::table::active_game::ActiveGame;
use crate::screens::table::tale::{BoardTale, TeamTale, run_words};
use crate::screens::table::words;
use crate::widgets::{Lines, Role};

/// Who won what, and what follows.
pub(super) fn draw(active: &ActiveGame, lines: &mut Lines) {
    let game = active.game();
    let name = |team: Team| active.options.team_name(team);
    let headline = match game.stage() {
        GameStage::MatchOver(team) => {
            let wins = active.options.wins(team, "match");
            format!("{wins}{}!", with_hints(active, team))
        }
        GameStage::GameOver(team) => {
            let wins = active.options.wins(team, "game");
            format!("{wins}{}!", with_hints(active, team))
        }
        GameStage::BoardOver(_) if active.is_practice() => "The board is empty.".into(),
        GameStage::BoardOver(won) => {
            let hints = with_hints(active, won.winner);
            format!(
                "The board goes to {}{hints}.",
                words::player(name(won.winner))
            )
        }
        GameStage::Playing => String::new(),
    };
    lines.paragraph(&headline, Role::Title);
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
    let tale = active.tale();
    if !active.is_practice() {
        teams(active, &tale, lines);
    }
    score::calls(active, lines);
    best(active, &tale, lines);
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
    if tale.best.is_some() {
        lines.paragraph("b: watch the best stroke.", Role::Key);
    }
}

/// What both teams did on the board, beside each other.
fn teams(active: &ActiveGame, tale: &BoardTale, lines: &mut Lines) {
    lines.gap();
    let both = |value: fn(&TeamTale) -> String| {
        let [first, second] = Team::BOTH.map(|team| value(&tale.teams[team]));
        format!("{first} : {second}")
    };
    let [first, second] = Team::BOTH.map(|team| active.options.team_name(team));
    lines.pair("", &format!("{first} : {second}"), Role::Dim, Role::Title);
    lines.fact("strokes", &both(|team| team.strokes.to_string()));
    lines.fact("pocketing", &both(|team| format!("{} %", team.share())));
    lines.fact("striker fell", &both(|team| team.fouls.to_string()));
    lines.fact("coins put back", &both(|team| team.put_back.to_string()));
    if Team::BOTH.iter().any(|team| tale.teams[*team].hints > 0) {
        lines.fact("hints", &both(|team| team.hints.to_string()));
    }
    if active.game().setup().rules == Rules::Tournament && tale.run.len() > 1 {
        lines.paragraph(
            &format!("board by board {}", run_words(&tale.run)),
            Role::Text,
        );
    }
}

/// The best stroke of the board.
fn best(active: &ActiveGame, tale: &BoardTale, lines: &mut Lines) {
    let history = &active.history;
    let best = tale
        .best
        .and_then(|number| Some((number, history.past(number)?)));
    let Some((number, past)) = best else {
        return;
    };
    let what = past
        .story
        .and_then(|story| story.brief())
        .unwrap_or_default();
    let name = active.options.seat_name(past.before.seat());
    let stroke = history.strokes_before(number + 1);
    let text = format!("Best stroke: number {stroke}, {name}: {what}.");
    lines.gap();
    lines.paragraph(&text, Role::Text);
}

/// With how many hints a team won the board, if with any.
fn with_hints(active: &ActiveGame, team: Team) -> String {
    match active.tale().teams[team].hints {
        0 => String::new(),
        hints => format!(", with {}", counted(hints as usize, "hint")),
    }
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
