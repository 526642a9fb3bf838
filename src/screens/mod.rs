//! The screens: one folder each, with its state and update, and its view beside it.

mod context;
mod hosted;
mod kept_files;
mod leads;
mod place;
mod recall;
mod view;

pub(crate) mod class;
pub(crate) mod foil;
pub(crate) mod glossary;
pub(crate) mod home;
pub(crate) mod join;
pub(crate) mod lab;
pub mod learn;
pub(crate) mod levels;
pub(crate) mod progress;
pub(crate) mod quiz;
pub(crate) mod settings;
pub mod table;

use std::time::Duration;

use ratatui::layout::Rect;

pub use context::Context;
pub use hosted::{AnyScreen, Hosted, SharedAction};
#[cfg(not(target_family = "wasm"))]
pub(crate) use join::{code_of, host_of};
pub use place::{FoilPage, Place};
pub use settings::{KeptSettings, Settings};
pub use view::View;

use crate::messages::{Input, Key, Mouse};
use crate::widgets::Outcome;
use crate::widgets::input::KeyTable;

/// A place in the app: it takes input, lets time pass and draws itself.
///
/// A screen is pure: it reads no clock and touches no file. What its keys do stands in one
/// table, from which come the line at the bottom, the help page and what a press does;
/// keys that are not in it are the app's.
pub trait Screen {
    /// What keys do here.
    type Action: Copy + PartialEq;

    /// Its name for the title line, in lower case.
    fn title(&self) -> String;

    /// The route that leads back to what the screen shows now.
    fn place(&self, _cx: &Context) -> Place {
        Place::Home
    }

    /// The rest of the title line: what is set up.
    fn status(&self, _cx: &Context) -> String {
        String::new()
    }

    /// The keys that mean something just now, the most useful first.
    fn keys(&self, cx: &Context) -> KeyTable<Self::Action>;

    /// The page that `?` opens, before its keys: what the screen is for and how to begin,
    /// a paragraph each.
    fn about(&self, cx: &Context) -> Vec<&'static str>;

    /// Takes a key before the table is asked: for text that is being typed. Says whether
    /// it was taken.
    fn typed(&mut self, _key: Key, _cx: &mut Context) -> bool {
        false
    }

    /// Does what a key stands for.
    fn act(&mut self, action: Self::Action, cx: &mut Context) -> Next;

    /// Does what was asked about by [`Next::Confirm`], now that the player has agreed.
    fn confirmed(&mut self, _action: Self::Action, _cx: &mut Context) -> Next {
        Next::Stay
    }

    /// What it shows. What is clicked in a panel is done as by a key; panels that are longer
    /// than their places are scrolled.
    fn view<'s>(&'s self, cx: &'s Context) -> View<'s, Self::Action>;

    /// Takes the mouse over the picture of its view, which stands in `picture`.
    fn point(&mut self, _mouse: &Mouse, _picture: Rect, _cx: &mut Context) -> Next {
        Next::Ignored
    }

    /// Takes a turn of the wheel over its view, up (-1) or down (1), unless a long text there
    /// is scrolled by it.
    fn wheel(&mut self, _by: i8, _cx: &mut Context) -> Next {
        Next::Ignored
    }

    /// Its text was to be scrolled by so many rows, but ends there.
    fn scrolled_out(&mut self, _by: i16, _cx: &mut Context) -> Next {
        Next::Ignored
    }

    /// Takes an input that is neither a key nor the mouse: pasted text, what came of a request.
    fn input(&mut self, _input: &Input, _cx: &mut Context) -> Next {
        Next::Ignored
    }

    /// It is on top again, after another screen was left.
    fn resumed(&mut self, _cx: &mut Context) {}

    /// Lets time pass; called only while [`Screen::wake`] asks for time.
    fn advance(&mut self, _passed: Duration, _cx: &mut Context) {}

    /// When it next needs time; `None` while nothing moves.
    fn wake(&self, _cx: &Context) -> Option<Duration> {
        None
    }

    /// Whether others see the same time pass, as in a class: then nobody can be ahead of it.
    fn shares_time(&self) -> bool {
        false
    }
}

/// What follows from an input or from time that passed.
#[derive(Debug, Clone, PartialEq)]
pub enum Next {
    /// The input meant nothing here; the app may use it.
    Ignored,
    /// Stay on this screen.
    Stay,
    /// Open another screen on top.
    Open(Place),
    /// Open another screen instead of this one.
    Replace(Place),
    /// Return to the screen below.
    Back,
    /// Ask the player first; if they agree, the same is done by [`Screen::confirmed`].
    Confirm(Confirmation),
    /// A key that means the same on every screen.
    Shared(SharedAction),
    /// Leave the program.
    Quit,
}

impl Next {
    /// What follows from an input that was of use or not.
    pub(crate) fn after(used: bool) -> Self {
        if used { Self::Stay } else { Self::Ignored }
    }

    /// What follows from what an input meant to a part of the screen; `done` says it of
    /// what came of it.
    pub(crate) fn of<T>(outcome: Outcome<T>, done: impl FnOnce(T) -> Self) -> Self {
        match outcome {
            Outcome::Ignored => Self::Ignored,
            Outcome::Used => Self::Stay,
            Outcome::Done(came) => done(came),
        }
    }
}

/// What is asked before something is done that cannot be undone.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Confirmation {
    /// The question, with what follows from a yes.
    pub text: String,
    /// What a yes is called.
    pub yes: &'static str,
    /// What a no is called.
    pub no: &'static str,
}

impl Confirmation {
    /// A question, and what its answers are called.
    pub fn new(text: impl Into<String>, yes: &'static str, no: &'static str) -> Self {
        Self {
            text: text.into(),
            yes,
            no,
        }
    }
}
