//! Advice on what to do next.

use super::{Attempt, Calendar, LESSON, Mastery, Trend, beliefs, reviews, topics};

/// How many of the last attempts count as recent.
const LATELY: usize = 10;

/// Advice on what to do next, in one or two sentences. The most useful comes first: a misconception
/// that is still held, then a topic that is due today, then an answer that was sure but wrong, then
/// the topic with the worst recent results.
pub fn advice(attempts: &[Attempt], calendar: &Calendar) -> String {
    if attempts.is_empty() {
        return "Play a round of the quiz: ten hits, and you learn from every answer.".into();
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
            LESSON => ended(format!(
                "Due for review, in the chapters: {}",
                review.topic_name()
            )),
            _ => format!(
                "Due for review: {}. Play a round of the quiz to practise it.",
                review.topic_name()
            ),
        };
    }
    let lately = &attempts[attempts.len().saturating_sub(LATELY)..];
    if let Some(missed) = lately.iter().rev().find(|it| it.is_surely_wrong()) {
        let topic = format!(
            "You were sure, but wrong, on this topic: {}",
            missed.topic_name()
        );
        return ended(topic) + " Try a similar question again, and read the explanation slowly.";
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
        Some(topic) => ended(format!(
            "You can learn most from this topic now: {}",
            topic.name
        )),
        None => "All your topics so far are solid. Try the levels, or a game at the table.".into(),
    }
}

/// A sentence with its full stop, unless it ends with the title of a page that is a question.
fn ended(sentence: String) -> String {
    match sentence.ends_with(['?', '!', '.']) {
        true => sentence,
        false => sentence + ".",
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
        assert!(says(Some(attempt("a", 9.0)), None).contains("from this topic now: a"));
        let sure = Attempt {
            confidence: Some(Confidence::Sure),
            time_s: Some(1000),
            ..attempt("equal-masses", 9.0)
        };
        assert!(says(Some(sure), None).contains("on this topic: equal masses"));
        assert!(says(None, Some(1000)).contains("Due for review: equal masses"));
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
    fn a_topic_that_is_a_question_needs_no_full_stop() {
        assert_eq!(ended("Due: Which way?".into()), "Due: Which way?");
        assert_eq!(ended("Due: equal masses".into()), "Due: equal masses.");
    }

    #[test]
    fn a_player_who_knows_all_topics_gets_further_advice() {
        let attempts = vec![attempt("a", 0.0); 5];
        assert!(advice(&attempts, &Calendar::default()).contains("Try the levels"));
    }
}
