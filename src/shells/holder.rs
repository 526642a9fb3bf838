//! How a shell without threads drives its app.

use std::time::Duration;

use super::FRAME;
use crate::app::App;
use crate::messages::{Effect, Input};

/// A shell that owns an app and carries out each effect before the next input.
pub trait AppHolder {
    /// The app.
    fn app(&self) -> &App;

    /// The app, for inputs.
    fn app_mut(&mut self) -> &mut App;

    /// Carries out the app's requests.
    fn carry_out(&mut self, effects: Vec<Effect>);

    /// Passes on one input.
    fn input(&mut self, input: &Input) {
        if !self.app().has_quit() {
            let effects = self.app_mut().update(input);
            self.carry_out(effects);
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
            let effects = self.app_mut().advance(step);
            self.carry_out(effects);
            left -= step;
        }
    }
}
