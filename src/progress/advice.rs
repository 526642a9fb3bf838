//! What to do next.

use super::{Attempt, Calendar, LESSON, Mastery, Trend, beliefs, reviews, topics};

/// How many of the last attempts count as recent.
const LATELY: usize = 10;

/// What to do next, in a sentence or two. The most useful comes first: a misconception that is
/// still held, then what is due today, if that is known, then what the player was sure of and
/// missed, then the topic with the worst recent results.
pub fn advice(attempts: &[Attempt], calendar: &Calendar) -> String {
    if attempts.is_empty() {
        return "Play a round of the quiz: ten hits, and no answer is wasted.".into();
    }
    let held = beliefs(attempts)
        .into_iter()
        .find(|belief| matches!(belief.trend(), Trend::New | Trend::Held));
    if let Some(belief) = held {
        return belief.misconception.advice().to_owned();
    }
    let reviews = reviews(attempts, calendar);
    let due = |today| {
        let mut due = reviews.iter().filter(|review| review.is_due(today));
        due.find(|review| review.comes_back())
    };
    if let Some(review) = calendar.today().and_then(due) {
        return match review.family.as_str() {
            LESSON => format!("Due again, among the chapters: {}.", review.topic_name()),
            _ => format!(
                "Due again: {}. A round of the quiz brings it back.",
                review.topic_name()
            ),
        };
    }
    let lately = &attempts[attempts.len().saturating_sub(LATELY)..];
    if let Some(missed) = lately.iter().rev().find(|it| it.is_surely_wrong()) {
        return format!(
            "You were sure, and it came out differently: {}. Try one of its kind again, and read \
             the explanation slowly.",
            missed.topic_name()
        );
    }
    let topics = topics(attempts);
    let weakest = topics
        .iter()
        .filter(|topic| topic.mastery() != Mastery::Solid)
        .min_by(|a, b| {
            let share = |topic: &super::TopicStanding| topic.lately.share_right().unwrap_or(1.0);
            share(a).total_cmp(&share(b))
        });
    match weakest {
        Some(topic) => format!("What can teach you most now: {}.", topic.name),
        None => "All you have met is solid. Try the levels, or a game at the table.".into(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::tally::tests::attempt;
    use super::*;
    use crate::quiz::figures;
    use crate::quiz::{Confidence, Misconception};
    use serde_json::json;

    #[test]
    fn the_most_useful_advice_comes_first() {
        let mut attempts = Vec::new();
        let mut says = |attempt: Option<Attempt>, now_s| {
            attempts.extend(attempt);
            advice(&attempts, &Calendar::utc(now_s))
        };
        assert!(says(None, None).contains("Play a round"));
        assert!(says(Some(attempt("a", 9.0)), None).contains("teach you most now: a"));
        let sure = Attempt {
            confidence: Some(Confidence::Sure),
            time_s: Some(1000),
            ..attempt("equal-masses", 9.0)
        };
        assert!(says(Some(sure), None).contains("came out differently: equal masses"));
        assert!(says(None, Some(1000)).contains("Due again: equal masses"));
        let held = |number: u32| Attempt {
            question: figures(json!({ "number": number, "by_chance": 0.01 })),
            misconception: Some("swapped".into()),
            ..attempt("equal-masses", 9.0)
        };
        says(Some(held(1)), None);
        let swapped = Misconception::with_id("swapped").unwrap();
        assert_eq!(says(Some(held(2)), None), swapped.advice());
    }

    #[test]
    fn a_player_who_knows_everything_is_sent_on() {
        let attempts = vec![attempt("a", 0.0); 5];
        assert!(advice(&attempts, &Calendar::default()).contains("Try the levels"));
    }
}
