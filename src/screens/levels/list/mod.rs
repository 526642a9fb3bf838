//! The list of levels: those that have been won, and the one to win next, are marked.

mod view;

use crate::levels::Shelf;
use crate::messages::{Input, Key, StoreReply, StoreRequest};
use crate::screens::{Context, Next, Route, Screen, View};
use crate::widgets::Outcome;
use crate::widgets::input::{KeyTable, ListAction, ListView};

/// The list of levels. The [`Shelf`] records which level is chosen.
#[derive(Debug, Clone, Default)]
pub(crate) struct Levels {
    /// Whether the player has moved the mark.
    moved: bool,
}

/// What the keys do in the list of levels.
#[derive(Debug, Clone, Copy, PartialEq, strum::IntoStaticStr, strum::EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum LevelsAction {
    /// choose a level, and play it
    List(ListAction),
    /// go to the first level you have never won
    NextToWin,
    /// open the board of the day
    Board,
    /// go back
    Back,
}

impl Levels {
    /// The list, at the first level that is not known to have been won. Requests the levels won
    /// earlier; when they arrive, the mark moves to the next level to win.
    pub(crate) fn new(cx: &mut Context) -> Self {
        cx.shelf.at = cx.shelf.next().unwrap_or(0);
        let player = cx.settings.player.clone();
        cx.ask(StoreRequest::Stars(player));
        Self::default()
    }
}

/// The number of lines that can be chosen: the levels, and after them the problems.
fn choices(shelf: &Shelf) -> usize {
    shelf.count() + shelf.library().problems.len()
}

impl Screen for Levels {
    type Action = LevelsAction;

    const HELP: &'static str = include_str!("help.txt");
    const TITLE: &'static str = "levels";
    const ROUTE: Route = Route::Levels;

    fn status(&self, cx: &Context) -> String {
        let shelf = &cx.shelf;
        let won = (0..shelf.count()).filter(|number| shelf.stars(*number) > 0);
        format!("{} of {} won", won.count(), shelf.count())
    }

    fn keys(&self, _cx: &Context) -> KeyTable<LevelsAction> {
        KeyTable::new("levels")
            .with(ListView::keys("play"), LevelsAction::List)
            .on(Key::Char('n'), LevelsAction::NextToWin, "next to win")
            .on('b', LevelsAction::Board, "board")
            .on(Key::Escape, LevelsAction::Back, "back")
    }

    fn act(&mut self, action: LevelsAction, cx: &mut Context) -> Next {
        let mut list = ListView::at(cx.shelf.at);
        let outcome = match action {
            LevelsAction::List(action) => list.act(action, choices(&cx.shelf)),
            LevelsAction::NextToWin => {
                list.choose(cx.shelf.next().unwrap_or(cx.shelf.at));
                Outcome::Used
            }
            LevelsAction::Board => return Next::Open(Route::Board(None)),
            LevelsAction::Back => return Next::Back,
        };
        cx.shelf.at = list.chosen(choices(&cx.shelf));
        self.moved = true;
        match outcome {
            // The lines after the levels are problems, which cannot be opened.
            Outcome::Done(number) if number < cx.shelf.count() => Next::Open(Route::Level(number)),
            _ => Next::Stay,
        }
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        match input {
            Input::Kept(answer) if matches!(answer.done, StoreReply::Stars(_)) && !self.moved => {
                cx.shelf.at = cx.shelf.next().unwrap_or(0);
                Next::Stay
            }
            _ => Next::Ignored,
        }
    }

    fn wheel(&mut self, by: i8, cx: &mut Context) -> Next {
        self.act(LevelsAction::List(ListAction::Choose(by.into())), cx)
    }

    fn view<'s>(&'s self, cx: &'s Context) -> View<'s, LevelsAction> {
        view::view(&cx.shelf)
    }
}
