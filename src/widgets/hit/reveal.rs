//! A collision that is watched before its outcome is revealed.

use std::time::Duration;

use super::{HitPace, Overlays, Watch, WatchAction};
use crate::messages::Key;
use crate::widgets::input::KeyTable;

/// The collision to watch, if there is one, and whether its outcome has been revealed.
#[derive(Debug, Clone)]
pub(crate) struct Reveal {
    watch: Option<Watch>,
    revealed: bool,
}

impl Reveal {
    /// The initial state; if there is no collision, the outcome is already revealed.
    pub(crate) fn new(watch: Option<Watch>) -> Self {
        Self {
            revealed: watch.as_ref().is_none_or(Watch::is_revealed),
            watch,
        }
    }

    /// The collision, if there is one.
    pub(crate) fn watch(&self) -> Option<&Watch> {
        self.watch.as_ref()
    }

    /// Whether the outcome has been revealed; a replay does not hide the outcome again.
    pub(crate) fn is_revealed(&self) -> bool {
        self.revealed
    }

    /// Whether the outcome has not been revealed yet, or a replay is showing the explanation step
    /// by step.
    pub(crate) fn is_explaining(&self) -> bool {
        let watch = self.watch.as_ref();
        let at_step = watch.is_some_and(|watch| watch.clock().has_met() && !watch.is_revealed());
        at_step || !self.revealed
    }

    /// Switches to another collision; if the outcome was revealed, the new one is too.
    pub(crate) fn show(&mut self, watch: Watch) {
        self.watch = Some(watch);
    }

    /// The keys that control the collision, if there is one; at the end the space bar replays it.
    pub(crate) fn keys(&self) -> KeyTable<WatchAction> {
        let Some(watch) = &self.watch else {
            return KeyTable::new("hit");
        };
        let again = KeyTable::new("hit")
            .on(Key::Char(' '), WatchAction::Again, "again")
            .when(watch.clock().is_over());
        again.with(watch.keys(), |action| action)
    }

    /// Carries out an action.
    pub(crate) fn act(&mut self, action: WatchAction) {
        if let Some(watch) = &mut self.watch {
            watch.act(action);
            self.revealed |= watch.is_revealed();
        }
    }

    /// Advances the time.
    pub(crate) fn advance(&mut self, passed: Duration, pace: HitPace) {
        if let Some(watch) = &mut self.watch {
            watch.advance(passed, pace);
            self.revealed |= watch.is_revealed();
        }
    }

    /// The delay until the picture next has to change; `None` if nothing is moving.
    pub(crate) fn wake(&self, pace: HitPace) -> Option<Duration> {
        self.watch.as_ref().and_then(|watch| watch.wake(pace))
    }

    /// Reveals the outcome immediately.
    pub(crate) fn at_once(&mut self) {
        if let Some(watch) = &mut self.watch {
            watch.reveal();
        }
        self.revealed = true;
    }

    /// The layers on top of the collision, if there is one.
    pub(crate) fn layers(&self) -> Option<Overlays> {
        self.watch.as_ref().map(|watch| watch.layers)
    }
}
