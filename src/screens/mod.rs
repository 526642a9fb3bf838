//! The screens: one folder each, with its state and update, and its view beside it.

mod context;
mod list;
mod place;
mod recall;
pub(crate) mod why;

pub mod class;
pub mod foil;
pub mod home;
pub mod lab;
pub mod learn;
pub mod levels;
pub mod progress;
pub mod quiz;
pub mod table;

use std::time::Duration;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

pub use context::{Context, Settings};
pub use place::Place;

use crate::messages::Input;

/// A place in the app: it takes input, lets time pass and draws itself.
///
/// A screen is pure: it reads no clock and touches no file. Keys it has no use
/// for it hands back as [`Next::Ignored`], and the app tries its own.
pub trait Screen {
    /// Its name for the title line, in lower case.
    fn title(&self) -> String;

    /// The rest of the title line: what is set up.
    fn status(&self, _cx: &Context) -> String {
        String::new()
    }

    /// Takes one input.
    fn update(&mut self, input: &Input, cx: &mut Context) -> Next;

    /// Lets time pass; called only while [`Screen::wake`] asks for time.
    fn advance(&mut self, _passed: Duration, _cx: &mut Context) -> Next {
        Next::Stay
    }

    /// When it next needs time; `None` while nothing moves.
    fn wake(&self, _cx: &Context) -> Option<Duration> {
        None
    }

    /// Draws itself into `area`, which is [`Context::body`].
    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context);

    /// The keys to show in the bottom line, the most useful first.
    fn keys(&self, cx: &Context) -> Vec<Hint>;

    /// The page that `?` opens.
    fn help(&self, cx: &Context) -> Help;
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
    /// Leave the program.
    Quit,
}

/// A key and what it does, for the bottom line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hint {
    /// The key or keys, as on the keyboard.
    pub key: &'static str,
    /// What it does, in a word or two.
    pub does: &'static str,
}

impl Hint {
    /// A hint.
    pub const fn new(key: &'static str, does: &'static str) -> Self {
        Self { key, does }
    }
}

/// The page that explains a screen.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Help {
    /// What the screen is for and how to begin, a paragraph each.
    pub text: Vec<&'static str>,
    /// All its keys.
    pub keys: Vec<Hint>,
}
