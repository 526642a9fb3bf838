//! The page of saved games: to resume one, watch it again, export or remove it.

use ratatui::buffer::Buffer;

use super::active_game::ActiveGame;
use super::keys::TableAction;
use super::options::Options;
use super::{picture, words};
use crate::game::{ByTeam, Game, GameStage, Rules, SavedGame, Team};
use crate::messages::{KeptGame, Key, Mouse, StoreAnswer, StoreReply, StoreRequest};
use crate::numbers::{capital, counted};
use crate::screens::kept_files::{KeptFiles, KeptKind};
use crate::screens::{Context, Next};
use crate::widgets::input::KeyTable;
use crate::widgets::{Lines, Role, SplitLayout};

/// Games as files.
const GAMES: KeptKind = KeptKind {
    one: "game",
    all: "saved games",
    saved: "Every game is saved by itself, after each stroke.",
    about: 11,
    list: StoreRequest::List,
    load: StoreRequest::Load,
    remove: StoreRequest::Remove,
};

/// The page.
#[derive(Debug, Clone)]
pub(super) struct SavedGames {
    /// For the page to go back to.
    pub(super) options: Options,
    pub(super) files: KeptFiles<(SavedGame, Game)>,
    /// The ticket of a game that is to be watched from its beginning.
    watch: Option<u64>,
}

impl SavedGames {
    /// The page, with the games asked for; `options` are those of the page before.
    pub(super) fn ask(options: Options, cx: &mut Context) -> Self {
        Self {
            options,
            files: KeptFiles::ask(GAMES, cx),
            watch: None,
        }
    }

    /// The keys of the page.
    pub(super) fn keys(&self) -> KeyTable<TableAction> {
        let open = self.files.content().is_some();
        KeyTable::new("table")
            .with(self.files.keys("resume"), TableAction::Saved)
            .on('v', TableAction::WatchAll, "replay")
            .when(open)
            .on('e', TableAction::Export, "export")
            .when(open)
            .on(Key::Escape, TableAction::Back, "back")
    }

    /// Does what a key stands for.
    pub(super) fn act(&mut self, action: TableAction, cx: &mut Context) -> Next {
        match action {
            TableAction::Saved(action) => return self.files.act(action, cx),
            TableAction::WatchAll => self.watch = self.files.load(cx),
            TableAction::Export => {
                if let Some((saved, _)) = self.files.content() {
                    cx.ask(StoreRequest::Export(Box::new(saved.clone())));
                }
            }
            _ => {}
        }
        Next::Stay
    }

    /// Takes the mouse.
    pub(super) fn mouse(&mut self, mouse: &Mouse, cx: &mut Context) -> Next {
        let list = SplitLayout::square(cx.room()).panel;
        self.files.mouse(mouse, list, cx)
    }

    /// Takes in what came of what was asked; gives the game that is to be gone on with.
    pub(super) fn take_answer(
        &mut self,
        answer: &StoreAnswer,
        cx: &mut Context,
    ) -> Option<Box<ActiveGame>> {
        match &answer.done {
            StoreReply::Listed(games) => self.files.listed(games.clone()),
            StoreReply::Loaded(loaded) if self.files.take_loaded(answer.ticket) => {
                let active = loaded.clone().and_then(|saved| {
                    let active = ActiveGame::resume_saved(&saved, answer.ticket);
                    active.map_err(|error| error.to_string())
                });
                match active {
                    Ok(mut active) => {
                        if self.watch == Some(answer.ticket) {
                            active.watch_all(cx);
                        }
                        return Some(Box::new(active));
                    }
                    Err(reason) => {
                        self.files.notice = Some(format!("It cannot be resumed: {reason}."));
                    }
                }
            }
            StoreReply::Removed(result) => self.files.removed(result, cx),
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
    pub(super) fn draw(&self, buf: &mut Buffer, cx: &Context) {
        let look = cx.settings.look();
        let layout = SplitLayout::square(cx.room());
        let name = self.files.chosen().map_or("", |kept| kept.name.as_str());
        layout.draw(buf, &look, name, "saved games");
        let (coins, set) = match self.files.content() {
            Some((_, game)) => (game.coins(), game.setup().set),
            None => (&[][..], self.options.set),
        };
        picture::of_pack(coins, set, layout.picture).draw(buf, &look);
        let mut lines = Lines::new(layout.panel, buf, look);
        self.files.write(title, &mut lines);
        self.files.write_about(&mut lines, |(saved, game), lines| {
            lines.paragraph(&about(saved, game), Role::Text);
            lines.gap();
            lines.paragraph("Enter: resume it.  v: watch it from its start.", Role::Key);
        });
    }
}

/// A game in a few words: who plays, and the score.
fn title(kept: &KeptGame) -> String {
    let Ok(game) = &kept.content else {
        return format!("{} ?", kept.name);
    };
    let (saved, game) = &**game;
    let options = Options::of(saved);
    match options.rules {
        Rules::Practice => "practice".into(),
        Rules::Tournament if game.score().games != ByTeam::default() => {
            let [first, second] = Team::BOTH.map(|team| game.score().games[team]);
            format!("{} ({first} : {second})", options.score(game))
        }
        Rules::Tournament | Rules::Friendly => options.score(game),
    }
}

/// What else there is to know of it.
fn about(saved: &SavedGame, game: &Game) -> String {
    let options = Options::of(saved);
    let strokes = counted(saved.record.strokes(), "stroke");
    let (board, games) = match options.rules {
        Rules::Tournament => {
            let [first, second] = Team::BOTH.map(|team| game.score().games[team]);
            let board = game.board_number();
            (
                format!(", board {board}"),
                format!(", games won {first} : {second}"),
            )
        }
        Rules::Friendly | Rules::Practice => Default::default(),
    };
    let rules = capital(options.rules.into());
    let stands = match game.stage() {
        _ if options.rules == Rules::Practice => String::new(),
        GameStage::Playing => match options.seat_name(game.seat()) {
            "you" => " It is your turn.".into(),
            name => format!(" It is the turn of {}.", words::player(name)),
        },
        GameStage::BoardOver(won) => {
            let winner = words::player(options.team_name(won.winner));
            format!(" The board went to {winner}.")
        }
        GameStage::GameOver(team) => format!(" {}.", options.wins(team, "game")),
        GameStage::MatchOver(team) => format!(" {}.", options.wins(team, "match")),
    };
    let whose = match saved.player.as_str() {
        // Whoever said no name has none to show.
        "player" => String::new(),
        name => format!("{name}'s game. "),
    };
    format!("{whose}{rules}{board}, {strokes}{games}.{stands}")
}
