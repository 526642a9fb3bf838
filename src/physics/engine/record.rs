//! Who writes down what happens.

use super::super::Motion;
use super::super::shot::{Event, Shot, Turn};

/// Takes down a shot as the engine plays it.
pub(super) trait Record {
    /// A disc takes up a new motion.
    fn turn(&mut self, disc: usize, time: f64, motion: Motion, pocketed: bool);
    /// Something happened.
    fn event(&mut self, event: Event);
}

impl Record for Shot {
    fn turn(&mut self, disc: usize, time: f64, motion: Motion, pocketed: bool) {
        self.push_turn(
            disc,
            Turn {
                time,
                motion,
                pocketed,
            },
        );
    }

    fn event(&mut self, event: Event) {
        self.push_event(event);
    }
}
