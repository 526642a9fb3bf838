//! The table: carrom itself, with what it teaches about each hit.

mod aim;
mod arrange;
mod calls;
mod keys;
mod new_game;
mod options;
mod panel;
mod picture;
mod pointer;
mod preview;
mod replay;
mod saved_games;
mod session;
mod sitting;
mod view;
mod words;

use std::time::Duration;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Context, Help, Hint, Next, OldScreen};
use crate::game::{Game, Record, RecordError};
use crate::messages::{Input, Key};
use new_game::{Agreed, NewGame};
pub use options::{Aids, Options, Player};
use saved_games::{SavedGames, Step};
use sitting::{Sitting, Taken};

/// The table.
#[derive(Debug, Clone)]
pub struct Table {
    page: Page,
}

/// What is on the table.
#[derive(Debug, Clone)]
enum Page {
    /// A new game is agreed.
    NewGame(NewGame),
    /// One is looked for among those that were saved.
    SavedGames(SavedGames),
    /// One is played.
    Sitting(Box<Sitting>),
}

impl Default for Table {
    /// The page on which a new game is agreed.
    fn default() -> Self {
        Self {
            page: Page::NewGame(NewGame::default()),
        }
    }
}

impl Table {
    /// A table at which a game with these options begins at once; `seed` shakes its
    /// packs.
    pub fn playing(options: Options, seed: u64) -> Self {
        Self {
            page: Page::Sitting(Box::new(Sitting::new(options, seed))),
        }
    }

    /// A table at which a recorded game goes on. Rules, hands and pieces are the
    /// record's, whatever the options say.
    ///
    /// # Errors
    /// If the record cannot be played.
    pub fn resuming(options: Options, record: Record) -> Result<Self, RecordError> {
        let sitting = Sitting::resume(options, record)?;
        Ok(Self {
            page: Page::Sitting(Box::new(sitting)),
        })
    }

    /// The game that is played, if one is.
    pub fn game(&self) -> Option<&Game> {
        match &self.page {
            Page::NewGame(_) | Page::SavedGames(_) => None,
            Page::Sitting(sitting) => Some(sitting.game()),
        }
    }

    /// All that is needed to play it again.
    pub fn record(&self) -> Option<&Record> {
        match &self.page {
            Page::NewGame(_) | Page::SavedGames(_) => None,
            Page::Sitting(sitting) => Some(sitting.record()),
        }
    }
}

impl OldScreen for Table {
    fn title(&self) -> String {
        "table".into()
    }

    fn status(&self, _cx: &Context) -> String {
        let options = match &self.page {
            Page::NewGame(page) => &page.options,
            Page::SavedGames(_) => return String::new(),
            Page::Sitting(sitting) => &sitting.options,
        };
        format!(
            "{}   {}",
            words::rules(options.rules),
            words::masses(options.set)
        )
    }

    fn update(&mut self, input: &Input, cx: &mut Context) -> Next {
        match &mut self.page {
            Page::NewGame(page) => {
                let agreed = match input {
                    Input::Key(Key::Escape) => return Next::Back,
                    Input::Key(key) => page.key(*key),
                    Input::Mouse(mouse) => page.mouse(mouse, cx),
                    _ => Agreed::Ignored,
                };
                match agreed {
                    Agreed::Changing => {}
                    Agreed::Play => *self = Self::playing(page.options, cx.next_seed()),
                    Agreed::SavedGames => {
                        self.page = Page::SavedGames(SavedGames::ask(page.options, cx));
                    }
                    Agreed::Ignored => return Next::Ignored,
                }
            }
            Page::SavedGames(page) => match page.update(input, cx) {
                Step::Stay => {}
                Step::Ignored => return Next::Ignored,
                Step::Back => self.page = Page::NewGame(NewGame::with(page.options)),
                Step::Sit(sitting) => self.page = Page::Sitting(sitting),
            },
            Page::Sitting(sitting) => match sitting.update(input, cx) {
                Taken::Used => {}
                Taken::Ignored => return Next::Ignored,
                Taken::Leave => self.page = Page::NewGame(NewGame::with(sitting.options)),
            },
        }
        Next::Stay
    }

    fn advance(&mut self, passed: Duration, cx: &mut Context) -> Next {
        if let Page::Sitting(sitting) = &mut self.page {
            sitting.advance(passed, cx);
        }
        Next::Stay
    }

    fn wake(&self, _cx: &Context) -> Option<Duration> {
        match &self.page {
            Page::NewGame(_) | Page::SavedGames(_) => None,
            Page::Sitting(sitting) => sitting.wake(),
        }
    }

    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        match &self.page {
            Page::NewGame(page) => page.draw(area, buf, cx),
            Page::SavedGames(page) => page.draw(area, buf, cx),
            Page::Sitting(sitting) => view::draw(sitting, area, buf, cx),
        }
    }

    fn keys(&self, _cx: &Context) -> Vec<Hint> {
        match &self.page {
            Page::NewGame(_) => NewGame::keys(),
            Page::SavedGames(page) => page.keys(),
            Page::Sitting(sitting) => keys::keys(sitting),
        }
    }

    fn help(&self, _cx: &Context) -> Help {
        keys::help()
    }
}
