//! The page of saved games: to resume one, watch it again, export or remove it.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::active_game::ActiveGame;
use super::keys::TableAction;
use super::options::Options;
use super::{picture, view, words};
use crate::game::{Game, GameStage, Rules, SavedGame, Team};
use crate::messages::{Input, KeptGame, Key, StoreAnswer, StoreReply, StoreRequest};
use crate::screens::kept_files::{KeptAction, KeptFiles};
use crate::screens::{Context, Next};
use crate::widgets::input::KeyTable;
use crate::widgets::{Lines, Outcome, Role};

/// Rows below the list for what is to be said of the chosen game.
const ABOUT: usize = 11;

/// The page.
#[derive(Debug, Clone)]
pub(super) struct SavedGames {
    /// For the page to go back to.
    pub(super) options: Options,
    files: KeptFiles<(SavedGame, Game)>,
    /// Whether the game on its way is to be watched from its beginning.
    watch: bool,
}

impl SavedGames {
    /// The page, with the games asked for; `options` are those of the page before.
    pub(super) fn ask(options: Options, cx: &mut Context) -> Self {
        cx.ask(StoreRequest::List);
        Self {
            options,
            files: KeptFiles::default(),
            watch: false,
        }
    }

    /// The keys of the page.
    pub(super) fn keys(&self) -> KeyTable<TableAction> {
        let open = self.files.content().is_some();
        KeyTable::new("table")
            .with(self.files.keys("resume"), TableAction::Saved)
            .on(Key::Char('v'), TableAction::WatchAll, "replay")
            .when(open)
            .on(Key::Char('e'), TableAction::Export, "export")
            .when(open)
            .on(Key::Escape, TableAction::Back, "back")
    }

    /// Does what a key stands for.
    pub(super) fn act(&mut self, action: TableAction, cx: &mut Context) -> Next {
        match action {
            TableAction::Saved(KeptAction::Remove) => {
                return Next::Confirm(KeptFiles::<()>::ask_to_remove("game"));
            }
            TableAction::Saved(KeptAction::List(action)) => {
                if let Outcome::Done(()) = self.files.act(action) {
                    self.load(false, cx);
                }
            }
            TableAction::WatchAll => self.load(true, cx),
            TableAction::Export => {
                if let Some((saved, _)) = self.files.content() {
                    cx.ask(StoreRequest::Export(Box::new(saved.clone())));
                }
            }
            _ => {}
        }
        Next::Stay
    }

    /// Removes the chosen game.
    pub(super) fn remove(&self, cx: &mut Context) {
        if let Some(game) = self.files.chosen() {
            cx.ask(StoreRequest::Remove(game.name.clone()));
        }
    }

    /// Takes an input that is no key; done with the game that was chosen, once it is there.
    pub(super) fn input(&mut self, input: &Input, cx: &mut Context) -> Outcome<Box<ActiveGame>> {
        match input {
            Input::Mouse(mouse) => {
                let panel = view::layout(cx.body, false).panel;
                let rows = rows(panel.height);
                let row = panel.contains((mouse.column, mouse.row).into());
                let row = row.then(|| usize::from(mouse.row - panel.y));
                let row = row.filter(|row| *row < rows);
                let line = row.map(|row| self.files.first_row(rows) + row);
                match self.files.mouse(mouse, line) {
                    Outcome::Ignored => return Outcome::Ignored,
                    Outcome::Done(()) => self.load(false, cx),
                    Outcome::Used => {}
                }
                Outcome::Used
            }
            Input::Kept(answer) => {
                let game = self.take_answer(answer, cx);
                game.map_or(Outcome::Used, Outcome::Done)
            }
            _ => Outcome::Ignored,
        }
    }

    fn load(&mut self, watch: bool, cx: &mut Context) {
        if let Some(game) = self.files.chosen() {
            let ticket = cx.ask(StoreRequest::Load(game.name.clone()));
            self.watch = watch;
            self.files.load(ticket);
        }
    }

    fn take_answer(&mut self, answer: &StoreAnswer, cx: &mut Context) -> Option<Box<ActiveGame>> {
        match &answer.done {
            StoreReply::Listed(games) => self.files.listed(games.clone()),
            StoreReply::Loaded(loaded) if self.files.take_loaded(answer.ticket) => {
                let active = loaded.as_ref().map_err(Clone::clone).and_then(|saved| {
                    let active = ActiveGame::resume_saved(saved, answer.ticket);
                    active.map_err(|error| error.to_string())
                });
                match active {
                    Ok(mut active) => {
                        if self.watch {
                            active.watch_all(cx);
                        }
                        return Some(Box::new(active));
                    }
                    Err(reason) => {
                        self.files.notice = Some(format!("It cannot be resumed: {reason}."));
                    }
                }
            }
            StoreReply::Removed(result) => {
                self.files.removed(result);
                cx.ask(StoreRequest::List);
            }
            StoreReply::Exported(result) => {
                self.files.notice = Some(match result {
                    Ok(place) => format!("It is written to {place}"),
                    Err(reason) => format!("It cannot be exported: {reason}."),
                });
            }
            _ => {}
        }
        None
    }

    /// Draws the page: the board of the chosen game, and beside it the list.
    pub(super) fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        let look = cx.settings.look();
        let layout = view::layout(area, false);
        let name = self.files.chosen().map_or("", |kept| kept.name.as_str());
        layout.draw(buf, &look, name, "saved games");
        let (coins, set) = match self.files.content() {
            Some((_, game)) => (game.coins(), game.setup().set),
            None => (&[][..], self.options.set),
        };
        picture::of_pack(coins, set, layout.picture).draw(buf, &look);
        let mut lines = Lines::new(layout.panel, buf, look);
        let what = (
            "saved games",
            "Every game is saved by itself, after each stroke.",
        );
        let rows = rows(layout.panel.height);
        self.files.write(rows, what, title, &mut lines);
        self.files.write_about(&mut lines, |(saved, game), lines| {
            lines.paragraph(&about(saved, game), Role::Text);
            lines.gap();
            lines.paragraph("Enter: resume it.  v: watch it from its start.", Role::Key);
        });
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
        GameStage::Playing => match options.seat_name(game.seat()) {
            "you" => " It is your turn.".into(),
            name => format!(" It is the turn of {name}."),
        },
        GameStage::BoardOver(won) => {
            let winner = options.team_name(won.winner);
            format!(" The board went to {winner}.")
        }
        GameStage::GameOver(team) => {
            let winner = words::does(options.team_name(team), "wins");
            format!(" {} the game.", words::sentence(&winner))
        }
        GameStage::MatchOver(team) => {
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
