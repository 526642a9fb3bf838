//! The end of a board, a game or the match: the result, and what comes next.

use super::{ActiveGame, After, GameAction, GamePhase, Player, score};
use crate::game::opponent::PlayerHand;
use crate::game::{Game, GameStage, Length, Move, Rules, Seat, Team};
use crate::numbers::{capital, counted};
use crate::screens::table::board_report::{BoardReport, TeamReport, run_words};
use crate::screens::table::{TableAction, TablePanel, words};
use crate::screens::{Context, Next};
use crate::widgets::Role;
use crate::widgets::panel::Panel;

impl ActiveGame {
    /// Starts the next board, or ends the match.
    pub(super) fn next_board(&mut self, cx: &Context) -> After {
        if let GameStage::MatchOver(_) = self.game().stage() {
            return After::Screen(Next::Back);
        }
        self.make(Move::NextBoard);
        After::Phase(self.turn(cx))
    }

    /// The replay of the best stroke of the board.
    pub(super) fn watch_best(&mut self, cx: &Context) -> Option<GamePhase> {
        let best = BoardReport::of(&self.history).best;
        self.look_at(best, cx.settings.reduced_motion, cx)
    }

    /// A click on the board continues, but not at the end of a match: after an accidental click,
    /// nobody could read the result.
    pub(super) fn click_on_end(&mut self, cx: &Context) -> After {
        match self.game().stage() {
            GameStage::MatchOver(_) => After::Screen(Next::Stay),
            _ => self.next_board(cx),
        }
    }

    /// Writes the result of the board, and what can be done next.
    pub(super) fn write_end(&self, panel: &mut TablePanel) {
        let game = self.game();
        let report = BoardReport::of(&self.history);
        panel.paragraph(self.headline(&report), Role::Title);
        panel.gap();
        if let Some(code) = self.board_code().filter(|_| self.is_cleared()) {
            let result = code.result(self.history.record().strokes(), self.par);
            let (command, address) = (format!("carrom board {code}"), format!("board={code}"));
            panel.result(result, command, address);
        } else if let Some(last) = self.history.moves().last() {
            last.write_rulings(panel);
        }
        // The title shows the points, and the referee has announced those of a single board.
        if game.setup().rules == Rules::Tournament {
            let length = game.setup().length;
            if let Some(won) = game.play().won.filter(|_| length != Length::Board) {
                panel.fact("this board", format!("+{}", won.points));
            }
            if length == Length::Match {
                let games = words::versus(|team| game.score().games[team]);
                panel.fact("games before this", games);
            }
        }
        if (game.setup().rules, game.setup().length) == (Rules::Points, Length::Match) {
            panel.fact("boards won", self.options.boards_won(game));
        }
        if !game.setup().rules.is_alone() {
            self.write_teams(&report, panel);
        }
        score::write_calls(self, panel);
        self.write_best(&report, panel);
        panel.warning(self.notice.as_deref());
        panel.pin_below();
        if let Some(breaker) = next_breaker(game) {
            let breaks = words::does(self.options.seat_name(breaker), "breaks");
            panel.line(format!("{} next.", capital(&breaks)), Role::Text);
        }
        let next = match game.stage() {
            GameStage::MatchOver(_) if self.board_code().is_some() => "back to the boards",
            GameStage::MatchOver(_) => "a new game",
            GameStage::GameOver(_) if game.setup().rules == Rules::Tournament => "the next game",
            _ => "the next board",
        };
        panel.prompt(next, TableAction::Game(GameAction::NextBoard));
        let best = TableAction::Game(GameAction::WatchBest);
        let best = report.best.map(|_| ("the best stroke", best));
        let strokes = ("the strokes", TableAction::Game(GameAction::LookBack));
        panel.prompts([strokes].into_iter().chain(best));
    }

    /// Whether the player has cleared a board for one player.
    fn is_cleared(&self) -> bool {
        self.game().stage() == GameStage::MatchOver(Team::First)
    }

    /// The number of strokes on a board for one player, compared with its par.
    fn cleared(&self) -> String {
        let strokes = self.history.record().strokes();
        let cleared = format!("Cleared in {}", counted(strokes, "stroke"));
        match self.par {
            None => format!("{cleared}."),
            Some(par) if strokes == par => format!("{cleared}: par!"),
            Some(par) if strokes < par => format!("{cleared}: {} under par!", par - strokes),
            Some(par) => format!("{cleared}: {} over par.", strokes - par),
        }
    }

    /// A sentence that says who won the match, the game or the board, and with how many hints.
    fn headline(&self, report: &BoardReport) -> String {
        let hints = |team: Team| match report.teams[team].hints {
            0 => String::new(),
            hints => format!(", with {}", counted(hints as usize, "hint")),
        };
        let wins = |team, what| format!("{}{}!", self.options.wins(team, what), hints(team));
        match self.game().stage() {
            GameStage::MatchOver(_) if self.board_code().is_some() => match self.is_cleared() {
                true => self.cleared(),
                false => "The board is lost.".into(),
            },
            GameStage::MatchOver(team) => wins(team, self.options.whole()),
            GameStage::GameOver(team) if self.game().setup().rules == Rules::Tournament => {
                wins(team, "game")
            }
            GameStage::GameOver(team) => wins(team, self.options.whole()),
            GameStage::BoardOver(_) if self.is_practice() => "The board is empty.".into(),
            GameStage::BoardOver(won) => {
                let winner = words::player(self.options.team_name(won.winner));
                format!("The board goes to {winner}{}.", hints(won.winner))
            }
            GameStage::Playing => String::new(),
        }
    }

    /// Writes the figures of both teams for the board, side by side.
    fn write_teams<A>(&self, report: &BoardReport, panel: &mut Panel<A>) {
        panel.gap();
        let both =
            |value: fn(&TeamReport) -> String| words::versus(|team| value(&report.teams[team]));
        let names = words::versus(|team| self.options.team_name(team));
        panel.pair(("", Role::Dim), (names, Role::Title));
        if self.hand() != PlayerHand::Exact {
            let whose = match self.options.count(Player::Person) {
                1 => "your hand",
                _ => "your hands",
            };
            panel.fact(whose, <&str>::from(self.hand()));
        }
        panel.fact("strokes", both(|team| team.strokes.to_string()));
        panel.fact("pocketing", both(TeamReport::share));
        panel.fact("striker fell", both(|team| team.fouls.to_string()));
        let any = |count: fn(&TeamReport) -> u32| {
            Team::BOTH
                .iter()
                .any(|team| count(&report.teams[*team]) > 0)
        };
        if any(|team| team.put_back) {
            panel.fact("coins put back", both(|team| team.put_back.to_string()));
        }
        if any(|team| team.hints) {
            panel.fact("hints", both(|team| team.hints.to_string()));
        }
        if self.game().setup().rules == Rules::Tournament && report.run.len() > 1 {
            let run = format!("board by board {}", run_words(&report.run));
            panel.paragraph(run, Role::Text);
        }
    }

    /// Writes the best stroke of the board.
    fn write_best<A>(&self, report: &BoardReport, panel: &mut Panel<A>) {
        let history = &self.history;
        let past = |number| Some((number, history.past(number)?));
        let Some((number, past)) = report.best.and_then(past) else {
            return;
        };
        let what = past.story.and_then(|story| story.brief());
        let what = what.unwrap_or_default();
        let name = self.options.seat_name(past.before.seat());
        let stroke = history.strokes_before(number + 1);
        panel.gap();
        let best = format!("Best stroke: number {stroke}, {name}: {what}.");
        panel.paragraph(best, Role::Text);
    }
}

/// The seat that breaks the next board; `None` in a practice game or after the match.
fn next_breaker(game: &Game) -> Option<Seat> {
    if game.setup().rules.is_alone() {
        return None;
    }
    let mut next = game.clone();
    next.next_board().ok()?;
    Some(next.seat())
}
