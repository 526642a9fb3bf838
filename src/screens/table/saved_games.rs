//! The page of saved games: to resume one, watch it again, export or remove it.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::active_game::ActiveGame;
use super::keys::TableAction;
use super::options::Options;
use super::{picture, view, words};
use crate::game::{Game, Rules, SavedGame, Stage, Team};
use crate::messages::{Input, KeptGame, Key, StoreAnswer, StoreReply, StoreRequest};
use crate::screens::{Context, Next, Question};
use crate::widgets::input::{KeyTable, ListView};
use crate::widgets::{Lines, Outcome, Role, text};

/// Rows below the list for what is to be said of the chosen game.
const ABOUT: u16 = 11;

/// The page.
#[derive(Debug, Clone)]
pub(super) struct SavedGames {
    /// For the page to go back to.
    pub(super) options: Options,
    games: Games,
    list: ListView,
    /// A game on its way, and whether to watch it from its beginning.
    loading: Option<(u64, bool)>,
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

impl SavedGames {
    /// The page, with the games asked for; `options` are those of the page before.
    pub(super) fn ask(options: Options, cx: &mut Context) -> Self {
        cx.ask(StoreRequest::List);
        Self {
            options,
            games: Games::Asked,
            list: ListView::default(),
            loading: None,
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
        self.known().get(self.list.chosen(self.known().len()))
    }

    /// The chosen game, if it can be read.
    fn game(&self) -> Option<&(SavedGame, Game)> {
        self.chosen()?.content.as_deref().ok()
    }

    /// The keys of the page.
    pub(super) fn keys(&self) -> KeyTable<TableAction> {
        use TableAction::{Back, Export, Remove, Saved, WatchAll};
        let open = self.game().is_some();
        let list = ListView::keys(if open { "resume" } else { "" });
        KeyTable::new("table")
            .with(list, Saved)
            .on(Key::Char('v'), WatchAll, "replay")
            .when(open)
            .on(Key::Char('e'), Export, "export")
            .when(open)
            .on(Key::Char('d'), Remove, "remove")
            .or([(Key::Delete, Remove)])
            .when(self.chosen().is_some())
            .on(Key::Escape, Back, "back")
    }

    /// Does what a key stands for.
    pub(super) fn act(&mut self, action: TableAction, cx: &mut Context) {
        self.notice = None;
        match action {
            TableAction::Saved(action) => {
                let outcome = self.list.act(action, self.known().len());
                self.open(outcome, cx);
            }
            TableAction::WatchAll => self.load(true, cx),
            TableAction::Export => self.export(cx),
            _ => {}
        }
    }

    /// Asks whether to remove the chosen game.
    pub(super) fn ask_to_remove(&self) -> Next {
        Next::Confirm(Question::new(
            "Remove this game for good?",
            "remove it",
            "keep it",
        ))
    }

    /// Removes the chosen game.
    pub(super) fn remove(&mut self, cx: &mut Context) {
        if let Some(game) = self.chosen() {
            let request = StoreRequest::Remove(game.name.clone());
            cx.ask(request);
        }
    }

    fn open(&mut self, outcome: Outcome<usize>, cx: &mut Context) {
        if let Outcome::Done(_) = outcome {
            self.load(false, cx);
        }
    }

    /// Takes an input that is no key; done with the game that was chosen, once it is there.
    pub(super) fn input(&mut self, input: &Input, cx: &mut Context) -> Outcome<Box<ActiveGame>> {
        match input {
            Input::Mouse(mouse) => {
                let panel = view::layout(cx.body, false).panel;
                let row = panel.contains((mouse.column, mouse.row).into());
                let row = row.then(|| usize::from(mouse.row - panel.y));
                let line = row.filter(|row| *row < rows(panel.height).into());
                let line = line.map(|row| self.first_row(panel.height) + row);
                let line = line.filter(|line| *line < self.known().len());
                self.notice = None;
                let outcome = self.list.mouse(mouse, self.known().len(), line);
                self.open(outcome, cx);
                match outcome {
                    Outcome::Ignored => Outcome::Ignored,
                    _ => Outcome::Used,
                }
            }
            Input::Kept(answer) => {
                let game = self.take_answer(answer, cx);
                game.map_or(Outcome::Used, Outcome::Done)
            }
            _ => Outcome::Ignored,
        }
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

    fn take_answer(&mut self, answer: &StoreAnswer, cx: &mut Context) -> Option<Box<ActiveGame>> {
        match &answer.done {
            StoreReply::Listed(Ok(games)) => {
                self.games = Games::Known(games.clone());
            }
            StoreReply::Listed(Err(reason)) => self.games = Games::Unknown(reason.clone()),
            StoreReply::Loaded(loaded) => {
                let Some((ticket, watch)) = self.loading.filter(|(it, _)| *it == answer.ticket)
                else {
                    return None;
                };
                self.loading = None;
                let active = loaded.as_ref().map_err(Clone::clone).and_then(|saved| {
                    ActiveGame::resume_saved(saved, ticket).map_err(|error| error.to_string())
                });
                match active {
                    Ok(mut active) => {
                        if watch {
                            active.watch_all(cx);
                        }
                        return Some(Box::new(active));
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
        None
    }

    /// The first game of the list that is shown in a panel of this height.
    fn first_row(&self, height: u16) -> usize {
        let count = self.known().len();
        ListView::first_shown(self.list.chosen(count), count, rows(height))
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
                let first = self.first_row(layout.panel.height);
                let chosen = self.list.chosen(games.len());
                for (i, kept) in games.iter().enumerate().skip(first).take(rows.into()) {
                    let (mark, role) = if i == chosen {
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
}

/// Rows of the list in a panel of this height.
fn rows(height: u16) -> u16 {
    height.saturating_sub(ABOUT).max(3)
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
