//! The clock of a stroke being replayed. The clock can run at several speeds, pause and step.

use std::time::Duration;

/// A replay speed: a power of two, from 1/16 of the real speed to four times the real speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WatchRate(i32);

impl WatchRate {
    pub(crate) const REAL: Self = Self(0);
    pub(crate) const QUARTER: Self = Self(-2);
    const ENDS: [i32; 2] = [-4, 2];

    /// All speeds, from slowest to fastest.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        let [slowest, fastest] = Self::ENDS;
        (slowest..=fastest).map(Self)
    }

    /// Seconds of the stroke per second on the screen.
    pub(crate) fn seconds(self) -> f64 {
        2.0_f64.powi(self.0)
    }

    /// The speed that is `steps` steps faster, or slower if `steps` is negative.
    #[must_use]
    pub(crate) fn faster(self, steps: i8) -> Self {
        let [slowest, fastest] = Self::ENDS;
        Self((self.0 + i32::from(steps)).clamp(slowest, fastest))
    }

    /// The name of the speed, such as "real speed", "1/4 speed", "2× speed".
    pub(crate) fn words(self) -> String {
        match self.seconds() {
            rate if rate < 1.0 => format!("1/{:.0} speed", 1.0 / rate),
            rate if rate > 1.0 => format!("{rate:.0}× speed"),
            _ => "real speed".into(),
        }
    }
}

/// The clock of a stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ShotClock {
    time: f64,
    end: f64,
    pub(crate) rate: WatchRate,
    running: bool,
}

impl ShotClock {
    /// Creates a clock that runs at this speed, from the start of a stroke to `end` seconds after
    /// it; with `reduced` motion, the clock is already at the end.
    pub(crate) fn new(end: f64, rate: WatchRate, reduced: bool) -> Self {
        Self {
            time: if reduced { end } else { 0.0 },
            end,
            rate,
            running: !reduced && end > 0.0,
        }
    }

    /// Seconds since the start of the stroke.
    pub(crate) fn time(&self) -> f64 {
        self.time
    }

    pub(crate) fn is_running(&self) -> bool {
        self.running
    }

    /// Whether the clock has reached the end.
    pub(crate) fn is_over(&self) -> bool {
        self.time >= self.end
    }

    /// The time at which the replay ends, in seconds since the start of the stroke.
    pub(crate) fn end(&self) -> f64 {
        self.end
    }

    /// Advances by `passed` of screen time.
    pub(crate) fn advance(&mut self, passed: Duration) {
        if self.running {
            self.time = (self.time + passed.as_secs_f64() * self.rate.seconds()).min(self.end);
            self.running = self.time < self.end;
        }
    }

    /// Continues after a pause; if the clock is already running, jumps to the end.
    pub(crate) fn go_on(&mut self) {
        if self.running {
            self.seek(self.end);
        } else {
            self.running = self.time < self.end;
        }
    }

    /// Runs again from the start of the stroke.
    pub(crate) fn rewind(&mut self) {
        self.time = 0.0;
        self.running = self.end > 0.0;
    }

    /// Pauses at a time of the stroke, clamped to the duration of the replay.
    pub(crate) fn seek(&mut self, time: f64) {
        self.time = time.clamp(0.0, self.end);
        self.running = false;
    }

    /// Pauses, and moves by `seconds`: forwards if positive, backwards if negative.
    pub(crate) fn step(&mut self, seconds: f64) {
        self.seek(self.time + seconds);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_clock_runs_for_the_duration_of_the_stroke_and_stops() {
        let mut clock = ShotClock::new(1.0, WatchRate::REAL, false);
        clock.advance(Duration::from_millis(400));
        assert!((clock.time() - 0.4).abs() < 1e-12);
        clock.rate = clock.rate.faster(-1);
        clock.advance(Duration::from_millis(400));
        assert!((clock.time() - 0.6).abs() < 1e-12);
        clock.advance(Duration::from_secs(9));
        assert!(clock.is_over() && !clock.is_running());
        clock.go_on();
        assert!(!clock.is_running());
    }

    #[test]
    fn speeds_are_powers_of_two_within_bounds() {
        assert_eq!(WatchRate::REAL.faster(-9).words(), "1/16 speed");
        assert_eq!(WatchRate::REAL.faster(9).words(), "4× speed");
        assert_eq!(WatchRate::QUARTER.faster(2).words(), "real speed");
    }

    #[test]
    fn steps_pause_the_clock_and_stay_within_the_stroke() {
        let mut clock = ShotClock::new(1.0, WatchRate::REAL, false);
        clock.step(-1.0);
        assert_eq!(clock.time(), 0.0);
        clock.step(0.25);
        assert!(!clock.is_running());
        clock.go_on();
        assert!(clock.is_running());
        clock.go_on();
        assert!(clock.is_over());
        assert!(ShotClock::new(1.0, WatchRate::REAL, true).is_over());
    }
}
