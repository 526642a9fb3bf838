//! A screen as the app holds it: whatever its actions are, its keys are looked up here.

use std::time::Duration;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use super::{Context, Next, Screen};
use crate::messages::{Input, Key};
use crate::widgets::input::KeyTable;

/// What keys do on every screen that has no use of its own for them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum SharedAction {
    /// explain this screen
    Help,
    /// go back
    Back,
    /// switch between ASCII and Unicode
    Charset,
    /// next theme: dark, light, no colour
    Theme,
    /// reduce motion, or bring it back
    Motion,
    /// leave carrom
    Quit,
}

/// The keys that every screen shares.
pub(crate) fn shared_keys() -> KeyTable<SharedAction> {
    use SharedAction::{Back, Charset, Help, Motion, Quit, Theme};
    KeyTable::new("everywhere")
        .each([(Key::Char('?'), Help)], "")
        .or([(Key::F(1), Help)])
        .on(Key::Escape, Back, "")
        .each([(Key::Char('U'), Charset), (Key::F(2), Charset)], "")
        .each([(Key::Char('T'), Theme), (Key::F(3), Theme)], "")
        .each([(Key::Char('M'), Motion), (Key::F(4), Motion)], "")
        .on(Key::Ctrl('c'), Quit, "")
}

/// What a key stands for on a screen: an action of its own, or one that all share.
#[derive(Clone, Copy)]
enum Pressed<A> {
    Own(A),
    Shared(SharedAction),
}

/// A screen of any kind of actions, as the app's stack holds it.
pub trait AnyScreen {
    /// See [`Screen::title`].
    fn title(&self) -> String;
    /// See [`Screen::status`].
    fn status(&self, cx: &Context) -> String;
    /// The keys that mean something just now, as the player has them: the screen's own,
    /// then those that all share.
    fn table(&self, cx: &Context) -> KeyTable<()>;
    /// See [`Screen::about`].
    fn about(&self, cx: &Context) -> Vec<&'static str>;
    /// Takes a key.
    fn press(&mut self, key: Key, cx: &mut Context) -> Next;
    /// What the player was asked was agreed to.
    fn confirmed(&mut self, cx: &mut Context) -> Next;
    /// See [`Screen::input`].
    fn input(&mut self, input: &Input, cx: &mut Context) -> Next;
    /// See [`Screen::resumed`].
    fn resumed(&mut self, cx: &mut Context);
    /// See [`Screen::advance`].
    fn advance(&mut self, passed: Duration, cx: &mut Context);
    /// See [`Screen::wake`].
    fn wake(&self, cx: &Context) -> Option<Duration>;
    /// See [`Screen::draw`].
    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context);
}

/// A screen, and what the player was asked about on it.
pub struct Hosted<S: Screen> {
    screen: S,
    asked: Option<S::Action>,
}

impl<S: Screen> Hosted<S> {
    /// A screen of which nothing was asked yet.
    pub fn new(screen: S) -> Self {
        Self {
            screen,
            asked: None,
        }
    }

    fn keys(&self, cx: &Context) -> KeyTable<Pressed<S::Action>> {
        let own = self.screen.keys(cx).map(Pressed::Own);
        // Whatever Escape does here is to go back.
        own.with(shared_keys(), Pressed::Shared)
            .identified(Key::Escape, "everywhere.back")
            .distinct()
            .rebound(&cx.settings.keys)
    }
}

impl<S: Screen> AnyScreen for Hosted<S> {
    fn title(&self) -> String {
        self.screen.title()
    }

    fn status(&self, cx: &Context) -> String {
        self.screen.status(cx)
    }

    fn table(&self, cx: &Context) -> KeyTable<()> {
        self.keys(cx).map(|_| ())
    }

    fn about(&self, cx: &Context) -> Vec<&'static str> {
        self.screen.about(cx)
    }

    fn press(&mut self, key: Key, cx: &mut Context) -> Next {
        if self.screen.typed(key, cx) {
            return Next::Stay;
        }
        match self.keys(cx).find(key) {
            Some(Pressed::Own(action)) => {
                let next = self.screen.act(action, cx);
                self.asked = matches!(next, Next::Confirm(_)).then_some(action);
                next
            }
            Some(Pressed::Shared(action)) => Next::Shared(action),
            None => Next::Ignored,
        }
    }

    fn confirmed(&mut self, cx: &mut Context) -> Next {
        let asked = self.asked.take();
        asked.map_or(Next::Stay, |action| self.screen.confirmed(action, cx))
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        self.screen.input(input, cx)
    }

    fn resumed(&mut self, cx: &mut Context) {
        self.screen.resumed(cx);
    }

    fn advance(&mut self, passed: Duration, cx: &mut Context) {
        self.screen.advance(passed, cx);
    }

    fn wake(&self, cx: &Context) -> Option<Duration> {
        self.screen.wake(cx)
    }

    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        self.screen.draw(area, buf, cx);
    }
}
