//! Schedules the review of each topic.
//!
//! The schedule is by topic, not by family: a topic is what a person can know and forget, and
//! several families ask about the same topic in different ways. A question from another family
//! shows whether the player has understood the idea rather than just one kind of question. A review
//! has one question about each topic that is due.
//!
//! Each topic climbs a ladder whose steps are intervals: 1, 2, 4, 8, 16 and 32 days. The topic is
//! due when the interval of its step has passed since the day on which it reached the step. Days
//! are those of the player's calendar: a topic answered yesterday evening is due this morning.
//!
//! - Wrong, or right by a guess: the topic leaves the ladder and is due at once.
//! - Right while off the ladder: the topic goes to the first step.
//! - Right when due: the topic goes one step up, as far as the last step. After a wait that was
//!   longer than planned, it may go up more than one step: after n days, the next interval is the
//!   largest power of two that is at most n.
//! - Right before it is due: nothing changes, because ten right answers on one day show no more
//!   than one.
//!
//! A question missed in a chapter makes its topic due as well, but on the next day, and with a
//! different question. A topic that was missed only in chapters leaves the list once it has been
//! answered correctly twice when due.
//!
//! This is the box of cards of S. Leitner (1972): the better something is known, the longer it may
//! wait, and an answer that requires some effort has the greatest effect.

use indexmap::IndexMap;
use jiff::ToSpan;
use jiff::civil::Date;

use super::{Attempt, Calendar, LESSON};
use crate::numbers::counted;
use crate::quiz::Confidence;

/// The last step; the first is 0.
const LAST: u32 = 5;

/// A topic and the time of its next review.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Review {
    /// The family of the last question about the topic.
    pub family: String,
    /// The topic, as in [`Attempt::topic`].
    pub topic: String,
    /// The topic's step n on the ladder, from 0: the next review is 2ⁿ days later. `None` if the
    /// topic is off the ladder.
    pub step: Option<u32>,
    /// The first day on which the topic is due.
    pub due: Date,
    /// The time at which the topic reached its step, in seconds since the start of 1970.
    since_s: i64,
    /// Whether the topic was missed only in chapters.
    of_chapter: bool,
}

/// The step at which a topic that was missed only in chapters leaves the list.
const DONE: u32 = 1;

impl Review {
    /// Describes when the topic is due, relative to `today`: "now", "in 2 days".
    pub fn when(&self, today: Date) -> String {
        match usize::try_from((self.due - today).get_days()) {
            Ok(days @ 1..) => format!("in {}", counted(days, "day")),
            _ => "now".into(),
        }
    }

    /// The number of days from the day on which the topic reached its step to the given day.
    fn days_to(&self, day: Date) -> u32 {
        let rest = self.step.map_or(0, |step| 1_i32 << step);
        let days = (day - self.due).get_days() + rest;
        u32::try_from(days).unwrap_or(0)
    }

    /// Whether the topic is due on this day.
    pub(crate) fn is_due(&self, today: Date) -> bool {
        self.due <= today
    }
}

/// The next review of each topic, earliest first. Attempts without a time are left out.
pub(crate) fn reviews(attempts: &[Attempt], calendar: &Calendar) -> Vec<Review> {
    let mut reviews: IndexMap<&str, Review> = IndexMap::new();
    for attempt in attempts {
        let day = attempt
            .time_s
            .and_then(|time_s| Some((time_s, calendar.day(time_s)?)));
        let Some((since_s, day)) = day else {
            continue;
        };
        if attempt.family == LESSON
            && !attempt.right
            && let Some(topic) = attempt.quiz_topic()
        {
            let found = reviews.get(topic);
            let review = Review {
                family: found.map_or_else(String::new, |it| it.family.clone()),
                topic: topic.to_owned(),
                step: None,
                due: day.saturating_add(1.days()),
                since_s,
                of_chapter: found.is_none_or(|it| it.of_chapter),
            };
            reviews.insert(topic, review);
        }
        let known = attempt.right && attempt.confidence != Some(Confidence::Guess);
        let found = reviews.get(attempt.topic.as_str());
        let of_chapter = known && found.is_some_and(|it| it.of_chapter);
        let step = match found.and_then(|it| Some((it.step?, it))) {
            _ if !known => None,
            Some((step, review)) if review.is_due(day) => {
                let rested = review.days_to(day).max(1).ilog2();
                Some((step + 1).max(rested).min(LAST))
            }
            // The topic is not due yet, so nothing changes.
            Some(_) => continue,
            None if of_chapter && found.is_some_and(|it| !it.is_due(day)) => continue,
            None => Some(0),
        };
        if of_chapter && step >= Some(DONE) {
            reviews.shift_remove(attempt.topic.as_str());
            continue;
        }
        let rest = step.map_or(0, |step| 1_i64 << step);
        let review = Review {
            family: attempt.family.clone(),
            topic: attempt.topic.clone(),
            step,
            due: day.saturating_add(rest.days()),
            since_s,
            of_chapter,
        };
        reviews.insert(&attempt.topic, review);
    }
    let mut reviews: Vec<Review> = reviews.into_values().collect();
    reviews.sort_by_key(|review| (review.due, review.since_s));
    reviews
}

#[cfg(test)]
mod tests {
    use super::super::tally::tests::attempt;
    use jiff::tz::TimeZone;

    use super::*;

    const DAY_S: i64 = 86_400;
    /// A day at 13:46 UTC.
    const START_S: i64 = 1_000_000;

    fn on_day(day: i64, right: bool) -> Attempt {
        Attempt {
            time_s: Some(START_S + day * DAY_S),
            ..attempt("a", if right { 0.0 } else { 20.0 })
        }
    }

    /// The step and the due day of the only topic in these attempts.
    fn due(attempts: &[(i64, bool)]) -> (Option<u32>, i64) {
        let attempts: Vec<_> = attempts.iter().map(|it| on_day(it.0, it.1)).collect();
        let calendar = Calendar::utc(Some(START_S));
        let reviews = reviews(&attempts, &calendar);
        assert_eq!(reviews.len(), 1);
        let due = reviews[0].due;
        assert!(reviews[0].is_due(due) && !reviews[0].is_due(due.yesterday().unwrap()));
        let days = due - calendar.today().unwrap();
        (reviews[0].step, days.get_days().into())
    }

    #[test]
    fn the_interval_of_a_known_topic_doubles_each_time() {
        assert_eq!(due(&[(0, true)]), (Some(0), 1));
        assert_eq!(due(&[(0, true), (1, true)]), (Some(1), 3));
        assert_eq!(due(&[(0, true), (1, true), (3, true)]), (Some(2), 7));
        // After 8 days the topic climbs three steps, after 7 days only two, and after 60 days five.
        assert_eq!(due(&[(0, true), (8, true)]), (Some(3), 16));
        assert_eq!(due(&[(0, true), (7, true)]), (Some(2), 11));
        assert_eq!(due(&[(0, true), (60, true)]), (Some(5), 92));
        assert_eq!(due(&[(0, true), (500, true)]), (Some(LAST), 532));
        // While the topic is off the ladder, a long gap has no effect, because the topic was not
        // known before the gap.
        assert_eq!(due(&[(0, false), (60, true)]), (Some(0), 61));
        let always: Vec<_> = (0..9).map(|i| (40 * i, true)).collect();
        assert_eq!(due(&always), (Some(LAST), 8 * 40 + 32));
    }

    #[test]
    fn an_early_answer_changes_nothing() {
        assert_eq!(due(&[(0, true), (0, true), (0, true)]), (Some(0), 1));
        assert_eq!(due(&[(0, true), (1, true), (2, true)]), (Some(1), 3));
    }

    #[test]
    fn a_missed_topic_is_due_at_once_and_starts_again() {
        assert_eq!(due(&[(0, false)]), (None, 0));
        assert_eq!(due(&[(0, true), (1, true), (2, false)]), (None, 2));
        assert_eq!(due(&[(0, false), (0, true)]), (Some(0), 1));
        let guessed = Attempt {
            confidence: Some(Confidence::Guess),
            ..on_day(4, true)
        };
        assert_eq!(reviews(&[guessed], &Calendar::default())[0].step, None);
    }

    #[test]
    fn the_earliest_review_is_first_and_answers_without_a_time_are_left_out() {
        let other = Attempt {
            topic: "b".into(),
            ..on_day(0, false)
        };
        let timeless = Attempt {
            topic: "c".into(),
            time_s: None,
            ..on_day(0, false)
        };
        let reviews = reviews(&[on_day(0, true), other, timeless], &Calendar::default());
        let topics: Vec<_> = reviews.iter().map(|it| it.topic.as_str()).collect();
        assert_eq!(topics, ["b", "a"]);
    }

    /// A missed question about the topic "a" in a chapter, on this day.
    fn missed_in_a_chapter(day: i64) -> Attempt {
        let mut attempt = Attempt {
            family: LESSON.into(),
            topic: "A chapter".into(),
            ..on_day(day, false)
        };
        attempt.question.insert("topic".into(), "a".into());
        attempt
    }

    #[test]
    fn a_topic_missed_in_a_chapter_is_due_the_next_day_and_leaves_once_answered_twice() {
        let calendar = Calendar::utc(Some(START_S));
        let mut attempts = vec![missed_in_a_chapter(0)];
        let due = |attempts: &[Attempt]| {
            let all = reviews(attempts, &calendar);
            let found = all.iter().find(|it| it.topic == "a");
            found.map(|it| (it.due - calendar.today().unwrap()).get_days())
        };
        assert_eq!(due(&attempts), Some(1));
        // This answer is too early to change anything.
        attempts.push(on_day(0, true));
        assert_eq!(due(&attempts), Some(1));
        attempts.push(on_day(1, true));
        assert_eq!(due(&attempts), Some(2));
        let mut missed = attempts.clone();
        attempts.push(on_day(2, true));
        assert_eq!(due(&attempts), None);
        // A topic that was also missed in the quiz stays on the ladder.
        missed.extend([on_day(2, false), on_day(2, true), on_day(3, true)]);
        assert_eq!(due(&missed), Some(5));
        missed.push(missed_in_a_chapter(4));
        missed.extend([on_day(5, true), on_day(6, true)]);
        assert_eq!(due(&missed), Some(8));
    }

    #[test]
    fn due_dates_follow_the_players_calendar() {
        // 2026-01-05 at 21:30 UTC, and 16 hours later.
        let (evening_s, afternoon_s) = (1_767_648_600, 1_767_648_600 + 16 * 3600);
        let answer = Attempt {
            time_s: Some(evening_s),
            ..attempt("a", 0.0)
        };
        for (hours, due, when) in [(0, true, "now"), (2, true, "now"), (3, false, "in 1 day")] {
            let zone = TimeZone::fixed(jiff::tz::offset(hours));
            let calendar = Calendar::new(Some(afternoon_s), zone);
            let today = calendar.today().unwrap();
            let review = &reviews(std::slice::from_ref(&answer), &calendar)[0];
            assert_eq!(review.is_due(today), due, "{hours}");
            assert_eq!(review.when(today), when, "{hours}");
        }
    }
}
