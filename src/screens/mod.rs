//! The screens: one folder each, with the state and its updates, and a separate file for the view.

mod ahead;
mod context;
mod hosted;
mod kept_files;
mod leads;
mod recall;
mod route;
mod strike_guard;
mod view;

pub(crate) mod class;
pub(crate) mod foil;
pub(crate) mod glossary;
pub(crate) mod home;
pub(crate) mod join;
pub(crate) mod lab;
pub mod learn;
pub(crate) mod levels;
pub(crate) mod measured;
pub(crate) mod progress;
pub(crate) mod quiz;
pub(crate) mod rules;
pub(crate) mod settings;
pub mod table;
pub(crate) mod teacher;

use std::time::Duration;

use ratatui::layout::Rect;

pub use context::Context;
pub use hosted::{AnyScreen, Hosted, SharedAction};
#[cfg(not(target_family = "wasm"))]
pub(crate) use join::{code_of, host_of};
pub use route::{FoilPage, Route};
pub use settings::{KeptSettings, Settings};
pub(crate) use strike_guard::StrikeGuard;
pub use view::View;

use crate::game::Rules;
use crate::messages::{Input, Key, Mouse};
use crate::widgets::Outcome;
use crate::widgets::input::KeyTable;

/// A screen of the app: it handles input, advances with time and draws itself.
///
/// A screen is pure: it reads no clock and touches no file. One table defines what its keys do; key
/// presses are looked up in it, and the bottom line and the help page are derived from it. Keys
/// that are not in the table belong to the app.
pub trait Screen {
    /// The actions of the keys.
    type Action: Copy + PartialEq;

    /// The help page's introduction: what the screen is for and how to begin, one paragraph per
    /// line.
    const HELP: &'static str;

    /// The screen's name for the title line, in lower case, if it is always the same.
    const TITLE: &'static str = "";

    /// The route that opens this screen, if it is always the same.
    const ROUTE: Route = Route::Home;

    /// The screen's name for the title line.
    fn title(&self) -> String {
        Self::TITLE.into()
    }

    /// The route that opens this screen in its current state.
    fn route(&self, _cx: &Context) -> Route {
        Self::ROUTE
    }

    /// The rest of the title line: a short summary of the screen's state.
    fn status(&self, _cx: &Context) -> String {
        String::new()
    }

    /// The current keys, the most useful first.
    fn keys(&self, cx: &Context) -> KeyTable<Self::Action>;

    /// Handles a key before the table does, for text input. Returns whether the key was used.
    fn typed(&mut self, _key: Key, _cx: &mut Context) -> bool {
        false
    }

    /// The rules of the game on the screen; the help page links to them.
    fn rules(&self) -> Option<Rules> {
        None
    }

    /// Carries out an action.
    fn act(&mut self, action: Self::Action, cx: &mut Context) -> Next;

    /// Carries out the action of [`Next::Confirm`], now that the player has agreed.
    fn confirmed(&mut self, _action: Self::Action, _cx: &mut Context) -> Next {
        Next::Stay
    }

    /// The screen's view. Clicks in panels are carried out like keys; panels that are longer than
    /// their areas scroll.
    fn view<'s>(&'s self, cx: &'s Context) -> View<'s, Self::Action>;

    /// Handles the mouse over the picture of the view, which is in the area `picture`.
    fn point(&mut self, _mouse: &Mouse, _picture: Rect, _cx: &mut Context) -> Next {
        Next::Ignored
    }

    /// Handles the mouse wheel over the view, up (-1) or down (1), unless the wheel scrolls a long
    /// text.
    fn wheel(&mut self, _by: i8, _cx: &mut Context) -> Next {
        Next::Ignored
    }

    /// Handles an attempt to scroll the text `_by` rows beyond one of its ends; negative is up.
    fn scrolled_out(&mut self, _by: i16, _cx: &mut Context) -> Next {
        Next::Ignored
    }

    /// Handles an input that is neither a key nor the mouse, such as pasted text or the answer to a
    /// request.
    fn input(&mut self, _input: &Input, _cx: &mut Context) -> Next {
        Next::Ignored
    }

    /// Called when the screen is on top again, after another screen was left.
    fn resumed(&mut self, _cx: &mut Context) {}

    /// Advances the time; called only while [`Screen::wake`] returns a delay.
    fn advance(&mut self, _passed: Duration, _cx: &mut Context) {}

    /// The time until the screen must next be advanced; `None` while nothing moves.
    fn wake(&self, _cx: &Context) -> Option<Duration> {
        None
    }

    /// Whether other people see the same clock, as in a class: then time cannot be skipped.
    fn shares_time(&self) -> bool {
        false
    }
}

/// The consequence of an input.
#[derive(Debug, Clone, PartialEq)]
pub enum Next {
    /// The input was not used here; the app may use it.
    Ignored,
    /// Stay on this screen.
    Stay,
    /// Open another screen on top.
    Open(Route),
    /// Replace this screen with another.
    Replace(Route),
    /// Return to the screen below.
    Back,
    /// Ask the player first; if they agree, [`Screen::confirmed`] carries out the action.
    Confirm(Confirmation),
    /// The action of a key that means the same on every screen.
    Shared(SharedAction),
}

impl Next {
    /// The consequence of an input, depending on whether it was used.
    pub(crate) fn after(used: bool) -> Self {
        if used { Self::Stay } else { Self::Ignored }
    }

    /// Scrolls the text by this many rows.
    pub(crate) const fn scroll(rows: i16) -> Self {
        Self::Shared(SharedAction::Scroll(rows))
    }

    /// The consequence of an input to a part of the screen; `done` computes it from the result.
    pub(crate) fn of<T>(outcome: Outcome<T>, done: impl FnOnce(T) -> Self) -> Self {
        match outcome {
            Outcome::Ignored => Self::Ignored,
            Outcome::Used => Self::Stay,
            Outcome::Done(came) => done(came),
        }
    }
}

/// A request to confirm an action, such as one that cannot be undone.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Confirmation {
    /// The question, and the consequence of saying yes.
    pub text: String,
    /// The label for yes.
    pub yes: &'static str,
    /// The label for no.
    pub no: &'static str,
}

impl Confirmation {
    /// A confirmation with its question and the labels of its answers.
    pub fn new(text: impl Into<String>, yes: &'static str, no: &'static str) -> Self {
        Self {
            text: text.into(),
            yes,
            no,
        }
    }
}
