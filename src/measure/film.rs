//! Simulated films: the tracks that a camera records, with the noise of marking.

use glam::{DVec2, dvec2};
use rand::{Rng, RngExt};

use super::model::{Model, State};
use super::{Point, Track};

/// What a camera records.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Camera {
    /// Frames per second.
    pub(crate) rate: f64,
    pub(crate) frames: usize,
    /// The standard deviation of the noise of a point along x and y, in metres.
    pub(crate) noise: DVec2,
}

impl Camera {
    /// The tracks of both bodies.
    pub(crate) fn tracks(
        &self,
        truth: &State,
        model: &Model,
        names: [&str; 2],
        random: &mut impl Rng,
    ) -> [Track; 2] {
        [0, 1].map(|body| {
            let points = (0..self.frames).map(|frame| {
                let t = frame as f64 / self.rate;
                let missed = dvec2(normal(random), normal(random));
                Point {
                    t,
                    at: truth.at(body, t, model) + missed * self.noise,
                    weight: 1.0,
                    line: frame as u32 + 4,
                }
            });
            Track {
                points: points.collect(),
                name: names[body].into(),
            }
        })
    }
}

/// A standard normal variable (Box and Muller).
pub(super) fn normal(random: &mut impl Rng) -> f64 {
    let (a, b): (f64, f64) = (random.random(), random.random());
    (-2.0 * (1.0 - a).ln()).sqrt() * (std::f64::consts::TAU * b).cos()
}
