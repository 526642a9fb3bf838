//! How time runs while a hit is shown: up to the contact, a hold there, and on.

use std::time::Duration;

/// One frame at most every sixtieth of a second.
pub(crate) const FRAME: Duration = Duration::from_micros(16_667);

/// Time the approach takes on the screen, without the slowing down, in seconds.
const APPROACH: f64 = 1.1;
/// Time it takes to ease into the contact, and out of it, in seconds.
const EASE: f64 = 0.35;
/// Time between one layer of the explanation and the next, in seconds.
const BEAT: f64 = 0.9;
/// Overlays that come one after the other at the contact.
pub(super) const BEATS: usize = 3;

/// Where in its telling a hit is.
#[derive(Debug, Clone, Copy, PartialEq)]
enum PlaybackStage {
    /// Running towards the contact; seconds on the screen so far.
    Approach(f64),
    /// Held at the contact; seconds on the screen so far, until the last layer.
    Contact(f64),
    /// Running on from the contact; seconds on the screen so far.
    Departure(f64),
    /// Halted by hand at this time of the shot.
    Halted(f64),
}

/// At the contact, with all layers to be seen.
const TOLD: PlaybackStage = PlaybackStage::Contact(BEAT * BEATS as f64);

/// The clock of a hit.
///
/// `contact` and `end` are times of the shot, in its own seconds; what it shows
/// is always derived from the stage, so that steps, scrubbing and slow motion are
/// only other values of one number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Playback {
    pub(super) contact: f64,
    end: f64,
    stage: PlaybackStage,
}

impl Playback {
    /// A clock at the start of a shot whose discs meet at `contact` and that is
    /// shown until `end`. With `reduced` motion it begins at the contact.
    pub(crate) fn new(contact: f64, end: f64, reduced: bool) -> Self {
        Self {
            contact,
            end,
            stage: if reduced {
                TOLD
            } else {
                PlaybackStage::Approach(0.0)
            },
        }
    }

    /// Time of the shot to show, in its own seconds.
    pub(crate) fn time(&self) -> f64 {
        match self.stage {
            PlaybackStage::Approach(s) => {
                // Constant rate, then a rate that falls to 0 evenly over EASE.
                let coasting = s.min(self.coasting());
                let easing = (s - coasting).min(EASE);
                let time = self.rate() * (coasting + easing - easing * easing / (2.0 * EASE));
                time.min(self.contact)
            }
            PlaybackStage::Contact(_) => self.contact,
            PlaybackStage::Departure(s) => {
                let easing = s.min(EASE);
                let time = self.rate() * (easing * easing / (2.0 * EASE) + s - easing);
                (self.contact + time).min(self.end)
            }
            PlaybackStage::Halted(time) => time,
        }
    }

    /// Seconds of the shot that pass in a second on the screen, where it runs evenly.
    pub(crate) fn rate(&self) -> f64 {
        self.contact / APPROACH
    }

    /// How much slower than life the hit is shown.
    pub(crate) fn slowed(&self) -> f64 {
        1.0 / self.rate()
    }

    /// Seconds on the screen before the slowing down begins.
    fn coasting(&self) -> f64 {
        APPROACH - EASE / 2.0
    }

    /// Whether time runs.
    pub(crate) fn is_running(&self) -> bool {
        match self.stage {
            PlaybackStage::Approach(_) => true,
            PlaybackStage::Contact(s) => s < BEAT * BEATS as f64,
            PlaybackStage::Departure(_) => self.time() < self.end,
            PlaybackStage::Halted(_) => false,
        }
    }

    /// Whether the shot stands at, or is past, the contact.
    pub(crate) fn has_met(&self) -> bool {
        self.time() >= self.contact
    }

    /// Whether the shot stands exactly at the contact.
    pub(crate) fn at_contact(&self) -> bool {
        self.has_met() && self.time() <= self.contact
    }

    /// Whether there is nothing more to show.
    pub(crate) fn is_over(&self) -> bool {
        self.time() >= self.end
    }

    /// How many of the layers are to be seen: they come one by one at
    /// the contact and stay.
    pub(crate) fn beats(&self) -> usize {
        match self.stage {
            PlaybackStage::Contact(s) => ((s / BEAT) as usize + 1).min(BEATS),
            _ if self.has_met() => BEATS,
            _ => 0,
        }
    }

    /// Lets `passed` go by on the screen.
    pub(crate) fn advance(&mut self, passed: Duration) {
        if !self.is_running() {
            return;
        }
        let passed = passed.as_secs_f64();
        self.stage = match self.stage {
            PlaybackStage::Approach(s) => {
                let left = self.coasting() + EASE - s;
                if passed < left {
                    PlaybackStage::Approach(s + passed)
                } else {
                    PlaybackStage::Contact(passed - left)
                }
            }
            PlaybackStage::Contact(s) => PlaybackStage::Contact(s + passed),
            PlaybackStage::Departure(s) => PlaybackStage::Departure(s + passed),
            halted @ PlaybackStage::Halted(_) => halted,
        };
    }

    /// Goes on: to the contact at once while still approaching, to all the layers
    /// while they are coming, and from a halt or from the contact on to the end.
    pub(crate) fn go_on(&mut self) {
        self.stage = match self.stage {
            PlaybackStage::Approach(_) => PlaybackStage::Contact(0.0),
            PlaybackStage::Contact(s) if s < BEAT * (BEATS as f64 - 1.0) => TOLD,
            PlaybackStage::Contact(_) => PlaybackStage::Departure(0.0),
            PlaybackStage::Departure(_) => PlaybackStage::Halted(self.end),
            PlaybackStage::Halted(time) if time < self.contact => {
                PlaybackStage::Approach(self.screen_time_before(time))
            }
            PlaybackStage::Halted(time) if time < self.end => {
                PlaybackStage::Departure(self.screen_time_after(time))
            }
            PlaybackStage::Halted(_) => PlaybackStage::Halted(self.end),
        };
    }

    /// Goes to the contact at once, with all its layers.
    pub(crate) fn tell(&mut self) {
        self.stage = TOLD;
    }

    /// Plays the whole again.
    pub(crate) fn rewind(&mut self) {
        self.stage = PlaybackStage::Approach(0.0);
    }

    /// Halts, and moves by this share of the whole. A step that would leap over
    /// the contact lands on it.
    pub(crate) fn scrub(&mut self, share: f64) {
        let from = self.time();
        let to = (from + share * self.end).clamp(0.0, self.end);
        let leaps = (from < self.contact && to > self.contact)
            || (from > self.contact && to < self.contact);
        self.stage = PlaybackStage::Halted(if leaps { self.contact } else { to });
    }

    /// Inverse of the approach in [`Playback::time`].
    fn screen_time_before(&self, time: f64) -> f64 {
        let s = time / self.rate();
        if s <= self.coasting() {
            return s;
        }
        let left = (APPROACH - s).max(0.0);
        self.coasting() + EASE - (2.0 * EASE * left).sqrt()
    }

    /// Inverse of the departure in [`Playback::time`].
    fn screen_time_after(&self, time: f64) -> f64 {
        let s = (time - self.contact) / self.rate();
        if s <= EASE / 2.0 {
            (2.0 * EASE * s).sqrt()
        } else {
            s + EASE / 2.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(clock: &mut Playback, seconds: f64) {
        let frames = (seconds / FRAME.as_secs_f64()).round() as usize;
        for _ in 0..frames {
            clock.advance(FRAME);
        }
    }

    #[test]
    fn it_slows_into_the_contact_and_holds_there() {
        let mut clock = Playback::new(0.03, 0.06, false);
        let mut last = -1.0;
        while !clock.has_met() {
            assert!(clock.time() > last, "time always runs on");
            last = clock.time();
            clock.advance(FRAME);
        }
        assert!(clock.at_contact());
        assert_eq!(clock.beats(), 1);
        run(&mut clock, 10.0);
        assert!(clock.at_contact() && !clock.is_running());
        assert_eq!(clock.beats(), BEATS);
    }

    #[test]
    fn from_the_contact_it_goes_on_to_the_end() {
        let mut clock = Playback::new(0.03, 0.06, true);
        assert!(clock.at_contact() && !clock.is_running());
        clock.go_on();
        assert!(clock.is_running());
        run(&mut clock, 10.0);
        assert!(clock.is_over() && !clock.is_running());
    }

    #[test]
    fn scrubbing_never_leaps_over_the_contact() {
        let mut clock = Playback::new(0.031, 0.06, true);
        clock.scrub(0.05);
        assert!(clock.has_met() && !clock.at_contact());
        clock.scrub(-0.2);
        assert!(clock.at_contact());
        clock.scrub(-0.2);
        assert!(!clock.has_met());
        clock.scrub(-9.0);
        assert!(clock.time() == 0.0);
        clock.scrub(0.9);
        assert!(clock.at_contact());
        clock.scrub(9.0);
        assert!(clock.is_over());
    }

    #[test]
    fn going_on_after_a_halt_starts_where_it_stood() {
        for share in [0.1, 0.3, 0.45, 0.49] {
            let mut clock = Playback::new(0.03, 0.06, false);
            clock.scrub(share);
            let before = clock.time();
            clock.go_on();
            assert!((clock.time() - before).abs() < 1e-12);
            assert!(clock.is_running());
        }
        for share in [0.01, 0.1, 0.3, 0.45] {
            let mut clock = Playback::new(0.03, 0.06, true);
            clock.scrub(share);
            let before = clock.time();
            clock.go_on();
            assert!((clock.time() - before).abs() < 1e-12);
        }
    }
}
