//! A disc in flight, with the slide it is on.

use glam::DVec2;

use super::super::slide::{parabola, relative_deceleration};
use super::super::{Disc, Motion};

/// What the engine holds of a disc.
///
/// Its place is kept as the start of its present slide and is never stepped: only an event
/// of its own gives it a new start.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Body {
    /// How its slide began.
    pub(super) start: Motion,
    pub(super) acceleration: DVec2,
    /// When its slide began.
    pub(super) since: f64,
    pub(super) radius: f64,
    pub(super) mass: f64,
    /// The part of its first speed it loses each second of its slide, a/v.
    pub(super) relative_deceleration: f64,
    /// Counts its slides, so that a forecast can tell that it is out of date.
    pub(super) version: u32,
    pub(super) moving: bool,
}

impl Body {
    /// A disc that sets off at time 0.
    pub(super) fn new(disc: &Disc, start: Motion, deceleration: f64) -> Self {
        let mut body = Self {
            radius: disc.radius,
            mass: disc.mass,
            ..Self::default()
        };
        body.launch(0.0, start, deceleration);
        body
    }

    /// Sends it on a new slide.
    pub(super) fn launch(&mut self, now: f64, start: Motion, deceleration: f64) {
        let speed = start.velocity.length();
        self.relative_deceleration = relative_deceleration(speed, deceleration);
        self.start = start;
        self.acceleration = -self.relative_deceleration * start.velocity;
        self.since = now;
        self.moving = speed > 0.0;
        self.version = self.version.wrapping_add(1);
    }

    /// Its motion at a time not beyond its stop.
    #[inline(always)]
    pub(super) fn at(&self, time: f64) -> Motion {
        parabola(self.start, self.acceleration, time - self.since)
    }
}
