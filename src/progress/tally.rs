//! Counts attempts.

use super::Attempt;
use crate::numbers::correlation;
use crate::physics::units::deg_from_rad;
use crate::quiz::Grade;

/// The minimum number of angles for which a mean error is given.
pub(crate) const ENOUGH_ANGLES: usize = 3;

/// The counts for a set of answers: one player's answers, a class's answers to one question, or the
/// answers in one round.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Tally {
    /// The number of answers.
    pub attempts: usize,
    /// The number of right answers.
    pub right: usize,
    credit: f64,
    /// The number of angles, the sum of their errors in degrees, and the sum of the squared errors.
    errors: (usize, [f64; 2]),
}

impl Tally {
    /// Counts these answers.
    pub fn of<'a>(attempts: impl IntoIterator<Item = &'a Attempt>) -> Self {
        let mut tally = Self::default();
        attempts.into_iter().for_each(|it| tally.add(it));
        tally
    }

    /// Counts answers for which only the grade is known, such as the votes of a class.
    pub(crate) fn of_grades(grades: impl IntoIterator<Item = Grade>) -> Self {
        let mut tally = Self::default();
        for grade in grades {
            let error_deg = grade.angle_error.map(deg_from_rad);
            tally.count(grade.right, grade.credit, error_deg);
        }
        tally
    }

    /// Counts one more answer.
    pub fn add(&mut self, attempt: &Attempt) {
        self.count(attempt.right, attempt.credit, attempt.error_deg);
    }

    fn count(&mut self, right: bool, credit: f64, error_deg: Option<f64>) {
        self.attempts += 1;
        self.right += usize::from(right);
        self.credit += credit;
        if let Some(error) = error_deg {
            let (count, [sum, squares]) = self.errors;
            self.errors = (count + 1, [sum + error, squares + error * error]);
        }
    }

    fn share(&self, of: f64) -> Option<f64> {
        (self.attempts > 0).then(|| of / self.attempts as f64)
    }

    /// The fraction of right answers, from 0 to 1; `None` if there are no answers.
    pub fn share_right(&self) -> Option<f64> {
        self.share(self.right as f64)
    }

    /// The sum of the points for accuracy, from 0 to [`Grade::MOST`] for each answer.
    pub fn points(&self) -> f64 {
        Grade::MOST * self.credit
    }

    /// The mean number of points; `None` if there are no answers.
    pub(crate) fn mean_points(&self) -> Option<f64> {
        self.share(self.points())
    }

    /// The number of angles.
    pub fn angles(&self) -> usize {
        self.errors.0
    }

    /// The mean angle error in degrees; `None` if there are fewer than [`ENOUGH_ANGLES`] angles.
    pub(crate) fn mean_error_deg(&self) -> Option<f64> {
        let [mean, _] = self.spread_deg()?;
        (self.angles() >= ENOUGH_ANGLES).then_some(mean)
    }

    /// The mean angle error in degrees, even if there are few angles, and the standard deviation of
    /// the errors. Both describe these answers only; they are not estimates for other answers.
    pub(crate) fn spread_deg(&self) -> Option<[f64; 2]> {
        let (count, sums) = self.errors;
        let [mean, square] = sums.map(|sum| sum / count as f64);
        let deviation = (square - mean * mean).max(0.0).sqrt();
        (count > 0).then_some([mean, deviation])
    }
}

/// The minimum number of answers for which the discrimination of a question is given.
const ENOUGH_TO_TELL_APART: usize = 10;

/// The discrimination of a question, which is the correlation between the points for the question
/// and the points for all other questions, from −1 to 1; `None` if there are fewer than ten
/// answers, or if the points for the question, or those for all other questions, are all equal.
pub(crate) fn discrimination(own_and_rest: impl IntoIterator<Item = (f64, f64)>) -> Option<f64> {
    let (own, rest): (Vec<f64>, Vec<f64>) = own_and_rest.into_iter().unzip();
    correlation(&own, &rest).filter(|_| own.len() >= ENOUGH_TO_TELL_APART)
}

/// For every attempt with an angle error: the number of the attempt, counted from 1, the error in
/// degrees, and the mean of this error and up to `reach` − 1 errors before it.
pub(crate) fn smoothed_errors_deg(attempts: &[Attempt], reach: usize) -> Vec<(usize, f64, f64)> {
    let with_error = |(i, attempt): (usize, &Attempt)| Some((i + 1, attempt.error_deg?));
    let errors: Vec<_> = attempts.iter().enumerate().filter_map(with_error).collect();
    let smoothed = |i: usize| {
        let window = &errors[(i + 1).saturating_sub(reach.max(1))..=i];
        let (number, error) = errors[i];
        let sum: f64 = window.iter().map(|(_, error)| error).sum();
        (number, error, sum / window.len() as f64)
    };
    (0..errors.len()).map(smoothed).collect()
}

/// The number of angles in each of the two groups that [`ends_deg`] compares.
const ENDS: usize = 10;

/// The mean error, in degrees, of the first ten angles and that of the last ten; `None` if the two
/// groups overlap.
pub(crate) fn ends_deg(attempts: &[Attempt]) -> Option<(f64, f64)> {
    let errors: Vec<f64> = attempts.iter().filter_map(|it| it.error_deg).collect();
    let mean = |errors: &[f64]| errors.iter().sum::<f64>() / ENDS as f64;
    let (first, rest) = errors.split_first_chunk::<ENDS>()?;
    let (_, last) = rest.split_last_chunk::<ENDS>()?;
    Some((mean(first), mean(last)))
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::quiz::Confidence;
    use crate::quiz::Figures;

    /// An attempt by "Ada" at this topic, which is right if its error is at most 4°.
    pub(crate) fn attempt(topic: &str, error_deg: f64) -> Attempt {
        Attempt {
            time_s: None,
            player: "Ada".into(),
            family: "where-to".into(),
            topic: topic.into(),
            seed: 7,
            number: 1,
            question: Figures::new(),
            answer: Figures::new(),
            truth: Figures::new(),
            error_deg: Some(error_deg),
            credit: 0.5,
            right: error_deg <= 4.0,
            confidence: Some(Confidence::ThinkSo),
            misconception: None,
        }
    }

    #[test]
    fn shares_and_means_follow_from_the_counts() {
        let all = [attempt("a", 2.0), attempt("a", 10.0), attempt("a", 0.0)];
        let tally = Tally::of(&all);
        assert_eq!((tally.attempts, tally.right), (3, 2));
        assert!((tally.share_right().unwrap() - 2.0 / 3.0).abs() < 1e-12);
        assert!((tally.mean_error_deg().unwrap() - 4.0).abs() < 1e-12);
        let [mean, deviation] = Tally::of(&all[..2]).spread_deg().unwrap();
        assert!((mean - 6.0).abs() < 1e-12 && (deviation - 4.0).abs() < 1e-12);
        assert_eq!(Tally::default().spread_deg(), None);
        assert_eq!(Tally::default().share_right(), None);
        assert_eq!(Tally::default().mean_error_deg(), None);
    }

    #[test]
    fn answers_without_an_error_are_left_out_of_the_mean_only() {
        let mut still = attempt("a", 0.0);
        still.error_deg = None;
        let all = [attempt("a", 6.0), still, attempt("a", 8.0)];
        let tally = Tally::of(&all);
        assert_eq!((tally.attempts, tally.angles()), (3, 2));
        assert_eq!(tally.mean_error_deg(), None, "two angles are too few");
        let more = Tally::of(all.iter().chain([&attempt("a", 10.0)]));
        assert!((more.mean_error_deg().unwrap() - 8.0).abs() < 1e-12);
        let smoothed = smoothed_errors_deg(&all, 5);
        assert_eq!(smoothed, [(1, 6.0, 6.0), (3, 8.0, 7.0)]);
        assert_eq!(smoothed_errors_deg(&all, 0)[1], (3, 8.0, 8.0));
    }

    #[test]
    fn the_first_and_last_errors_are_those_of_angles() {
        let mut all: Vec<_> = (0..10).map(|_| attempt("a", 20.0)).collect();
        // The answers in between have no angle, so they are not counted.
        all.extend((0..30).map(|_| Attempt {
            error_deg: None,
            ..attempt("a", 0.0)
        }));
        all.extend((0..9).map(|_| attempt("a", 10.0)));
        assert_eq!(ends_deg(&all), None);
        all.push(attempt("a", 0.0));
        assert_eq!(ends_deg(&all), Some((20.0, 9.0)));
    }
}
