//! A measured collision: the tracks of two bodies from a film are fitted and compared with the
//! exact prediction, and every result has an uncertainty.
//!
//! [`read()`] reads the tracks, and [`Measurement::new`] analyses them. Uncertainties follow from
//! the scatter of the points about the fitted paths; `tests/coverage.rs` checks with simulated
//! measurements that the 68 % and 95 % intervals contain the true values in 68 % and 95 % of cases.

mod contact;
mod film;
mod fit;
mod json;
mod model;
mod quantities;
mod read;
mod student;
mod track;
mod words;

#[cfg(test)]
mod tests;

use crate::files::FileError;

pub(crate) use film::Camera;
pub use fit::{Apart, Estimate, LEVEL, SlowingTest, TracksFit};
pub(crate) use model::{Model, State};
pub use quantities::LineFrom;
pub(crate) use quantities::{Known, QUANTITIES, Quantity, Unit, line};
pub use read::{LARGEST, Reading, read};
pub(crate) use student::t_beyond;
pub use track::{Leg, Point, Track};
pub use words::{ReportRow, ReportSection};

/// Whether legs may slow down.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, strum::EnumString, strum::VariantNames)]
#[strum(serialize_all = "kebab-case")]
pub enum SlowingDown {
    /// If the data require it.
    #[default]
    Auto,
    /// Always; the uncertainties are larger, but not even a small deceleration distorts the
    /// results.
    Always,
    /// Never.
    Never,
}

/// What is known besides the tracks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Given {
    /// Both masses in kilograms.
    pub masses: Option<[f64; 2]>,
    /// Both radii in metres.
    pub radii: Option<[f64; 2]>,
    /// The factor by which all coordinates of the tracks are multiplied.
    pub scale: f64,
    /// The coefficient of restitution for the prediction.
    pub restitution: f64,
    /// Whether legs may slow down.
    pub slowing: SlowingDown,
}

impl Default for Given {
    fn default() -> Self {
        Self {
            masses: None,
            radii: None,
            scale: 1.0,
            restitution: 1.0,
            slowing: SlowingDown::Auto,
        }
    }
}

/// Why tracks cannot be measured.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct Fault {
    line: Option<u32>,
    message: String,
}

impl Fault {
    fn new(message: impl Into<String>) -> Self {
        Self {
            line: None,
            message: message.into(),
        }
    }

    fn on(line: u32, message: impl Into<String>) -> Self {
        Self {
            line: Some(line),
            message: message.into(),
        }
    }

    /// This fault as an error in a file.
    pub fn of_file(self, name: &str) -> FileError {
        match self.line {
            Some(line) => FileError::on_line(name, line as usize, self.message),
            None => FileError::of_file(name, self.message),
        }
    }
}

/// An analysed collision.
#[derive(Debug, Clone, PartialEq)]
pub struct Measurement {
    /// The tracks of both bodies, multiplied by the scale.
    pub tracks: [Track; 2],
    /// What is known besides the tracks.
    pub given: Given,
    pub(crate) fit: TracksFit,
    pub(crate) known: Known,
}

impl Measurement {
    /// Analyses two tracks.
    ///
    /// # Errors
    /// Returns an error if the tracks contain no measurable collision.
    pub fn new(mut tracks: [Track; 2], given: Given) -> Result<Self, Fault> {
        for point in tracks.iter_mut().flat_map(|track| &mut track.points) {
            point.at *= given.scale;
        }
        let radii = given.radii.map(|radii| radii.iter().sum());
        let fit = TracksFit::new(&tracks, radii, given.slowing)?;
        let known = Known::new(&given, &fit);
        Ok(Self {
            tracks,
            given,
            fit,
            known,
        })
    }

    /// The same tracks, analysed with other given values.
    ///
    /// # Errors
    /// Returns an error if the tracks contain no measurable collision.
    pub(crate) fn again(&self, given: Given) -> Result<Self, Fault> {
        let mut tracks = self.tracks.clone();
        for point in tracks.iter_mut().flat_map(|track| &mut track.points) {
            point.at /= self.given.scale;
        }
        Self::new(tracks, given)
    }

    pub(crate) fn names(&self) -> [&str; 2] {
        self.tracks.each_ref().map(|track| track.name.as_str())
    }

    /// The quantity with this id and its estimate, or why there is none.
    pub(crate) fn quantity(&self, id: &str) -> Result<(&'static Quantity, Estimate), String> {
        let mut all = QUANTITIES.iter();
        let quantity = all.find(|quantity| quantity.id == id);
        let quantity = quantity.ok_or_else(|| format!("no quantity {id}"))?;
        Ok((quantity, self.estimate(quantity)?))
    }

    /// The motion with the velocities after the contact that are predicted from those before it and
    /// the line of impact.
    pub(crate) fn predicted(&self) -> Option<State> {
        let [v1, v2] = quantities::predicted(&self.fit.state, &self.known)?;
        let mut state = self.fit.state;
        state.set_velocity(0, Leg::After, v1);
        state.set_velocity(1, Leg::After, v2);
        Some(state)
    }
}
