//! The table: carrom itself, with what it teaches about each hit.

mod active_game;
mod aim;
mod arrange;
mod calls;
mod computer_stroke;
mod game_history;
mod keys;
mod new_game;
mod options;
mod panel;
mod picture;
mod pointer;
mod preview;
mod replay;
mod saved_games;
mod tale;
mod trays;
mod view;
mod words;

use std::time::Duration;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Context, Next, Screen};
use crate::messages::Input;
use crate::widgets::input::KeyTable;
use active_game::ActiveGame;
use keys::TableAction;
use new_game::NewGame;
pub use options::{Aids, Options, Player};
use saved_games::SavedGames;

/// The table.
#[derive(Debug, Clone)]
pub struct Table {
    page: TablePage,
}

/// What is on the table.
#[derive(Debug, Clone)]
enum TablePage {
    /// A new game is agreed.
    NewGame(NewGame),
    /// One is looked for among those that were saved.
    SavedGames(Box<SavedGames>),
    /// One is played.
    Playing(Box<ActiveGame>),
}

impl Default for Table {
    /// The page on which a new game is agreed.
    fn default() -> Self {
        Self {
            page: TablePage::NewGame(NewGame::default()),
        }
    }
}

impl Table {
    /// A table at which a game with these options begins at once; `seed` shakes its
    /// packs.
    pub fn playing(options: Options, seed: u64) -> Self {
        Self {
            page: TablePage::Playing(Box::new(ActiveGame::new(options, seed))),
        }
    }
}

/// The page of a new game, with what was agreed last time.
fn agreeing(options: Options) -> TablePage {
    TablePage::NewGame(NewGame {
        options,
        ..NewGame::default()
    })
}

impl Screen for Table {
    type Action = TableAction;

    fn title(&self) -> String {
        "table".into()
    }

    fn status(&self, _cx: &Context) -> String {
        let options = match &self.page {
            TablePage::NewGame(page) => &page.options,
            TablePage::SavedGames(_) => return String::new(),
            TablePage::Playing(game) => &game.options,
        };
        let rules = <&str>::from(options.rules);
        format!("{rules}   {}", words::masses(options.set))
    }

    fn keys(&self, _cx: &Context) -> KeyTable<TableAction> {
        match &self.page {
            TablePage::NewGame(page) => keys::new_game(page),
            TablePage::SavedGames(page) => page.keys(),
            TablePage::Playing(game) => keys::keys(game),
        }
    }

    fn about(&self, _cx: &Context) -> Vec<&'static str> {
        keys::about()
    }

    fn act(&mut self, action: TableAction, cx: &mut Context) -> Next {
        match &mut self.page {
            TablePage::NewGame(page) => match action {
                TableAction::Agree(action) => page.act(action),
                TableAction::Play => *self = Self::playing(page.options, cx.next_seed()),
                TableAction::SavedGames => {
                    let saved = SavedGames::ask(page.options, cx);
                    self.page = TablePage::SavedGames(Box::new(saved));
                }
                TableAction::Back => return Next::Back,
                _ => {}
            },
            TablePage::SavedGames(page) => match action {
                TableAction::Back => self.page = agreeing(page.options),
                action => return page.act(action, cx),
            },
            TablePage::Playing(game) => match game.act(action, cx) {
                Next::Back => self.page = agreeing(game.options),
                next => return next,
            },
        }
        Next::Stay
    }

    fn confirmed(&mut self, _action: TableAction, cx: &mut Context) -> Next {
        match &mut self.page {
            TablePage::NewGame(_) => {}
            TablePage::SavedGames(page) => page.files.remove(cx),
            TablePage::Playing(game) => self.page = agreeing(game.options),
        }
        Next::Stay
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        match (input, &mut self.page) {
            (Input::Mouse(mouse), TablePage::NewGame(page)) => match page.plays(mouse, cx) {
                true => self.act(TableAction::Play, cx),
                false => page.mouse(mouse, cx),
            },
            (Input::Mouse(mouse), TablePage::SavedGames(page)) => page.mouse(mouse, cx),
            (Input::Kept(answer), TablePage::SavedGames(page)) => {
                if let Some(game) = page.take_answer(answer, cx) {
                    self.page = TablePage::Playing(game);
                }
                Next::Stay
            }
            (input, TablePage::Playing(game)) => game.input(input, cx),
            _ => Next::Ignored,
        }
    }

    fn advance(&mut self, passed: Duration, cx: &mut Context) {
        if let TablePage::Playing(game) = &mut self.page {
            game.advance(passed, cx);
        }
    }

    fn wake(&self, cx: &Context) -> Option<Duration> {
        match &self.page {
            TablePage::Playing(game) => game.wake(cx.settings.pace()),
            _ => None,
        }
    }

    fn draw(&self, _area: Rect, buf: &mut Buffer, cx: &Context) {
        match &self.page {
            TablePage::NewGame(page) => page.draw(buf, cx),
            TablePage::SavedGames(page) => page.draw(buf, cx),
            TablePage::Playing(game) => view::draw(game, buf, cx),
        }
    }
}
