//! When to come back to what.
//!
//! The schedule runs by topic, not by family: a topic is what one can know and forget,
//! and several families ask about the same one, each in its own way. To be asked by
//! another family next time shows whether the idea has been understood, and not only
//! the kind of question. A review asks once about each topic that is due.
//!
//! Each topic climbs a ladder of intervals: 1, 2, 4, 8, 16 and 32 days. It is due when
//! the interval of its step has passed since it came there.
//!
//! - Wrong, or right by a guess: off the ladder, and due at once.
//! - Right from off the ladder: on its first step.
//! - Right when it is due: one step up, until the last.
//! - Right before it is due: nothing changes, for ten right answers in a row on one
//!   day say no more than one.
//!
//! This is the box of cards of S. Leitner (1972): the better something is known, the
//! longer it may rest, and an answer that takes some effort teaches most.

use super::Attempt;
use crate::quiz::Confidence;

/// A day in seconds.
pub const DAY_S: i64 = 86_400;

/// The last step; the first is 0.
const LAST: u32 = 5;

/// A topic and when to come back to it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Review {
    /// The family that asked about it last.
    pub family: String,
    /// The topic.
    pub topic: String,
    /// Its step on the ladder, from 0: it rests for 2ⁿ days. `None` off the ladder.
    pub step: Option<u32>,
    /// When it came there, in seconds since 1970 began.
    since_s: i64,
}

impl Review {
    /// When it is due, in seconds since 1970 began.
    pub fn due_s(&self) -> i64 {
        let rest = self.step.map_or(0, |step| DAY_S << step);
        self.since_s.saturating_add(rest)
    }

    /// When it is due as seen from `now_s`, in few letters: "now", "in hours", "in 2 days".
    pub fn when(&self, now_s: i64) -> String {
        match self.due_s().saturating_sub(now_s) {
            ..=0 => "now".into(),
            1..DAY_S => "in hours".into(),
            left => match left / DAY_S {
                1 => "in 1 day".into(),
                days => format!("in {days} days"),
            },
        }
    }

    /// Whether it is due at `now_s`.
    pub fn is_due(&self, now_s: i64) -> bool {
        self.due_s() <= now_s
    }
}

/// When to come back to each topic, the earliest first. Attempts whose time nobody
/// knows are left out.
pub fn reviews(attempts: &[Attempt]) -> Vec<Review> {
    let mut reviews: Vec<Review> = Vec::new();
    for attempt in attempts {
        let Some(time_s) = attempt.time_s else {
            continue;
        };
        let known = attempt.right && attempt.confidence != Some(Confidence::Guess);
        let found = reviews.iter().position(|it| it.topic == attempt.topic);
        let step = match found.and_then(|i| reviews[i].step.map(|step| (step, &reviews[i]))) {
            _ if !known => None,
            Some((step, review)) if review.is_due(time_s) => Some((step + 1).min(LAST)),
            // Too early to say more than is known already.
            Some(_) => continue,
            None => Some(0),
        };
        let review = Review {
            family: attempt.family.clone(),
            topic: attempt.topic.clone(),
            step,
            since_s: time_s,
        };
        match found {
            Some(i) => reviews[i] = review,
            None => reviews.push(review),
        }
    }
    reviews.sort_by_key(Review::due_s);
    reviews
}

#[cfg(test)]
mod tests {
    use super::super::tally::tests::attempt;
    use super::*;

    fn on_day(day: i64, right: bool) -> Attempt {
        Attempt {
            time_s: Some(1_000_000 + day * DAY_S),
            ..attempt("a", if right { 0.0 } else { 20.0 })
        }
    }

    /// The step and the day on which the one topic of these attempts is due.
    fn due(attempts: &[(i64, bool)]) -> (Option<u32>, i64) {
        let attempts: Vec<_> = attempts.iter().map(|it| on_day(it.0, it.1)).collect();
        let reviews = reviews(&attempts);
        assert_eq!(reviews.len(), 1);
        let day = (reviews[0].due_s() - 1_000_000) / DAY_S;
        assert!(reviews[0].is_due(reviews[0].due_s()));
        assert!(!reviews[0].is_due(reviews[0].due_s() - 1));
        (reviews[0].step, day)
    }

    #[test]
    fn what_is_known_rests_twice_as_long_each_time() {
        assert_eq!(due(&[(0, true)]), (Some(0), 1));
        assert_eq!(due(&[(0, true), (1, true)]), (Some(1), 3));
        assert_eq!(due(&[(0, true), (1, true), (3, true)]), (Some(2), 7));
        let always: Vec<_> = (0..9).map(|i| (40 * i, true)).collect();
        assert_eq!(due(&always), (Some(LAST), 8 * 40 + 32));
    }

    #[test]
    fn what_comes_too_early_changes_nothing() {
        assert_eq!(due(&[(0, true), (0, true), (0, true)]), (Some(0), 1));
        assert_eq!(due(&[(0, true), (1, true), (2, true)]), (Some(1), 3));
    }

    #[test]
    fn what_is_missed_is_due_at_once_and_starts_afresh() {
        assert_eq!(due(&[(0, false)]), (None, 0));
        assert_eq!(due(&[(0, true), (1, true), (2, false)]), (None, 2));
        assert_eq!(due(&[(0, false), (0, true)]), (Some(0), 1));
        let guessed = Attempt {
            confidence: Some(Confidence::Guess),
            ..on_day(4, true)
        };
        assert_eq!(reviews(&[guessed])[0].step, None);
    }

    #[test]
    fn the_earliest_comes_first_and_what_has_no_time_not_at_all() {
        let other = Attempt {
            topic: "b".into(),
            ..on_day(0, false)
        };
        let timeless = Attempt {
            topic: "c".into(),
            time_s: None,
            ..on_day(0, false)
        };
        let reviews = reviews(&[on_day(0, true), other, timeless]);
        let topics: Vec<_> = reviews.iter().map(|it| it.topic.as_str()).collect();
        assert_eq!(topics, ["b", "a"]);
    }
}
