//! How well a player's confidence matches the answers.

use super::{Attempt, Tally};
use crate::quiz::Confidence;

/// The minimum number of answers with the same confidence level before carrom comments on that
/// level.
const ENOUGH: usize = 3;

/// The results of all answers with one confidence level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Calibrated {
    /// The confidence level.
    pub confidence: Confidence,
    /// The counts of these answers.
    pub tally: Tally,
}

impl Calibrated {
    /// The range in which the fraction of right answers must lie for this confidence level to earn
    /// the most points; see [`Confidence::points`].
    pub(crate) const fn honest(confidence: Confidence) -> (f64, f64) {
        match confidence {
            Confidence::Guess => (0.0, 0.5),
            Confidence::ThinkSo => (0.5, 0.8),
            Confidence::Sure => (0.8, 1.0),
        }
    }

    /// How far the fraction of right answers is outside the range of this confidence level: above 0
    /// if the fraction is too high, below 0 if it is too low, 0 if it is in the range or if there
    /// are too few answers.
    pub(crate) fn beyond(&self) -> f64 {
        let (from, to) = Self::honest(self.confidence);
        match self.tally.share_right() {
            Some(share) if self.tally.attempts >= ENOUGH => {
                (share - to).max(0.0) - (from - share).max(0.0)
            }
            _ => 0.0,
        }
    }
}

/// The results for each confidence level, the lowest first.
pub fn calibration(attempts: &[Attempt]) -> [Calibrated; 3] {
    Confidence::ALL.map(|confidence| {
        let is_so_sure = |it: &&Attempt| it.confidence == Some(confidence);
        let tally = Tally::of(attempts.iter().filter(is_so_sure));
        Calibrated { confidence, tally }
    })
}

/// The fraction of right answers over time, for each confidence level, the lowest first.
/// Each point has the number of an answer with that level (counted from 1 among all attempts), and
/// the fraction of right answers among the last `reach` answers with that level. The first point is
/// at answer number [`ENOUGH`] with that level.
pub(crate) fn calibration_over_time(attempts: &[Attempt], reach: usize) -> [Vec<(usize, f64)>; 3] {
    let reach = reach.max(ENOUGH);
    Confidence::ALL.map(|confidence| {
        let is_so_sure = |(_, it): &(usize, &Attempt)| it.confidence == Some(confidence);
        let of_it: Vec<_> = (1..).zip(attempts).filter(is_so_sure).collect();
        let point = |end: usize| {
            let window = &of_it[end.saturating_sub(reach)..end];
            let right = window.iter().filter(|(_, attempt)| attempt.right).count();
            let (number, _) = window.last()?;
            Some((*number, right as f64 / window.len() as f64))
        };
        (ENOUGH..=of_it.len()).filter_map(point).collect()
    })
}

/// A comment of one or two sentences on the confidence level whose fraction of right answers is
/// farthest outside its range; in a tie, on the higher level.
pub fn calibration_words(calibration: &[Calibrated; 3]) -> &'static str {
    let [.., last] = calibration;
    let gap = |it: &Calibrated| it.beyond().abs();
    let widest = calibration.iter().max_by(|a, b| gap(a).total_cmp(&gap(b)));
    let widest = widest.unwrap_or(last);
    match (widest.confidence, widest.beyond()) {
        (Confidence::Sure, beyond) if beyond < 0.0 => {
            "You are sure too often. Before you say \"sure\", ask what would have to be true \
             for you to be wrong."
        }
        (_, beyond) if beyond < 0.0 => {
            "\"Think so\" is right less than half the time. Calling it a guess costs nothing, \
             and that is where learning starts."
        }
        (_, beyond) if beyond > 0.0 => {
            "You know more than you think: you are right more often than you \
             expect."
        }
        _ if calibration.iter().any(|it| it.tally.attempts >= ENOUGH) => {
            "You judge your knowledge well. That is a skill in itself."
        }
        _ => "After a few more answers, you will see how well you judge your knowledge.",
    }
}

#[cfg(test)]
mod tests {
    use super::super::tally::tests::attempt;
    use super::*;

    fn calibrated(confidence: Confidence, right: usize, wrong: usize) -> [Calibrated; 3] {
        let errors = std::iter::repeat_n(0.0, right).chain(std::iter::repeat_n(20.0, wrong));
        let attempts: Vec<_> = errors
            .map(|error| Attempt {
                confidence: Some(confidence),
                ..attempt("a", error)
            })
            .collect();
        calibration(&attempts)
    }

    #[test]
    fn the_honest_range_earns_the_most_points() {
        for confidence in Confidence::ALL {
            let (from, to) = Calibrated::honest(confidence);
            for share in [from + 0.01, f64::midpoint(from, to), to - 0.01] {
                for other in Confidence::ALL {
                    assert!(confidence.points(share) >= other.points(share));
                }
            }
        }
    }

    #[test]
    fn shares_over_time_use_the_last_few_answers() {
        let answer = |right: bool, confidence| Attempt {
            confidence,
            ..attempt("a", if right { 0.0 } else { 20.0 })
        };
        let sure = Some(Confidence::Sure);
        let mut all: Vec<_> = [false, false, true, true]
            .map(|right| answer(right, sure))
            .into();
        // An answer without a confidence level only adds to the number of attempts.
        all.insert(2, answer(true, None));
        let [guess, think_so, sure] = calibration_over_time(&all, 3);
        assert!(guess.is_empty() && think_so.is_empty());
        assert_eq!(sure, [(4, 1.0 / 3.0), (5, 2.0 / 3.0)]);
        assert_eq!(calibration_over_time(&all[..3], 3)[2], []);
    }

    #[test]
    fn the_comment_is_about_the_largest_gap() {
        use Confidence::{Guess, Sure, ThinkSo};
        let answers = |counts: [(Confidence, usize, usize); 3]| {
            let [a, b, c] = counts.map(|(sure, right, wrong)| calibrated(sure, right, wrong));
            calibration_words(&[a[0], b[1], c[2]])
        };
        let think_so = answers([(Guess, 0, 2), (ThinkSo, 1, 8), (Sure, 3, 1)]);
        assert!(think_so.contains("less than half"), "{think_so}");
        let sure = answers([(Guess, 0, 2), (ThinkSo, 4, 6), (Sure, 1, 4)]);
        assert!(sure.contains("sure too often"), "{sure}");
        let guess = answers([(Guess, 5, 0), (ThinkSo, 4, 6), (Sure, 4, 1)]);
        assert!(guess.contains("more than you think"), "{guess}");
    }

    #[test]
    fn the_comment_depends_on_the_shares() {
        use Confidence::{Guess, Sure, ThinkSo};
        for (confidence, right, wrong, says) in [
            (Sure, 3, 2, "too often"),
            (Sure, 4, 1, "judge your"),
            (Guess, 4, 1, "more than you think"),
            (Guess, 1, 4, "judge your"),
            (ThinkSo, 1, 4, "less than half"),
            (ThinkSo, 2, 1, "judge your"),
            (ThinkSo, 5, 0, "more than you think"),
            (Sure, 0, 1, "a few more answers"),
        ] {
            let words = calibration_words(&calibrated(confidence, right, wrong));
            assert!(
                words.contains(says),
                "{confidence:?} {right}:{wrong} {words}"
            );
        }
    }
}
