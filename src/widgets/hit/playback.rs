//! The clock of a collision, which runs up to the contact, then step by step at the contact, and
//! finally on to the end.

use std::time::Duration;

/// The shortest time between two frames: a sixtieth of a second.
pub(crate) const FRAME: Duration = Duration::from_micros(16_667);

/// How long the approach would last on the screen if the motion did not slow down, in seconds.
const APPROACH: f64 = 1.1;
/// The time over which the motion slows down before the contact and speeds up after it, in seconds.
const EASE: f64 = 0.35;
/// The size of a small step in time, as a fraction of the shot's duration.
const STEP: f64 = 1.0 / 96.0;

/// How a collision is played.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum HitPace {
    /// The discs move, and each step of the explanation lasts long enough to be read.
    #[default]
    Flowing,
    /// The discs move, and each step waits for a key.
    Waiting,
    /// Nothing moves: the picture shows the contact, where each step waits for a key, and then
    /// jumps to the end.
    Still,
}

/// The current stage of the playback.
#[derive(Debug, Clone, Copy, PartialEq)]
enum PlaybackStage {
    /// The discs are approaching the contact; the value is the time on the screen so far, in
    /// seconds.
    Approach(f64),
    /// The playback is at the contact, at this step of the explanation; `stood` is the time spent
    /// on the step so far, in seconds.
    Contact { step: usize, stood: f64 },
    /// The discs are moving away from the contact; the value is the time on the screen since then,
    /// in seconds.
    Departure(f64),
    /// The playback stands still at this time of the shot, before or after the contact.
    Halted(f64),
}

/// The clock of a collision.
///
/// `contact` and `end` are times in the shot, in the shot's own seconds. The picture is always
/// derived from the stage, so steps, scrubbing and slow motion only have to set the stage. At the
/// contact the clock stops for the steps of the explanation.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Playback {
    pub(super) contact: f64,
    end: f64,
    /// How many seconds each step lasts if no key is pressed; the last step lasts until a key is
    /// pressed.
    holds: Vec<f64>,
    stage: PlaybackStage,
}

impl Playback {
    /// Creates a clock at the start of a shot whose discs touch at `contact` and that is shown
    /// until `end`; with reduced motion, the clock starts at the contact. The explanation always
    /// has at least one step.
    pub(crate) fn new(contact: f64, end: f64, holds: Vec<f64>, pace: HitPace) -> Self {
        Self {
            contact,
            end,
            holds,
            stage: match pace {
                HitPace::Still => PlaybackStage::at_step(0),
                _ => PlaybackStage::Approach(0.0),
            },
        }
    }

    /// This clock with a single step at the contact.
    #[must_use]
    pub(super) fn in_one_step(mut self) -> Self {
        self.holds.truncate(1);
        if let PlaybackStage::Contact { .. } = self.stage {
            self.stage = PlaybackStage::at_step(0);
        }
        self
    }

    /// The last step of the explanation.
    fn last(&self) -> usize {
        self.holds.len().saturating_sub(1)
    }

    /// The current time of the shot, in the shot's own seconds.
    pub(crate) fn time(&self) -> f64 {
        match self.stage {
            PlaybackStage::Approach(s) => {
                // The rate is constant at first, then decreases linearly to 0 over EASE.
                let coasting = s.min(self.coasting());
                let easing = (s - coasting).min(EASE);
                let time = self.rate() * (coasting + easing - easing * easing / (2.0 * EASE));
                time.min(self.contact)
            }
            PlaybackStage::Contact { .. } => self.contact,
            PlaybackStage::Departure(s) => {
                let easing = s.min(EASE);
                let time = self.rate() * (easing * easing / (2.0 * EASE) + s - easing);
                (self.contact + time).min(self.end)
            }
            PlaybackStage::Halted(time) => time,
        }
    }

    /// Seconds of the shot per second on the screen while the rate is constant.
    pub(crate) fn rate(&self) -> f64 {
        self.contact / APPROACH
    }

    /// The factor by which the playback is slower than the real collision.
    pub(crate) fn slowed(&self) -> f64 {
        1.0 / self.rate()
    }

    /// How many seconds pass on the screen before the motion slows down.
    fn coasting(&self) -> f64 {
        APPROACH - EASE / 2.0
    }

    /// The delay until the clock next has to advance; `None` while the clock waits for a key or the
    /// playback is over.
    pub(crate) fn wake(&self, pace: HitPace) -> Option<Duration> {
        match self.stage {
            PlaybackStage::Approach(_) => Some(FRAME),
            PlaybackStage::Contact { step, stood } => {
                let goes_on = pace == HitPace::Flowing && step < self.last();
                let left = self.holds.get(step).map_or(0.0, |hold| hold - stood);
                goes_on.then(|| Duration::from_secs_f64(left.max(0.0)))
            }
            PlaybackStage::Departure(_) => (!self.is_over()).then_some(FRAME),
            PlaybackStage::Halted(_) => None,
        }
    }

    pub(crate) fn is_moving(&self) -> bool {
        match self.stage {
            PlaybackStage::Approach(_) => true,
            PlaybackStage::Departure(_) => !self.is_over(),
            _ => false,
        }
    }

    /// Whether the shot has reached the contact.
    pub(crate) fn has_met(&self) -> bool {
        self.time() >= self.contact
    }

    /// Whether the shot is exactly at the contact.
    pub(crate) fn at_contact(&self) -> bool {
        self.has_met() && self.time() <= self.contact
    }

    /// Whether there is nothing more to show.
    pub(crate) fn is_over(&self) -> bool {
        self.time() >= self.end
    }

    /// The step of the explanation that has been reached: `None` before the contact, the last step
    /// after it.
    pub(crate) fn step_reached(&self) -> Option<usize> {
        match self.stage {
            PlaybackStage::Contact { step, .. } => Some(step),
            _ => self.has_met().then(|| self.last()),
        }
    }

    /// Whether the last step of the explanation has been reached.
    pub(crate) fn is_revealed(&self) -> bool {
        self.step_reached() == Some(self.last())
    }

    /// Advances by `passed` of screen time. Time left over at the end of a step counts towards the
    /// next step.
    pub(crate) fn advance(&mut self, passed: Duration, pace: HitPace) {
        if self.wake(pace).is_none() {
            return;
        }
        let passed = passed.as_secs_f64();
        self.stage = match self.stage {
            PlaybackStage::Approach(_) if pace == HitPace::Still => PlaybackStage::at_step(0),
            PlaybackStage::Approach(s) => {
                let left = self.coasting() + EASE - s;
                if passed < left {
                    PlaybackStage::Approach(s + passed)
                } else {
                    PlaybackStage::Contact {
                        step: 0,
                        stood: passed - left,
                    }
                }
            }
            PlaybackStage::Contact { step, stood } => {
                let left = self.holds.get(step).map_or(0.0, |hold| hold - stood);
                if passed < left {
                    let stood = stood + passed;
                    PlaybackStage::Contact { step, stood }
                } else {
                    PlaybackStage::Contact {
                        step: step + 1,
                        stood: passed - left,
                    }
                }
            }
            PlaybackStage::Departure(_) if pace == HitPace::Still => {
                PlaybackStage::Halted(self.end)
            }
            PlaybackStage::Departure(s) => PlaybackStage::Departure(s + passed),
            halted @ PlaybackStage::Halted(_) => halted,
        };
    }

    /// Continues: during the approach, jumps to the contact; at the contact, goes to the next step;
    /// after the last step or a pause, plays on; while the discs move apart, jumps to the end.
    pub(crate) fn go_on(&mut self) {
        self.stage = match self.stage {
            PlaybackStage::Approach(_) => PlaybackStage::at_step(0),
            PlaybackStage::Contact { step, .. } if step < self.last() => {
                PlaybackStage::at_step(step + 1)
            }
            PlaybackStage::Contact { .. } => PlaybackStage::Departure(0.0),
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

    /// Jumps to the contact and shows the whole explanation.
    pub(crate) fn reveal(&mut self) {
        self.stage = PlaybackStage::at_step(self.last());
    }

    /// Jumps to the end of the explanation; if it has already been reached, jumps to the end of the
    /// shot.
    pub(crate) fn finish(&mut self) {
        match self.is_revealed() {
            true => self.stage = PlaybackStage::Halted(self.end),
            false => self.reveal(),
        }
    }

    pub(crate) fn halt_at_start(&mut self) {
        self.stage = PlaybackStage::Halted(0.0);
    }

    /// Plays the whole shot again.
    pub(crate) fn rewind(&mut self) {
        self.stage = PlaybackStage::Approach(0.0);
    }

    /// Moves by `by` steps, backwards if negative: at the contact these are steps of the
    /// explanation, otherwise small steps in time.
    pub(crate) fn step(&mut self, by: i8) {
        let next = match self.stage {
            PlaybackStage::Contact { step, .. } => step.checked_add_signed(by.into()),
            _ => None,
        };
        match next.filter(|step| *step <= self.last()) {
            Some(step) => self.stage = PlaybackStage::at_step(step),
            None => self.scrub(STEP * f64::from(by)),
        }
    }

    /// Pauses, and moves by the fraction `share` of the shot's duration, backwards if negative. A
    /// move that would cross the contact stops there: going forwards, at the first step of the
    /// explanation; going backwards, at the last.
    pub(crate) fn scrub(&mut self, share: f64) {
        let from = self.time();
        let to = (from + share * self.end).clamp(0.0, self.end);
        self.stage = if from < self.contact && to >= self.contact {
            PlaybackStage::at_step(0)
        } else if from > self.contact && to <= self.contact {
            PlaybackStage::at_step(self.last())
        } else {
            PlaybackStage::Halted(to)
        };
    }

    /// The inverse of the approach in [`Playback::time`].
    fn screen_time_before(&self, time: f64) -> f64 {
        let s = time / self.rate();
        if s <= self.coasting() {
            return s;
        }
        let left = (APPROACH - s).max(0.0);
        self.coasting() + EASE - (2.0 * EASE * left).sqrt()
    }

    /// The inverse of the departure in [`Playback::time`].
    fn screen_time_after(&self, time: f64) -> f64 {
        let s = (time - self.contact) / self.rate();
        if s <= EASE / 2.0 {
            (2.0 * EASE * s).sqrt()
        } else {
            s + EASE / 2.0
        }
    }
}

impl PlaybackStage {
    /// The stage at the start of a step of the explanation.
    const fn at_step(step: usize) -> Self {
        Self::Contact { step, stood: 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HOLDS: [f64; 3] = [6.0, 8.0, 5.0];

    fn clock(pace: HitPace) -> Playback {
        Playback::new(0.03, 0.06, HOLDS.into(), pace)
    }

    fn run(clock: &mut Playback, pace: HitPace, seconds: f64) {
        let frames = (seconds / FRAME.as_secs_f64()).round() as usize;
        for _ in 0..frames {
            clock.advance(FRAME, pace);
        }
    }

    #[test]
    fn it_slows_down_before_the_contact_and_each_step_lasts_its_full_time() {
        let mut clock = clock(HitPace::Flowing);
        let mut last = -1.0;
        while !clock.has_met() {
            assert!(clock.time() > last, "time always advances");
            last = clock.time();
            clock.advance(FRAME, HitPace::Flowing);
        }
        for (step, hold) in HOLDS.into_iter().enumerate() {
            assert_eq!(clock.step_reached(), Some(step));
            run(&mut clock, HitPace::Flowing, hold - 0.3);
            assert!(clock.at_contact());
            assert_eq!(clock.step_reached(), Some(step), "the step has not ended");
            run(&mut clock, HitPace::Flowing, 0.4);
        }
        // The last step lasts until a key is pressed.
        run(&mut clock, HitPace::Flowing, 100.0);
        assert!(clock.at_contact() && clock.is_revealed());
        assert_eq!(clock.wake(HitPace::Flowing), None);
    }

    #[test]
    fn steps_that_wait_for_a_key_never_advance_by_themselves() {
        for pace in [HitPace::Waiting, HitPace::Still] {
            let mut clock = clock(pace);
            run(&mut clock, pace, 10.0);
            for step in 0..HOLDS.len() {
                assert_eq!(clock.step_reached(), Some(step), "{pace:?}");
                assert_eq!(clock.wake(pace), None);
                clock.advance(Duration::from_secs(1000), pace);
                assert_eq!(clock.step_reached(), Some(step));
                clock.go_on();
            }
            assert!(!clock.at_contact() || clock.is_moving());
        }
    }

    #[test]
    fn steps_go_through_the_explanation_in_both_directions() {
        let mut clock = clock(HitPace::Still);
        let mut met = vec![clock.step_reached()];
        for by in [1, 1, 1, -1, -1, -1, -1] {
            clock.step(by);
            met.push(clock.step_reached());
        }
        let expected = [0, 1, 2, 2, 2, 1, 0].map(Some);
        assert_eq!(met[..7], expected);
        assert_eq!(met[7], None, "before the contact");
        assert!(clock.time() < clock.contact);
        clock.step(1);
        assert_eq!(clock.step_reached(), Some(0));
    }

    #[test]
    fn without_motion_it_jumps_from_the_contact_to_the_end() {
        let mut clock = clock(HitPace::Still);
        clock.reveal();
        clock.go_on();
        clock.advance(FRAME, HitPace::Still);
        assert!(clock.is_over());
        clock.rewind();
        clock.advance(FRAME, HitPace::Still);
        assert_eq!(clock.step_reached(), Some(0));
    }

    #[test]
    fn from_the_contact_it_continues_to_the_end() {
        let mut clock = clock(HitPace::Flowing);
        clock.finish();
        assert!(clock.at_contact() && clock.is_revealed() && !clock.is_moving());
        clock.go_on();
        assert!(clock.is_moving());
        run(&mut clock, HitPace::Flowing, 10.0);
        assert!(clock.is_over() && !clock.is_moving());
    }

    #[test]
    fn scrubbing_never_skips_the_contact() {
        let mut clock = Playback::new(0.031, 0.06, HOLDS.into(), HitPace::Still);
        clock.scrub(0.05);
        assert!(clock.has_met() && !clock.at_contact());
        clock.scrub(-0.2);
        assert!(clock.at_contact() && clock.is_revealed());
        clock.scrub(-0.2);
        assert!(!clock.has_met());
        clock.scrub(-9.0);
        assert!(clock.time() == 0.0);
        clock.scrub(0.9);
        assert!(clock.at_contact() && !clock.is_revealed());
        clock.scrub(9.0);
        assert!(clock.is_over());
    }

    #[test]
    fn after_a_halt_it_continues_from_the_same_time() {
        for (pace, shares) in [
            (HitPace::Flowing, [0.1, 0.3, 0.45, 0.49]),
            (HitPace::Still, [0.01, 0.1, 0.3, 0.45]),
        ] {
            for share in shares {
                let mut clock = clock(pace);
                clock.scrub(share);
                let before = clock.time();
                clock.go_on();
                assert!((clock.time() - before).abs() < 1e-12);
                assert!(clock.is_moving());
            }
        }
    }
}
