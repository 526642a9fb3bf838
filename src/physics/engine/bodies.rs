//! The discs in flight: each with the slide it is on.

use glam::DVec2;

use super::super::slide::parabola;
use super::super::{Disc, Motion};

/// What the engine holds of each disc, one array a quantity so that a pass over all
/// discs reads memory in a row.
///
/// A disc's place is kept as the start of its present slide and is never stepped:
/// only an event of its own gives it a new start.
#[derive(Debug, Default, Clone)]
pub(super) struct Bodies {
    pub(super) x: Vec<f64>,
    pub(super) y: Vec<f64>,
    pub(super) vx: Vec<f64>,
    pub(super) vy: Vec<f64>,
    pub(super) ax: Vec<f64>,
    pub(super) ay: Vec<f64>,
    /// When the slide began.
    pub(super) since: Vec<f64>,
    pub(super) radius: Vec<f64>,
    pub(super) mass: Vec<f64>,
    /// The part of its first speed a disc loses each second of its slide, a/v.
    pub(super) relative_deceleration: Vec<f64>,
    pub(super) moving: Vec<bool>,
    /// Counts the slides of a disc, so that a forecast can tell that it is out of date.
    pub(super) version: Vec<u32>,
}

impl Bodies {
    pub(super) fn begin(&mut self, discs: &[Disc], start: &[Motion], deceleration: f64) {
        for array in [
            &mut self.x,
            &mut self.y,
            &mut self.vx,
            &mut self.vy,
            &mut self.ax,
            &mut self.ay,
            &mut self.since,
            &mut self.relative_deceleration,
        ] {
            array.clear();
            array.resize(discs.len(), 0.0);
        }
        self.radius.clear();
        self.radius.extend(discs.iter().map(|disc| disc.radius));
        self.mass.clear();
        self.mass.extend(discs.iter().map(|disc| disc.mass));
        self.moving.clear();
        self.moving.resize(discs.len(), false);
        self.version.clear();
        self.version.resize(discs.len(), 0);
        for (i, &motion) in start.iter().enumerate() {
            self.launch(i, 0.0, motion, deceleration);
        }
    }

    pub(super) fn len(&self) -> usize {
        self.x.len()
    }

    /// Sends a disc on a new slide.
    pub(super) fn launch(&mut self, i: usize, now: f64, motion: Motion, deceleration: f64) {
        let Motion { position, velocity } = motion;
        let speed = velocity.length();
        let relative_deceleration = if speed > 0.0 {
            deceleration / speed
        } else {
            0.0
        };
        self.x[i] = position.x;
        self.y[i] = position.y;
        self.vx[i] = velocity.x;
        self.vy[i] = velocity.y;
        self.ax[i] = -relative_deceleration * velocity.x;
        self.ay[i] = -relative_deceleration * velocity.y;
        self.since[i] = now;
        self.relative_deceleration[i] = relative_deceleration;
        self.moving[i] = speed > 0.0;
        self.version[i] = self.version[i].wrapping_add(1);
    }

    /// Takes a disc off the board: far beyond the contact_distance of any other, each in a
    /// place of its own.
    pub(super) fn remove(&mut self, i: usize) {
        let away = DVec2::new(1e9 * (i + 1) as f64, 1e9);
        self.launch(i, 0.0, Motion::at_rest(away), 0.0);
    }

    /// How a disc's slide began.
    #[inline(always)]
    pub(super) fn start(&self, i: usize) -> Motion {
        let position = DVec2::new(self.x[i], self.y[i]);
        Motion::new(position, DVec2::new(self.vx[i], self.vy[i]))
    }

    /// Motion of a disc at a time not beyond its stop.
    #[inline(always)]
    pub(super) fn at(&self, i: usize, time: f64) -> Motion {
        parabola(self.start(i), self.acceleration(i), time - self.since[i])
    }

    #[inline(always)]
    pub(super) fn acceleration(&self, i: usize) -> DVec2 {
        DVec2::new(self.ax[i], self.ay[i])
    }
}
