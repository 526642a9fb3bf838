//! The page of saved games: to resume one, watch it again, export or remove it.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::options::Options;
use super::sitting::Sitting;
use super::{picture, view, words};
use crate::game::{Game, Rules, SavedGame, Stage, Team};
use crate::messages::{
    Input, KeptGame, Key, Mouse, MouseKind, StoreAnswer, StoreReply, StoreRequest,
};
use crate::screens::{Context, Hint};
use crate::widgets::{Lines, Role, text};

/// Rows below the list for what is to be said of the chosen game.
const ABOUT: usize = 11;

/// The page.
#[derive(Debug, Clone)]
pub(super) struct SavedGames {
    /// For the page to go back to.
    pub(super) options: Options,
    games: Games,
    chosen: usize,
    /// A game on its way, and whether to watch it from its beginning.
    loading: Option<(u64, bool)>,
    /// Whether the player has been asked about removing the chosen game.
    removing: bool,
    notice: Option<String>,
}

/// The games there are.
#[derive(Debug, Clone)]
enum Games {
    /// They have been asked for.
    Asked,
    /// Nobody can say, and why.
    Unknown(String),
    /// These.
    Known(Vec<KeptGame>),
}

/// What follows from an input.
pub(super) enum Step {
    /// Stay on the page.
    Stay,
    /// It meant nothing here.
    Ignored,
    /// Back to the page of a new game.
    Back,
    /// Sit down to this game.
    Sit(Box<Sitting>),
}

impl SavedGames {
    /// The page, with the games asked for; `options` are those of the page before.
    pub(super) fn ask(options: Options, cx: &mut Context) -> Self {
        cx.ask(StoreRequest::List);
        Self {
            options,
            games: Games::Asked,
            chosen: 0,
            loading: None,
            removing: false,
            notice: None,
        }
    }

    fn known(&self) -> &[KeptGame] {
        match &self.games {
            Games::Known(games) => games,
            Games::Asked | Games::Unknown(_) => &[],
        }
    }

    fn chosen(&self) -> Option<&KeptGame> {
        self.known().get(self.chosen)
    }

    /// The chosen game, if it can be read.
    fn game(&self) -> Option<&(SavedGame, Game)> {
        self.chosen()?.content.as_deref().ok()
    }

    pub(super) fn update(&mut self, input: &Input, cx: &mut Context) -> Step {
        match input {
            Input::Key(key) => self.key(*key, cx),
            Input::Mouse(mouse) => self.mouse(mouse, cx),
            Input::Kept(answer) => self.take_answer(answer, cx),
            _ => Step::Ignored,
        }
    }

    fn key(&mut self, key: Key, cx: &mut Context) -> Step {
        self.notice = None;
        if self.removing {
            self.removing = false;
            if let Key::Char('y' | 'Y') = key
                && let Some(game) = self.chosen()
            {
                let wish = StoreRequest::Remove(game.name.clone());
                cx.ask(wish);
            }
            return Step::Stay;
        }
        let last = self.known().len().saturating_sub(1);
        match key {
            Key::Up | Key::BackTab => self.chosen = self.chosen.saturating_sub(1),
            Key::Down | Key::Tab => self.chosen = (self.chosen + 1).min(last),
            Key::Home => self.chosen = 0,
            Key::End => self.chosen = last,
            Key::Enter => self.load(false, cx),
            Key::Char('v' | 'V') => self.load(true, cx),
            Key::Char('e' | 'E') => self.export(cx),
            Key::Char('d' | 'D') | Key::Delete => self.removing = self.chosen().is_some(),
            Key::Escape => return Step::Back,
            _ => return Step::Ignored,
        }
        Step::Stay
    }

    fn load(&mut self, watch: bool, cx: &mut Context) {
        if self.game().is_some()
            && let Some(game) = self.chosen()
        {
            let wish = StoreRequest::Load(game.name.clone());
            self.loading = Some((cx.ask(wish), watch));
        }
    }

    fn export(&self, cx: &mut Context) {
        if let Some((saved, _)) = self.game() {
            cx.ask(StoreRequest::Export(Box::new(saved.clone())));
        }
    }

    fn take_answer(&mut self, answer: &StoreAnswer, cx: &mut Context) -> Step {
        match &answer.done {
            StoreReply::Listed(Ok(games)) => {
                self.chosen = self.chosen.min(games.len().saturating_sub(1));
                self.games = Games::Known(games.clone());
            }
            StoreReply::Listed(Err(reason)) => self.games = Games::Unknown(reason.clone()),
            StoreReply::Loaded(loaded) => {
                let Some((ticket, watch)) = self.loading.filter(|(it, _)| *it == answer.ticket)
                else {
                    return Step::Stay;
                };
                self.loading = None;
                let sitting = loaded.as_ref().map_err(Clone::clone).and_then(|saved| {
                    Sitting::resume_saved(saved, ticket).map_err(|error| error.to_string())
                });
                match sitting {
                    Ok(mut sitting) => {
                        if watch {
                            sitting.watch_all(cx);
                        }
                        return Step::Sit(Box::new(sitting));
                    }
                    Err(reason) => self.notice = Some(format!("It cannot be resumed: {reason}.")),
                }
            }
            StoreReply::Removed(result) => {
                if let Err(reason) = result {
                    self.notice = Some(format!("It cannot be removed: {reason}."));
                }
                cx.ask(StoreRequest::List);
            }
            StoreReply::Exported(Ok(place)) => {
                self.notice = Some(format!("It is written to {place}"))
            }
            StoreReply::Exported(Err(reason)) => {
                self.notice = Some(format!("It cannot be exported: {reason}."));
            }
            _ => {}
        }
        Step::Stay
    }

    fn mouse(&mut self, mouse: &Mouse, cx: &Context) -> Step {
        let panel = view::layout(cx.body, false).panel;
        let at = match mouse.kind {
            MouseKind::ScrollUp => self.chosen.checked_sub(1),
            MouseKind::ScrollDown => Some(self.chosen + 1),
            MouseKind::Down if panel.contains((mouse.column, mouse.row).into()) => {
                let row = usize::from(mouse.row - panel.y);
                let rows = rows(panel.height);
                (row < rows).then(|| self.first_row(rows) + row)
            }
            _ => None,
        };
        match at.filter(|at| *at < self.known().len() && !self.removing) {
            Some(at) => {
                self.chosen = at;
                self.notice = None;
                Step::Stay
            }
            None => Step::Ignored,
        }
    }

    /// The first game of the list that is shown in so many rows.
    fn first_row(&self, rows: usize) -> usize {
        let last_start = self.known().len().saturating_sub(rows);
        self.chosen.saturating_sub(rows / 2).min(last_start)
    }

    /// Draws the page: the board of the chosen game, and beside it the list.
    pub(super) fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        let look = cx.settings.look();
        let layout = view::layout(area, false);
        let name = self.chosen().map_or("", |kept| kept.name.as_str());
        layout.draw(buf, &look, name, "saved games");
        let (coins, set) = match self.game() {
            Some((_, game)) => (game.coins(), game.setup().set),
            None => (&[][..], self.options.set),
        };
        picture::of_pack(coins, set, layout.picture).draw(buf, &look);
        let mut lines = Lines::new(layout.panel, buf, look);
        match &self.games {
            Games::Asked => lines.paragraph("Looking …", Role::Text),
            Games::Unknown(reason) => {
                let message = format!("The saved games cannot be looked at: {reason}.");
                lines.paragraph(&message, Role::Warn);
            }
            Games::Known(games) if games.is_empty() => lines.paragraph(
                "There are none yet. Every game is saved by itself, after each stroke.",
                Role::Text,
            ),
            Games::Known(games) => {
                let rows = rows(layout.panel.height);
                let first = self.first_row(rows);
                for (i, kept) in games.iter().enumerate().skip(first).take(rows) {
                    let (mark, role) = if i == self.chosen {
                        (">", Role::Selected)
                    } else {
                        (" ", Role::Text)
                    };
                    let age = kept.age.map(text::ago).unwrap_or_default();
                    lines.pair(&format!("{mark} {}", title(kept)), &age, role, Role::Dim);
                }
            }
        }
        lines.gap();
        self.about(&mut lines);
    }

    /// What is to be said of the chosen game.
    fn about(&self, lines: &mut Lines) {
        let Some(kept) = self.chosen() else {
            return;
        };
        if self.removing {
            lines.paragraph("Remove this game for good?", Role::Warn);
            lines.paragraph("y: remove it. Any other key: keep it.", Role::Key);
            return;
        }
        if let Some(notice) = &self.notice {
            lines.paragraph(notice, Role::Warn);
            lines.gap();
        }
        match &kept.content {
            Ok(game) => {
                lines.paragraph(&about(&game.0, &game.1), Role::Text);
                lines.gap();
                lines.paragraph("Enter: resume it.  v: watch it from its start.", Role::Key);
            }
            Err(reason) => {
                lines.paragraph(&format!("It cannot be read. {reason}."), Role::Warn);
                lines.gap();
                lines.paragraph("The file is left as it is.", Role::Text);
            }
        }
    }

    /// The keys of the page.
    pub(super) fn keys(&self) -> Vec<Hint> {
        let mut keys = Vec::new();
        if self.game().is_some() {
            keys.extend([
                Hint::new("Enter", "resume"),
                Hint::new("v", "replay"),
                Hint::new("e", "export"),
            ]);
        }
        if self.chosen().is_some() {
            keys.extend([Hint::new("Up Down", "choose"), Hint::new("d", "remove")]);
        }
        keys.push(Hint::new("Esc", "back"));
        keys
    }
}

/// Rows of the list in a panel of this height.
fn rows(height: u16) -> usize {
    usize::from(height).saturating_sub(ABOUT).max(3)
}

/// A game in a few words: who plays, and the score.
fn title(kept: &KeptGame) -> String {
    let Ok(game) = &kept.content else {
        return format!("{} ?", kept.name);
    };
    let (saved, game) = &**game;
    let options = Options::of(saved);
    let score = game.score();
    let [first, second] = Team::BOTH.map(|team| options.team_name(team));
    let [a, b] = Team::BOTH.map(|team| match options.rules {
        Rules::Tournament => score.points[team],
        Rules::Friendly | Rules::Practice => score.games[team],
    });
    match options.rules {
        Rules::Practice => "practice".into(),
        Rules::Tournament | Rules::Friendly => format!("{first} {a} : {b} {second}"),
    }
}

/// What else there is to know of it.
fn about(saved: &SavedGame, game: &Game) -> String {
    let options = Options::of(saved);
    let strokes = match saved.record.strokes() {
        1 => "1 stroke".into(),
        strokes => format!("{strokes} strokes"),
    };
    let board = match options.rules {
        Rules::Tournament => format!(", board {}", game.board_number()),
        Rules::Friendly | Rules::Practice => String::new(),
    };
    let rules = words::sentence(words::rules(options.rules));
    let stands = match game.stage() {
        _ if options.rules == Rules::Practice => String::new(),
        Stage::Playing => match options.seat_name(game.seat()) {
            "you" => " It is your turn.".into(),
            name => format!(" It is the turn of {name}."),
        },
        Stage::BoardOver(won) => {
            let winner = options.team_name(won.winner);
            format!(" The board went to {winner}.")
        }
        Stage::GameOver(team) => {
            let winner = words::does(options.team_name(team), "wins");
            format!(" {} the game.", words::sentence(&winner))
        }
        Stage::MatchOver(team) => {
            let winner = words::does(options.team_name(team), "wins");
            format!(" {} the match.", words::sentence(&winner))
        }
    };
    let whose = match saved.player.as_str() {
        // Whoever said no name has none to show.
        "player" => String::new(),
        name => format!("{name}'s game. "),
    };
    format!("{whose}{rules}{board}, {strokes}.{stands}")
}
