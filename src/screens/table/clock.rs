//! How time runs while a stroke is watched: at real speed, slower or faster, halted,
//! stepped through.

use std::time::Duration;

/// Speeds to watch at; 1 is real.
const RATES: [f64; 7] = [1.0 / 16.0, 1.0 / 8.0, 1.0 / 4.0, 1.0 / 2.0, 1.0, 2.0, 4.0];
/// Where real speed is among them.
const REAL: usize = 4;

/// The clock of a stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Clock {
    time: f64,
    end: f64,
    rate: usize,
    running: bool,
}

impl Clock {
    /// A clock that runs at real speed, from the start of a stroke of `end` seconds;
    /// with `reduced` motion one that stands at its end.
    pub(super) fn new(end: f64, reduced: bool) -> Self {
        Self {
            time: if reduced { end } else { 0.0 },
            end,
            rate: REAL,
            running: !reduced && end > 0.0,
        }
    }

    /// Seconds since the start of the stroke.
    pub(super) fn time(&self) -> f64 {
        self.time
    }

    /// Whether time runs.
    pub(super) fn is_running(&self) -> bool {
        self.running
    }

    /// Whether all has come to rest.
    pub(super) fn is_over(&self) -> bool {
        self.time >= self.end
    }

    /// Seconds of the stroke that pass in a second.
    pub(super) fn rate(&self) -> f64 {
        RATES[self.rate.min(RATES.len() - 1)]
    }

    /// Lets `passed` go by on the screen.
    pub(super) fn advance(&mut self, passed: Duration) {
        if self.running {
            self.time = (self.time + passed.as_secs_f64() * self.rate()).min(self.end);
            self.running = self.time < self.end;
        }
    }

    /// Goes on from a halt; while running, to the end at once.
    pub(super) fn go_on(&mut self) {
        if self.running {
            self.seek(self.end);
        } else {
            self.running = self.time < self.end;
        }
    }

    /// From the start again.
    pub(super) fn rewind(&mut self) {
        self.time = 0.0;
        self.running = self.end > 0.0;
    }

    /// Halts at a time; times beyond the ends count as the ends.
    pub(super) fn seek(&mut self, time: f64) {
        self.time = time.clamp(0.0, self.end);
        self.running = false;
    }

    /// Halts, so many seconds further or back.
    pub(super) fn step(&mut self, seconds: f64) {
        self.seek(self.time + seconds);
    }

    /// One speed faster or slower.
    pub(super) fn change_rate(&mut self, faster: bool) {
        self.rate = if faster {
            (self.rate + 1).min(RATES.len() - 1)
        } else {
            self.rate.saturating_sub(1)
        };
    }

    /// The speed in words: "real speed", "1/4 speed", "2x speed".
    pub(super) fn rate_words(&self) -> String {
        match self.rate() {
            rate if rate < 1.0 => format!("1/{:.0} speed", 1.0 / rate),
            rate if rate > 1.0 => format!("{rate:.0}× speed"),
            _ => "real speed".into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stroke_takes_its_own_time_and_then_time_stands_still() {
        let mut clock = Clock::new(1.0, false);
        clock.advance(Duration::from_millis(400));
        assert!((clock.time() - 0.4).abs() < 1e-12);
        clock.change_rate(false);
        clock.advance(Duration::from_millis(400));
        assert!((clock.time() - 0.6).abs() < 1e-12);
        clock.advance(Duration::from_secs(9));
        assert!(clock.is_over() && !clock.is_running());
        clock.go_on();
        assert!(!clock.is_running());
    }

    #[test]
    fn steps_halt_and_stay_within_the_stroke() {
        let mut clock = Clock::new(1.0, false);
        clock.step(-1.0);
        assert_eq!(clock.time(), 0.0);
        clock.step(0.25);
        assert!(!clock.is_running());
        clock.go_on();
        assert!(clock.is_running());
        clock.go_on();
        assert!(clock.is_over());
        assert!(Clock::new(1.0, true).is_over());
    }
}
