//! A moving disc and the slide that it is on.

use glam::DVec2;

use super::super::slide::{parabola, relative_deceleration};
use super::super::{Disc, Motion};

/// The state of a disc in the engine.
///
/// A body stores the start of the current slide, which changes only in an event that involves this
/// disc: there are no time steps.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Body {
    /// The start of the current slide.
    pub(super) start: Motion,
    pub(super) acceleration: DVec2,
    /// When the current slide began, in seconds.
    pub(super) since: f64,
    pub(super) radius: f64,
    pub(super) mass: f64,
    /// The fraction of its initial speed that the disc loses per second of the slide, a/v.
    pub(super) relative_deceleration: f64,
    /// The number of slides of the disc so far, by which outdated forecasts can be recognized.
    pub(super) version: u32,
    pub(super) moving: bool,
}

impl Body {
    /// A disc that starts at time 0.
    pub(super) fn new(disc: &Disc, start: Motion, deceleration: f64) -> Self {
        let mut body = Self {
            radius: disc.radius,
            mass: disc.mass,
            ..Self::default()
        };
        body.launch(0.0, start, deceleration);
        body
    }

    /// Starts a new slide.
    pub(super) fn launch(&mut self, now: f64, start: Motion, deceleration: f64) {
        let speed = start.velocity.length();
        self.relative_deceleration = relative_deceleration(speed, deceleration);
        self.start = start;
        self.acceleration = -self.relative_deceleration * start.velocity;
        self.since = now;
        self.moving = speed > 0.0;
        self.version = self.version.wrapping_add(1);
    }

    /// The disc's motion at a time, which must not be later than the time at which the disc stops.
    #[inline(always)]
    pub(super) fn at(&self, time: f64) -> Motion {
        parabola(self.start, self.acceleration, time - self.since)
    }
}
