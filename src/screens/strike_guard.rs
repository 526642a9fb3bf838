//! Ignores a press of the strike key that was only meant to go on from the last stroke.

use std::time::Duration;

/// A key counts as released if it has not been pressed for this long, because most terminals do not
/// report the release itself. The time is longer than the delay before a held key repeats: 660 ms
/// under X11, at most 1 s under Windows.
const REST: Duration = Duration::from_millis(1100);

/// Decides whether the strike key strikes. The key that strikes also continues from one stroke to
/// the next, so an extra press, or a held key, would play a stroke that nobody meant. When a turn
/// begins, the key is therefore ignored until another input shows that it has been released, or
/// until it has not been pressed for a while.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StrikeGuard {
    left: Duration,
    /// Whether a press was ignored.
    has_refused: bool,
}

impl Default for StrikeGuard {
    /// The guard at the beginning of a turn.
    fn default() -> Self {
        Self {
            left: REST,
            has_refused: false,
        }
    }
}

impl StrikeGuard {
    /// Whether a press of the strike key strikes. A press that does not strike restarts the wait,
    /// because it shows that the key is still in use.
    pub(crate) fn allows(&mut self) -> bool {
        self.has_refused = !self.left.is_zero();
        if self.has_refused {
            self.left = REST;
        }
        !self.has_refused
    }

    /// Notes another input: the strike key has been released.
    pub(crate) fn release(&mut self) {
        self.left = Duration::ZERO;
    }

    pub(crate) fn advance(&mut self, passed: Duration) {
        self.left = self.left.saturating_sub(passed);
    }

    /// The time until a press strikes; `None` if one would strike now.
    pub(crate) fn wake(&self) -> Option<Duration> {
        (!self.left.is_zero()).then_some(self.left)
    }

    /// The notice for a player whose press was ignored, while the next one would be ignored as well.
    pub(crate) fn refusal(&self) -> Option<&'static str> {
        let is_refusing = self.has_refused && !self.left.is_zero();
        is_refusing.then_some("Too soon after the last press: wait a moment, then press again.")
    }
}
