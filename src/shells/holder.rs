//! How a shell without threads drives its app.

use std::time::Duration;

use super::FRAME;
use crate::app::App;
use crate::messages::{Effect, Input};

/// A shell that owns an app and carries out each effect before the next input.
pub trait AppHolder {
    /// The app.
    fn app(&mut self) -> &mut App;

    /// Carries out a request of the app. Returns the result if it is available at once.
    fn carry_out(&mut self, effect: Effect) -> Option<Input>;

    /// Carries out requests of the app and passes on their results.
    fn carry_out_all(&mut self, effects: Vec<Effect>) {
        for effect in effects {
            if let Some(result) = self.carry_out(effect) {
                self.input(&result);
            }
        }
    }

    /// Passes on one input.
    fn input(&mut self, input: &Input) {
        if !self.app().has_quit() {
            let effects = self.app().update(input);
            self.carry_out_all(effects);
        }
    }

    /// Advances time in the steps that the app requires.
    fn pass(&mut self, time: Duration) {
        let mut left = time;
        while !self.app().has_quit() && !left.is_zero() {
            let Some(wake) = self.app().wake() else {
                return;
            };
            let step = wake.max(FRAME).min(left);
            let effects = self.app().advance(step);
            self.carry_out_all(effects);
            left -= step;
        }
    }
}
