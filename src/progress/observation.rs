//! What a player saw in a hit before the angles were shown.
//!
//! Observations are kept separate from answers: they are not evidence for a misconception, and do
//! not count towards any topic. About one in five observations of a demonstration in physics
//! lectures differs from what happened (Miller, Lasry, Chu & Mazur 2013, *Phys. Rev. ST Phys. Educ.
//! Res.* 9, 020113).

use serde::Serialize;
use serde_json::{Value, json};

use super::utc;
use crate::numbers::counted;
use crate::physics::units::rad_from_deg;
use crate::quiz::Rays;

/// An observation, with the prediction made before it.
#[derive(Debug, Clone, PartialEq)]
pub struct Observation {
    /// The time in seconds since the start of 1970 (UTC), which is set by the store; `None` until
    /// the observation is stored, or if the time is unknown.
    pub time_s: Option<i64>,
    /// The player's name.
    pub player: String,
    /// Where the hit was observed.
    pub place: ObservationPlace,
    /// Where the player predicted that the discs would go.
    pub said: Rays,
    /// Where the discs went.
    pub truth: Rays,
    /// Where the player saw the discs go.
    pub seen: Rays,
}

/// Where a hit was observed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, strum::EnumString, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum ObservationPlace {
    /// The player saw the hit in the lab.
    Lab,
    /// The player saw the hit in the quiz.
    Quiz,
}

/// An observation is right if both rays are within this angle of the true rays: observing is less
/// accurate than calculating.
const SEEN_DEG: f64 = 10.0;
/// A prediction can be distinguished from what happened if it is wrong by at least this angle.
const APART_DEG: f64 = 20.0;
/// How many observations are considered: the most recent of those that can show whether a player
/// sees what they expect.
const LATEST: usize = 10;
/// carrom reports that the player sees what they expect only if at least this number of
/// observations are closer to the prediction.
const ENOUGH: usize = 3;

impl Observation {
    /// Whether the player saw what happened.
    pub fn is_right(&self) -> bool {
        is_close(&self.seen, &self.truth)
    }

    /// Whether the prediction was within the tolerance for observations.
    pub fn was_expected(&self) -> bool {
        is_close(&self.said, &self.truth)
    }

    /// Whether the prediction was far enough from what happened to show which of the two an
    /// observation is closer to.
    fn can_follow(&self) -> bool {
        self.said.gap(&self.truth) >= rad_from_deg(APART_DEG)
    }

    /// Whether the prediction was at least 20° off, and the observation is wrong and closer to the
    /// prediction than to what happened.
    pub fn follows_prediction(&self) -> bool {
        self.can_follow()
            && !self.is_right()
            && self.seen.gap(&self.said) < self.seen.gap(&self.truth)
    }

    /// One to three sentences on the observation and the prediction.
    pub(crate) fn words(&self) -> &'static str {
        match (self.was_expected(), self.is_right()) {
            (true, true) => "You predicted it, and you saw it.",
            (false, true) => {
                "Your prediction was off, but you saw what really happened. That is how a \
                 prediction is tested."
            }
            (_, false) if self.follows_prediction() => {
                "You saw something closer to your prediction than to what happened. That is \
                 common: it is easy to see what you expect. Watch the collision once more."
            }
            (_, false) => {
                "What you saw differs from what happened by more than 10°. Watch the collision \
                 once more."
            }
        }
    }
}

fn is_close(rays: &Rays, truth: &Rays) -> bool {
    rays.gap(truth) <= rad_from_deg(SEEN_DEG)
}

/// The number of a player's observations that are right, and the number that follow the prediction.
/// The names of the fields are those in JSON.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct ObservationCounts {
    /// The number of all observations.
    pub made: usize,
    /// The number of observations that are right.
    pub right: usize,
    /// The number of observations that are wrong even though the prediction was right.
    pub wrong_after_right_prediction: usize,
    /// The number of observations that are right even though the prediction was wrong.
    pub right_after_wrong_prediction: usize,
    /// The number of observations that [follow the prediction](Observation::follows_prediction).
    pub closer_to_prediction: usize,
    /// The number of the latest observations after predictions that were at least 20° off, up to
    /// ten.
    pub latest_clear: usize,
    /// How many of these follow the prediction.
    pub latest_closer_to_prediction: usize,
    /// Whether the player tends to see what they expect: of the latest ten observations that can
    /// show this, at least three follow the prediction, and more than half do.
    pub sees_what_is_expected: bool,
}

impl ObservationCounts {
    /// The counts for these observations, of which the latest come last.
    pub fn new(observations: &[Observation]) -> Self {
        let all = || observations.iter();
        let count = |is: fn(&Observation) -> bool| all().filter(|it| is(it)).count();
        let clear: Vec<_> = all().filter(|it| it.can_follow()).collect();
        let latest = &clear[clear.len().saturating_sub(LATEST)..];
        let follow = latest.iter().filter(|it| it.follows_prediction()).count();
        Self {
            made: observations.len(),
            right: count(Observation::is_right),
            wrong_after_right_prediction: count(|it| it.was_expected() && !it.is_right()),
            right_after_wrong_prediction: count(|it| !it.was_expected() && it.is_right()),
            closer_to_prediction: count(Observation::follows_prediction),
            latest_clear: latest.len(),
            latest_closer_to_prediction: follow,
            sees_what_is_expected: follow >= ENOUGH && 2 * follow > latest.len(),
        }
    }

    /// The counts in sentences; empty if there are no observations.
    pub fn words(&self) -> Vec<String> {
        if self.made == 0 {
            return Vec::new();
        }
        let (all, right) = (counted(self.made, "observation"), self.right);
        let mut words = vec![format!(
            "Before the angles were shown: {right} of {all} within 10° of what happened."
        )];
        if self.right_after_wrong_prediction > 0 {
            words.push(format!(
                "After {} the observation was right although the prediction was not.",
                counted(self.right_after_wrong_prediction, "hit")
            ));
        }
        if self.sees_what_is_expected {
            let (clear, follow) = (self.latest_clear, self.latest_closer_to_prediction);
            words.push(format!(
                "In {follow} of the latest {clear} hits that differed clearly from the \
                 prediction, the observation was closer to the prediction. That happens to many \
                 people, and knowing it helps: watch one disc at a time, and decide where it went \
                 before you think of the prediction."
            ));
        }
        words
    }
}

/// The observations as JSON, for use in other programs; the order stays the same.
pub(crate) fn observations_json(observations: &[Observation]) -> Value {
    let one = |it: &Observation| {
        json!({
            "time": it.time_s.and_then(utc),
            "player": it.player,
            "place": <&str>::from(it.place),
            "prediction": it.said.json(),
            "truth": it.truth.json(),
            "observation": it.seen.json(),
            "right": it.is_right(),
        })
    };
    observations.iter().map(one).collect()
}

#[cfg(test)]
mod tests {
    use rand::{Rng, RngExt};
    use rand_pcg::Pcg64Mcg;
    use rand_pcg::rand_core::SeedableRng;

    use super::*;

    fn rays(theta1: f64, theta2: f64) -> Rays {
        Rays::new(theta1.to_radians(), theta2.to_radians())
    }

    fn observation(said: Rays, truth: Rays, seen: Rays) -> Observation {
        Observation {
            time_s: None,
            player: "Ada".into(),
            place: ObservationPlace::Lab,
            said,
            truth,
            seen,
        }
    }

    #[test]
    fn a_wrong_prediction_is_kept_apart_from_a_wrong_observation() {
        let truth = rays(60.0, 30.0);
        let off = rays(30.0, 60.0);
        for (said, seen, words) in [
            (truth, truth, "predicted it, and you saw it"),
            (off, rays(63.0, 24.0), "you saw what really happened"),
            (off, rays(32.0, 55.0), "closer to your prediction"),
            (truth, rays(20.0, 30.0), "differs from what happened"),
            (off, rays(100.0, 10.0), "differs from what happened"),
        ] {
            let it = observation(said, truth, seen);
            assert!(it.words().contains(words), "{} {words}", it.words());
        }
        let counts = ObservationCounts::new(&[
            observation(off, truth, truth),
            observation(truth, truth, off),
            observation(off, truth, off),
        ]);
        assert_eq!((counts.made, counts.right), (3, 1));
        assert_eq!(counts.right_after_wrong_prediction, 1);
        assert_eq!(counts.wrong_after_right_prediction, 1);
        assert_eq!(counts.closer_to_prediction, 1);
        assert!(!counts.sees_what_is_expected);
        assert!(ObservationCounts::default().words().is_empty());
    }

    /// The fraction of `students` simulated students for whom the report says at some point during
    /// their 20 observations that they see what they expect. A student sees the prediction in a
    /// fraction `follows` of the hits, and what happened in the others; in both cases each ray has
    /// a normally distributed error with a standard deviation of `sigma_deg`.
    fn named(students: u64, follows: f64, sigma_deg: f64) -> f64 {
        let mut dice = Pcg64Mcg::seed_from_u64(7);
        let mut count = 0;
        for _ in 0..students {
            let mut seen = Vec::new();
            let mut is_named = false;
            for _ in 0..20 {
                let theta1 = dice.random_range(20.0..70.0);
                let truth = rays(theta1, 90.0 - theta1);
                // The most common mistakes: the two angles are swapped, or assumed to be equal.
                let said = match dice.random_bool(0.5) {
                    true => rays(90.0 - theta1, theta1),
                    false => rays(45.0, 45.0),
                };
                let believed = if dice.random_bool(follows) {
                    said
                } else {
                    truth
                };
                let [e1, e2] = [(); 2].map(|()| rad_from_deg(sigma_deg * normal(&mut dice)));
                let [a, b] = [
                    believed.striker.unwrap() + e1,
                    believed.target.unwrap() + e2,
                ];
                seen.push(observation(said, truth, Rays::new(a, b)));
                is_named |= ObservationCounts::new(&seen).sees_what_is_expected;
            }
            count += u64::from(is_named);
        }
        count as f64 / students as f64
    }

    /// A number from the standard normal distribution (Box–Muller).
    fn normal(dice: &mut impl Rng) -> f64 {
        let [u, v] = [
            dice.random_range(1e-12..1.0_f64),
            dice.random_range(0.0..1.0),
        ];
        (-2.0 * u.ln()).sqrt() * (std::f64::consts::TAU * v).cos()
    }

    /// The rates are quoted in `docs/judging.md`.
    #[test]
    fn a_student_who_sees_what_they_expect_is_recognized_and_others_are_not() {
        let exact = named(2000, 0.0, 5.0);
        let rough = named(2000, 0.0, 10.0);
        let usual = named(2000, 0.2, 5.0);
        let expects = named(2000, 1.0, 5.0);
        println!("named: {exact} with 5°, {rough} with 10°, {usual} of 20 %, {expects} of all");
        assert!(exact < 0.001, "{exact}");
        assert!(rough < 0.05, "{rough}");
        assert!(usual < 0.15, "{usual}");
        assert!(expects > 0.99, "{expects}");
    }
}
