//! What comes next: one forecast a disc.

use super::frame::End;

/// Contacts on shared discs within this many seconds are one event: a symmetric
/// break reaches both sides at times that differ only by rounding.
pub(super) const SAME_TIME: f64 = 1e-12;

/// What a disc is forecast to do next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Forecast {
    /// Its slide ends by itself.
    Alone(End),
    /// It meets a partner that is still on the slide of this version.
    Meet { partner: usize, version: u32 },
}

/// The earliest forecast of each disc.
///
/// A forecast may be out of date, when the partner has been sent elsewhere since.
/// It is then too early, never too late, and is made anew when its time comes.
#[derive(Debug, Default, Clone)]
pub(super) struct Schedule {
    times: Vec<f64>,
    forecasts: Vec<Forecast>,
}

impl Schedule {
    pub(super) fn begin(&mut self, discs: usize) {
        self.times.clear();
        self.times.resize(discs, f64::INFINITY);
        self.forecasts.clear();
        self.forecasts.resize(discs, Forecast::Alone(End::Never));
    }

    pub(super) fn set(&mut self, disc: usize, time: f64, forecast: Forecast) {
        self.times[disc] = time;
        self.forecasts[disc] = forecast;
    }

    pub(super) fn time(&self, disc: usize) -> f64 {
        self.times[disc]
    }

    pub(super) fn times(&self) -> &[f64] {
        &self.times
    }

    pub(super) fn forecast(&self, disc: usize) -> Forecast {
        self.forecasts[disc]
    }

    /// The disc whose forecast comes first, and its time; the lowest number if equal.
    pub(super) fn first(&self) -> Option<(usize, f64)> {
        let mut first = None;
        let mut least = f64::INFINITY;
        for (disc, &time) in self.times.iter().enumerate() {
            if time < least {
                least = time;
                first = Some((disc, time));
            }
        }
        first
    }

    /// How many discs have a forecast up to a time.
    pub(super) fn due(&self, time: f64) -> usize {
        self.times.iter().filter(|&&t| t <= time).count()
    }
}
