//! When to advance the app and when to draw it.

use std::time::{Duration, Instant};

use crate::app::App;
use crate::messages::Effect;
use crate::shells::FRAME;

/// Advances the app's time with the clock, and leaves at least one [`FRAME`] between two frames.
#[derive(Debug)]
pub(super) struct Pace {
    /// The time up to which the app has advanced.
    lived: Instant,
    /// The earliest time for the next frame.
    earliest: Instant,
    /// Whether the app has changed since the last frame.
    outdated: bool,
}

impl Pace {
    /// Starts with a frame that is due at once.
    pub(super) fn new(now: Instant) -> Self {
        Self {
            lived: now,
            earliest: now,
            outdated: true,
        }
    }

    /// Records that the app has changed.
    pub(super) fn outdated(&mut self) {
        self.outdated = true;
    }

    /// Advances the app to `now` if anything moves.
    pub(super) fn live(&mut self, app: &mut App, now: Instant) -> Vec<Effect> {
        let passed = now.saturating_duration_since(self.lived);
        self.lived = now;
        if app.wake().is_none() {
            return vec![];
        }
        self.outdated = true;
        app.advance(passed)
    }

    pub(super) fn is_due(&self, now: Instant) -> bool {
        self.outdated && self.earliest <= now
    }

    /// Records that a frame is drawn `now`.
    pub(super) fn drawn(&mut self, now: Instant) {
        self.outdated = false;
        self.earliest = now + FRAME;
    }

    /// When to check again if nothing happens before then; `wake` is the time until the app must
    /// be advanced.
    pub(super) fn next(&self, wake: Option<Duration>) -> Option<Instant> {
        if self.outdated {
            return Some(self.earliest);
        }
        Some(self.lived.checked_add(wake?)?.max(self.earliest))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::screens::{Route, Settings};

    #[test]
    fn the_first_frame_is_drawn_at_once_and_the_next_one_later() {
        let start = Instant::now();
        let mut pace = Pace::new(start);
        assert!(pace.is_due(start));
        pace.drawn(start);
        pace.outdated();
        assert!(!pace.is_due(start + FRAME / 2));
        assert_eq!(pace.next(None), Some(start + FRAME));
        assert!(pace.is_due(start + FRAME));
    }

    #[test]
    fn an_app_at_rest_needs_no_timer() {
        let start = Instant::now();
        let mut pace = Pace::new(start);
        pace.drawn(start);
        assert_eq!(pace.next(None), None);
        let mut app = App::new(Route::Home, Settings::default(), 1);
        pace.live(&mut app, start + Duration::from_secs(9));
        assert!(!pace.is_due(start + Duration::from_secs(9)));
    }

    #[test]
    fn a_fast_app_gets_sixty_frames_per_second_and_a_slow_one_as_many_as_it_requests() {
        let start = Instant::now();
        let mut pace = Pace::new(start);
        pace.drawn(start);
        assert_eq!(pace.next(Some(Duration::ZERO)), Some(start + FRAME));
        let slow = Duration::from_millis(250);
        assert_eq!(pace.next(Some(slow)), Some(start + slow));
        assert_eq!(pace.next(Some(Duration::MAX)), None);
    }
}
