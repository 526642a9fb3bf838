//! The topics of the quiz that are due for review.

use super::{Attempt, Calendar, LESSON, Review, reviews};
use crate::quiz::{Course, CourseKind, Topic};

/// The topics of the quiz that are due for review, and the topic that is due next. Chapters are not
/// included, because each chapter shows which of its questions should be repeated.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Due {
    /// The topics that are due, with those that have been due longest first.
    pub now: Vec<Topic>,
    /// The topic that is due next, and when it is due: "in 2 days".
    pub next: Option<(Topic, String)>,
}

impl Due {
    /// The topics due today, calculated from the answers; there are none if the current time is
    /// unknown.
    pub fn of(attempts: &[Attempt], calendar: &Calendar) -> Self {
        let Some(today) = calendar.today() else {
            return Self::default();
        };
        let mut due = Self::default();
        let reviews = reviews(attempts, calendar).into_iter();
        for review in reviews.filter(is_of_quiz) {
            if review.is_due(today) {
                due.now.push(Topic::with_id(review.topic));
            } else if due.next.is_none() {
                let when = review.when(today);
                due.next = Some((Topic::with_id(review.topic), when));
            }
        }
        due
    }

    /// The topics for the next review.
    pub fn first(&self) -> &[Topic] {
        &self.now[..self.now.len().min(Course::REVIEWED)]
    }

    /// The course of a review; `None` if nothing is due.
    pub fn course(&self) -> Option<CourseKind> {
        (!self.now.is_empty()).then(|| CourseKind::Review(self.now.clone()))
    }
}

/// Whether the quiz has questions about the topic: a teacher's own questions may have other topics.
fn is_of_quiz(review: &Review) -> bool {
    review.family != LESSON && !Topic::with_id(review.topic.clone()).families().is_empty()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quiz::{Answer, Code, Confidence, Family, Round};

    const NOW_S: i64 = 1_800_000_000;

    /// A right or wrong answer to the first question of a round, given `days_ago` days ago.
    fn attempt(code: &str, right: bool, days_ago: i64) -> Attempt {
        let round = Round::of(Code::parse(code).unwrap());
        let question = &round.questions()[0];
        let answer = Answer::new(question.form.truth(), Confidence::Sure);
        Attempt {
            time_s: Some(NOW_S - days_ago * 86_400),
            right,
            ..Attempt::of_quiz("Ada", round.code(), 1, question, &answer)
        }
    }

    fn due(attempts: &[Attempt]) -> Due {
        Due::of(attempts, &Calendar::utc(Some(NOW_S)))
    }

    #[test]
    fn topics_are_due_after_a_wrong_answer_or_when_their_interval_is_over() {
        let known = attempt("rutherford-1", true, 0);
        let missed = attempt("from-angle-1", false, 0);
        let rested = attempt("from-offset-1", true, 2);
        let found = due(&[known.clone(), missed, rested]);
        let topics = ["equal-masses-by-offset", "equal-masses"].map(Topic::with_id);
        assert_eq!(found.now, topics);
        let next = ("counts-at-two-angles".into(), "in 1 day".into());
        assert_eq!(found.next, Some(next));
        assert_eq!(found.course(), Some(CourseKind::Review(topics.to_vec())));
        let none = due(&[known]);
        assert!(none.course().is_none() && none.next.is_some());
    }

    #[test]
    fn a_review_has_a_limit_and_starts_with_the_longest_due() {
        let attempts: Vec<_> = CourseKind::topics()
            .filter(|family| ![Family::Concept, Family::Ideas].contains(family))
            .zip(1..)
            .map(|(family, days)| attempt(&format!("{}-1", family.id()), false, days))
            .collect();
        let found = due(&attempts);
        assert!(found.now.len() > Course::REVIEWED);
        assert_eq!(found.first().len(), Course::REVIEWED);
        let course = Course::new(found.course().unwrap());
        assert_eq!(course.count, Course::REVIEWED);
        assert_eq!(
            Round::of(Code { course, seed: 7 }).questions().len(),
            Course::REVIEWED
        );
        assert_eq!(found.now[0].id(), attempts.last().unwrap().topic);
    }

    #[test]
    fn without_the_time_and_without_answers_nothing_is_due() {
        assert_eq!(due(&[]), Due::default());
        let missed = attempt("from-angle-1", false, 0);
        let timeless = Due::of(std::slice::from_ref(&missed), &Calendar::default());
        assert_eq!(timeless, Due::default());
        let lesson = Attempt {
            family: LESSON.into(),
            ..missed.clone()
        };
        assert_eq!(due(&[lesson]), Due::default());
        let forgotten = Attempt {
            topic: "a topic of an older version of carrom".into(),
            ..missed
        };
        assert_eq!(due(&[forgotten]), Due::default());
    }
}
