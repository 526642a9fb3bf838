//! The table: carrom itself, with explanations of each collision.

mod active_game;
mod aim;
mod board_page;
mod board_report;
mod calls;
mod computer_stroke;
mod duration;
mod game_history;
mod new_game;
mod options;
mod picture;
mod pointer;
mod preview;
mod saved_games;
mod words;

use std::time::Duration;

use ratatui::layout::Rect;

use super::{Context, Next, Route, Screen, View};
use crate::game::{BoardCode, GameSetup, Rules};
use crate::messages::{Input, Key, Mouse};
use crate::numbers::fixed;
use crate::widgets::input::{FormAction, KeyTable, RayAction};
use crate::widgets::panel::Panel;
use active_game::{ActiveGame, AimAction, ArrangeAction, GameAction, Playing, StrokeAction};
use board_page::{BoardAction, BoardPage};
use new_game::{NewGame, NewGameAction};
pub use options::Options;
use saved_games::{SavedGames, SavedGamesAction};

type TablePanel = Panel<TableAction>;

/// The table.
#[derive(Debug, Clone)]
pub struct Table {
    page: TablePage,
}

/// The pages of the table.
#[derive(Debug, Clone)]
enum TablePage {
    /// Choosing the options of a new game.
    NewGame(Box<NewGame>),
    /// A board for one player, before it is played.
    Board(Box<BoardPage>),
    /// Choosing a saved game.
    Saved(Box<SavedGames>),
    Playing(Box<Playing>),
}

/// What the keys do at the table: each page and each phase of a game has its own actions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TableAction {
    /// On the page of a new game.
    NewGame(NewGameAction),
    /// On the page of a board for one player.
    Board(BoardAction),
    /// On the page of saved games.
    Saved(SavedGamesAction),
    /// In several phases of a game.
    Game(GameAction),
    /// While aiming.
    Aim(AimAction),
    /// While the player is making a call.
    Call(RayAction),
    /// While a stroke is being watched.
    Watch(StrokeAction),
    /// While coins are being arranged.
    Arrange(ArrangeAction),
}

impl Table {
    /// Opens the page of a new game, with the given options or with those of the player's last game.
    pub(crate) fn new_game(options: Option<Options>, cx: &mut Context) -> Self {
        Self {
            page: TablePage::NewGame(Box::new(NewGame::ask(options, cx))),
        }
    }

    /// Opens the page of the board with this code, or of today's board.
    pub(crate) fn board(code: Option<BoardCode>, cx: &mut Context) -> Self {
        Self {
            page: TablePage::Board(Box::new(BoardPage::ask(code, cx))),
        }
    }

    /// Opens the page on which another game like this one can be started.
    fn after(game: &ActiveGame, cx: &mut Context) -> Self {
        match game.game().setup().board_code() {
            Some(code) => Self::board(Some(code), cx),
            None => Self::new_game(Some(game.options.clone()), cx),
        }
    }

    /// The settings of the game that is being played or chosen.
    fn setup(&self) -> Option<&GameSetup> {
        match &self.page {
            TablePage::NewGame(page) => Some(&page.options.setup),
            TablePage::Playing(playing) => Some(&playing.game.options.setup),
            TablePage::Board(_) | TablePage::Saved(_) => None,
        }
    }

    /// A table at which a game with these options begins at once; `seed` determines its opening
    /// packs.
    pub fn playing(options: Options, seed: u64) -> Self {
        let game = Playing::from(ActiveGame::new(options, seed));
        Self {
            page: TablePage::Playing(Box::new(game)),
        }
    }
}

impl Screen for Table {
    type Action = TableAction;

    const HELP: &'static str = include_str!("help.txt");
    const TITLE: &'static str = "table";

    fn route(&self, _cx: &Context) -> Route {
        let code = match &self.page {
            TablePage::Board(page) => return Route::Board(page.code),
            TablePage::Playing(playing) => playing.game.game().setup().board_code(),
            TablePage::NewGame(_) | TablePage::Saved(_) => None,
        };
        code.map_or(Route::Table, |code| Route::Board(Some(code)))
    }

    fn status(&self, _cx: &Context) -> String {
        let Some(setup) = self.setup() else {
            return String::new();
        };
        let rules = <&str>::from(setup.rules);
        let (masses, e) = (words::masses(setup.set), fixed(setup.restitution, 2));
        format!("{rules}   {masses}   e = {e}")
    }

    fn keys(&self, _cx: &Context) -> KeyTable<TableAction> {
        match &self.page {
            TablePage::NewGame(page) => page.keys().map(TableAction::NewGame),
            TablePage::Board(page) => page.keys().map(TableAction::Board),
            TablePage::Saved(page) => page.keys().map(TableAction::Saved),
            TablePage::Playing(playing) => playing.keys(),
        }
    }

    fn rules(&self) -> Option<Rules> {
        match &self.page {
            TablePage::Board(_) => Some(Rules::Solo),
            _ => self.setup().map(|setup| setup.rules),
        }
    }

    fn typed(&mut self, key: Key, _cx: &mut Context) -> bool {
        match &mut self.page {
            TablePage::NewGame(page) => page.typed(key),
            _ => false,
        }
    }

    fn act(&mut self, action: TableAction, cx: &mut Context) -> Next {
        match (&mut self.page, action) {
            (TablePage::NewGame(page), TableAction::NewGame(action)) => match action {
                NewGameAction::Agree(action) => page.agree(action),
                NewGameAction::Play => {
                    if let Some(options) = page.chosen() {
                        *self = Self::playing(options, cx.next_seed());
                    }
                }
                NewGameAction::SavedGames => {
                    let saved = SavedGames::ask(page.options.clone(), cx);
                    self.page = TablePage::Saved(Box::new(saved));
                }
                NewGameAction::Board => return Next::Open(Route::Board(None)),
                NewGameAction::Rules => return Next::Open(Route::Rules(page.options.setup.rules)),
                NewGameAction::Back => return Next::Back,
            },
            (TablePage::Board(page), TableAction::Board(action)) => match (action, page.code) {
                (BoardAction::Play, Some(code)) => {
                    let game = ActiveGame::on_board(code, page.par);
                    self.page = TablePage::Playing(Box::new(game.into()));
                }
                (BoardAction::Rules, _) => return Next::Open(Route::Rules(Rules::Solo)),
                (BoardAction::Back, _) => return Next::Back,
                (action, _) => page.act(action),
            },
            (TablePage::Saved(page), TableAction::Saved(action)) => match page.act(action, cx) {
                Next::Back => *self = Self::new_game(Some(page.options.clone()), cx),
                next => return next,
            },
            (TablePage::Playing(playing), action) => match playing.act(action, cx) {
                Next::Back => *self = Self::after(&playing.game, cx),
                next => return next,
            },
            _ => {}
        }
        Next::Stay
    }

    fn confirmed(&mut self, action: TableAction, cx: &mut Context) -> Next {
        match (&mut self.page, action) {
            (TablePage::Saved(page), _) => page.files.remove(cx),
            // While the question was open, a saved game has been loaded.
            (TablePage::Playing(_), TableAction::Saved(_)) => {}
            (TablePage::Playing(playing), _) => *self = Self::after(&playing.game, cx),
            (TablePage::NewGame(_) | TablePage::Board(_), _) => {}
        }
        Next::Stay
    }

    fn view<'s>(&'s self, cx: &'s Context) -> View<'s, TableAction> {
        match &self.page {
            TablePage::NewGame(page) => page.view(),
            TablePage::Board(page) => page.view(),
            TablePage::Saved(page) => page.view(),
            TablePage::Playing(playing) => playing.view(cx.settings.charset),
        }
    }

    fn point(&mut self, mouse: &Mouse, picture: Rect, cx: &mut Context) -> Next {
        match &mut self.page {
            TablePage::NewGame(_) if mouse.presses(picture) => {
                self.act(TableAction::NewGame(NewGameAction::Play), cx)
            }
            TablePage::Board(_) if mouse.presses(picture) => {
                self.act(TableAction::Board(BoardAction::Play), cx)
            }
            TablePage::Playing(playing) => playing.point(mouse, picture, cx),
            _ => Next::Ignored,
        }
    }

    fn wheel(&mut self, by: i8, cx: &mut Context) -> Next {
        match &mut self.page {
            TablePage::NewGame(_) => {
                let next = NewGameAction::Agree(FormAction::Choose(by.into()));
                self.act(TableAction::NewGame(next), cx)
            }
            TablePage::Board(_) => {
                self.act(TableAction::Board(BoardAction::Neighbour(by.signum())), cx)
            }
            TablePage::Saved(page) => page.files.wheel(by, cx),
            TablePage::Playing(playing) => playing.wheel(by, cx),
        }
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        let answer = match (input, &mut self.page) {
            (Input::Kept(answer), _) => answer,
            (Input::Paste(text), TablePage::NewGame(page)) => {
                return Next::after(page.form.paste(text, &mut page.options));
            }
            _ => return Next::Ignored,
        };
        match &mut self.page {
            TablePage::NewGame(page) => page.take_answer(answer, cx),
            TablePage::Board(page) => page.take_answer(answer, cx),
            TablePage::Saved(page) => {
                if let Some(playing) = page.take_answer(answer, cx) {
                    self.page = TablePage::Playing(playing);
                }
            }
            TablePage::Playing(playing) => playing.game.take_answer(answer),
        }
        Next::Stay
    }

    fn advance(&mut self, passed: Duration, cx: &mut Context) {
        if let TablePage::Playing(playing) = &mut self.page {
            playing.advance(passed, cx);
        }
    }

    fn wake(&self, cx: &Context) -> Option<Duration> {
        match &self.page {
            TablePage::Playing(playing) => playing.wake(cx.settings.pace()),
            _ => None,
        }
    }
}
