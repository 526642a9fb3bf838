//! What is due of the quiz.

use crate::messages::History;
use crate::progress::{Review, reviews};
use crate::quiz::{CourseKind, Family};

/// What is due of the quiz, and what comes next.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Due {
    /// The families that are due, with how many of their topics; the longest due first.
    pub(super) now: Vec<(Family, usize)>,
    /// The family that is due next, and when.
    pub(super) next: Option<(Family, String)>,
}

impl Due {
    /// What is due of what was answered in the quiz; nothing where nobody knows the
    /// time.
    pub(super) fn of(history: &History) -> Self {
        let Some(now_s) = history.now_s else {
            return Self::default();
        };
        let reviews = reviews(&history.attempts);
        let of_quiz = |review: &Review| Some((Family::with_id(&review.family)?, review.clone()));
        let mut due = Self::default();
        for (family, review) in reviews.iter().filter_map(of_quiz) {
            if !review.is_due(now_s) {
                due.next.get_or_insert((family, review.when(now_s)));
            } else if let Some(at) = due.now.iter().position(|(it, _)| *it == family) {
                due.now[at].1 += 1;
            } else {
                due.now.push((family, 1));
            }
        }
        due
    }

    /// A review of it, if anything is due. What is due alone is mixed with what comes
    /// next.
    pub(super) fn course(&self) -> Option<CourseKind> {
        let mut families: Vec<_> = self.now.iter().map(|(family, _)| *family).collect();
        let next = self.next.iter().map(|(family, _)| *family);
        if families.len() == 1 {
            families.extend(next.filter(|family| *family != self.now[0].0));
        }
        (!families.is_empty()).then_some(CourseKind::Review(families))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::{Attempt, DAY_S};
    use crate::quiz::{Answer, Code, Confidence, Round};

    const NOW_S: i64 = 1_800_000_000;

    /// A right or wrong answer to the first question of a round, so many days ago.
    fn attempt(code: &str, right: bool, days_ago: i64) -> Attempt {
        let round = Round::of(Code::parse(code).unwrap());
        let question = &round.questions()[0];
        let answer = Answer::new(question.form.truth(), Confidence::Sure);
        Attempt {
            time_s: Some(NOW_S - days_ago * DAY_S),
            right,
            ..Attempt::of_quiz("Ada", round.code(), 1, question, &answer)
        }
    }

    fn due(attempts: Vec<Attempt>, now_s: Option<i64>) -> Due {
        Due::of(&History { attempts, now_s })
    }

    #[test]
    fn what_was_missed_or_has_rested_is_due() {
        let known = attempt("speeds-1", true, 0);
        let missed = attempt("from-angle-1", false, 0);
        let rested = attempt("from-offset-1", true, 2);
        let found = due(vec![known.clone(), missed.clone(), rested], Some(NOW_S));
        let families = [(Family::FromOffset, 1), (Family::FromAngle, 1)];
        assert_eq!(found.now, families);
        assert_eq!(found.next, Some((Family::Speeds, "in 1 day".into())));
        let both = vec![Family::FromOffset, Family::FromAngle];
        assert_eq!(found.course(), Some(CourseKind::Review(both)));
        // One alone would come again and again: it is mixed with what comes next.
        let one = due(vec![known.clone(), missed], Some(NOW_S));
        let mixed = vec![Family::FromAngle, Family::Speeds];
        assert_eq!(one.course(), Some(CourseKind::Review(mixed)));
        let none = due(vec![known], Some(NOW_S));
        assert!(none.course().is_none() && none.next.is_some());
    }

    #[test]
    fn without_the_time_and_without_answers_nothing_is_due() {
        assert_eq!(due(vec![], Some(NOW_S)), Due::default());
        let missed = attempt("from-angle-1", false, 0);
        assert_eq!(due(vec![missed.clone()], None), Due::default());
        let lesson = Attempt {
            family: crate::progress::LESSON.into(),
            ..missed
        };
        assert_eq!(due(vec![lesson], Some(NOW_S)), Due::default());
    }
}
