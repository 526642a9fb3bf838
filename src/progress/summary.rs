//! The summary of a round.

use super::{Attempt, ENOUGH_ANGLES, calibration, page_about};
use crate::numbers;
use crate::physics::units::rad_from_deg;
use crate::quiz::{
    ChaptersRead, Clue, Evidence, Grade, Misconception, Origin, Passage, Rays, RaysGrade, Topic,
    evidence, named,
};

/// The minimum number of answers for the comment "You judge your knowledge well."
const ENOUGH_ANSWERS: usize = 5;

/// The part of a round that has been answered.
#[derive(Debug, Clone)]
pub struct Summary<'a> {
    /// The answers, in the order of the questions.
    pub attempts: &'a [Attempt],
}

impl<'a> Summary<'a> {
    /// Summarizes these answers.
    pub fn new(attempts: &'a [Attempt]) -> Self {
        Self { attempts }
    }

    /// The points of the round: the sum of the points of its questions, each rounded to a tenth, as
    /// shown. The sum may be negative: otherwise a wrong "sure" would cost nothing once the sum is
    /// 0, and honest answers would not pay off.
    pub fn points(&self) -> f64 {
        // Adding 0 turns −0, the sum of an empty list, into 0.
        let tenths = |it: &Attempt| (10.0 * it.earned()).round();
        let sum: f64 = self.attempts.iter().map(tenths).sum();
        sum / 10.0 + 0.0
    }

    /// The maximum number of points for these answers.
    pub fn most(&self) -> f64 {
        Grade::MOST * self.attempts.len() as f64
    }

    /// The number of right answers.
    pub fn right(&self) -> usize {
        self.attempts.iter().filter(|it| it.right).count()
    }

    /// The number of right answers as text: "7 of 10 right".
    pub fn score(&self) -> String {
        format!("{} of {} right", self.right(), self.attempts.len())
    }

    /// The points as text, with their meaning: "61.5 of 100 points: …".
    pub(crate) fn points_words(&self) -> String {
        let (points, most) = (numbers::points(self.points()), self.most());
        let meaning = match self.points() < 0.0 {
            true => {
                "a wrong \"sure\" loses points, so answers that you are not sure of cost less \
                     as guesses"
            }
            false => "they count how close each answer was, and whether you knew how sure to be",
        };
        format!("{points} of {most:.0} points: {meaning}.")
    }

    /// The errors of all angles in radians; two rays count as two angles.
    fn errors(&self) -> impl Iterator<Item = f64> {
        let of_rays = |it: &Attempt| {
            let [said, truth] = [&it.answer, &it.truth].map(Rays::of_figures);
            let grade = RaysGrade::new(&said?, &truth?);
            Some([grade.striker.error, grade.target.error])
        };
        let of_attempt = move |it| of_rays(it).unwrap_or([it.error_deg.map(rad_from_deg), None]);
        self.attempts.iter().flat_map(of_attempt).flatten()
    }

    /// The number of angles.
    pub fn angles(&self) -> usize {
        self.errors().count()
    }

    /// The mean error of all angles in radians; `None` for fewer than `ENOUGH_ANGLES` angles.
    pub fn mean_error(&self) -> Option<f64> {
        let count = self.angles();
        (count >= ENOUGH_ANGLES).then(|| self.errors().sum::<f64>() / count as f64)
    }

    /// A comment on how well the confidence matched the answers; empty if there are no answers.
    pub fn calibration_words(&self) -> String {
        let [guess, think_so, sure] = calibration(self.attempts).map(|it| it.tally);
        let counted = match (sure.attempts, sure.right) {
            _ if self.attempts.is_empty() => return String::new(),
            (0, _) => "You were never sure.".into(),
            (1, 1) => "Sure once, and right.".into(),
            (1, _) => "Sure once, and wrong.".into(),
            (times, right) => format!("Sure {times} times: {right} right."),
        };
        // "Sure" earns the most points if at least four in five answers are right, and "guess" if
        // at most one in two is right. A single wrong "think so" is not enough for a comment.
        let verdict = if 5 * sure.right < 4 * sure.attempts {
            "Review the answers that were sure but wrong: they teach you most."
        } else if 2 * guess.right > guess.attempts
            || sure.attempts == 0 && 5 * self.right() >= 4 * self.attempts.len()
        {
            "You know more than you think."
        } else if think_so.attempts > 1 && 2 * think_so.right < think_so.attempts {
            "\"Think so\" was right less than half the time: a guess would have cost nothing."
        } else if self.attempts.len() < ENOUGH_ANSWERS || self.right() == 0 {
            // There are too few answers, or all are wrong, so they show nothing about calibration.
            ""
        } else {
            "You judge your knowledge well."
        };
        format!("{counted} {verdict}").trim_end().to_owned()
    }

    /// The misconceptions that the answers show, strongest evidence first.
    pub fn named(&self) -> Vec<Evidence> {
        let clues: Vec<Clue> = self.attempts.iter().map(Attempt::clue).collect();
        named(&clues)
    }

    /// The misconception with the strongest evidence.
    pub fn most_held(&self) -> Option<Misconception> {
        self.named().first().map(|it| it.misconception)
    }

    /// A sentence about the misconception with the strongest evidence.
    pub(crate) fn held_words(&self) -> Option<String> {
        let first = *self.named().first()?;
        let name = first.misconception.name();
        Some(format!(
            "It showed in {first} answers that could show it: {name}."
        ))
    }

    /// The findings on misconceptions, one paragraph each. The first paragraph names the
    /// misconception, or says that none stands out or that there are no answers yet.
    pub fn finding(&self) -> Vec<String> {
        let Some(first) = self.named().first().copied() else {
            return self.nothing_found();
        };
        let misconception = first.misconception;
        let shows = |(_, it): &(usize, &Attempt)| it.shows() == Some(misconception);
        let numbers = (1..).zip(self.attempts).filter(shows);
        let numbers: Vec<String> = numbers.map(|(number, _)| number.to_string()).collect();
        let (last, others) = numbers.split_last().map_or(("", &[][..]), |(a, b)| (a, b));
        let (found, somebody) = match misconception.origin() {
            Origin::Slip => ("It seems that you often make this slip", "makes it"),
            _ => ("It seems that you believe this", "believes it"),
        };
        vec![
            format!("{found}: {}.", misconception.name()),
            format!(
                "Your answers to questions {} and {last} show it, out of {} that could have. Such \
                 answers are {} as likely from somebody who {somebody} as from somebody who \
                 guesses.",
                others.join(", "),
                first.asked,
                times_as(first.weight),
            ),
            misconception.advice().into(),
        ]
    }

    fn nothing_found(&self) -> Vec<String> {
        let (right, asked) = (self.right(), self.attempts.len());
        if asked == 0 {
            return vec!["There are no answers yet, so there is nothing to report.".into()];
        }
        let suspected = self.suspected();
        let why = if 5 * right >= 4 * asked {
            "No misconception stands in your way. Try a mixed round, or a level that needs an \
             exact cut."
                .into()
        } else if suspected.is_empty() {
            "Your wrong answers have no pattern: no known misconception explains them. Go through \
             them once more, with the explanations."
                .into()
        } else {
            format!(
                "Some answers fit a known misconception: {}. But they are too few to conclude that \
                 you believe it. Read their explanations, then answer more questions.",
                suspected.join(", ")
            )
        };
        vec![
            "No misconception stands out.".into(),
            format!("{right} of {asked} answers were right. {why}"),
        ]
    }

    /// The names of the misconceptions that at least one answer fits, with the strongest evidence
    /// first.
    fn suspected(&self) -> Vec<&'static str> {
        let clues: Vec<Clue> = self.attempts.iter().map(Attempt::clue).collect();
        let shown = evidence(&clues).into_iter().filter(|it| it.times > 0);
        shown.map(|it| it.misconception.name()).collect()
    }

    /// A comment on whether the answers still show the misconception that the round checks for.
    pub fn checked(&self, misconception: Misconception) -> String {
        let name = misconception.name();
        // If a misconception was split later, the code for it still tests for all the resulting
        // misconceptions.
        let is_shown = |it: Misconception| it.is_part_of(misconception);
        let shown = |it: &&Attempt| it.shows().is_some_and(is_shown);
        match self.attempts.iter().filter(shown).count() {
            0 if self.right() == self.attempts.len() => {
                format!("Settled, as far as a check can tell: {name}. It no longer shows.")
            }
            0 => format!("It no longer shows: {name}. But not all answers were right."),
            _ => format!("It still shows: {name}. Read the page again, and take your time."),
        }
    }

    /// The page to read next: the page that explains the misconception with the strongest evidence,
    /// in the simplest case in which it showed. If there is no misconception, it is the first page,
    /// in the order of the chapters, that teaches a missed topic; topics missed with "sure" come
    /// first. `None` if nothing was missed.
    pub(crate) fn passage(&self) -> Option<Passage> {
        if let Some(misconception) = self.most_held() {
            let shows = |it: &&Attempt| it.shows() == Some(misconception);
            let shown = self.attempts.iter().filter(shows);
            return page_about(misconception, shown);
        }
        let missed = self.attempts.iter().filter(|it| !it.right);
        let teaching = missed.filter_map(|it| {
            let topic = Topic::with_id(it.topic.clone());
            Some((it, topic.taught_for(&it.question)?))
        });
        let first = teaching
            .min_by_key(|(it, page)| (!it.is_surely_wrong(), ChaptersRead::order_of(page.chapter)));
        first.map(|(_, page)| page)
    }
}

/// Formats a log-likelihood ratio as "about 600 times", rounded to one digit. The ratio must reach
/// the threshold for naming a misconception.
fn times_as(weight: f64) -> String {
    let odds = weight.exp();
    if odds >= 1e6 {
        return "more than a million times".into();
    }
    let digit = 10_f64.powf(odds.log10().floor());
    match (odds / digit).round() * digit {
        odds if odds >= 1e6 => "about a million times".into(),
        odds if odds >= 1e3 => format!("about {:.0},000 times", odds / 1e3),
        odds => format!("about {odds:.0} times"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::ImpactPoint;
    use crate::quiz::{Answer, Code, Confidence, Hit, Pieces, Question, Response};

    const HIT: Hit = Hit {
        pieces: Pieces::Equal,
        given: ImpactPoint::Angle { alpha_deg: 30.0 },
        restitution: 1.0,
        speed: 4.0,
        direction_deg: 0.0,
    };

    /// A summary of answers, given the confidence of each and whether it is right.
    fn summary(answers: &[(Confidence, bool)]) -> Summary<'static> {
        let (code, question) = (Code::hits(7), Question::from(&HIT));
        let attempt = |(number, (confidence, right)): (u32, &(Confidence, bool))| {
            let rays = if *right {
                HIT.truth()
            } else {
                Rays::new(-3.0, 3.0)
            };
            let answer = Answer::new(Response::Rays(rays), *confidence);
            Attempt::of_quiz("Ada", &code, number, &question, &answer)
        };
        Summary::new(Vec::leak((1..).zip(answers).map(attempt).collect()))
    }

    #[test]
    fn the_comment_on_calibration_depends_on_the_answers() {
        use Confidence::{Guess, Sure, ThinkSo};
        for (answers, words) in [
            (vec![(Sure, true)], "Sure once, and right."),
            (
                vec![(Sure, true), (Sure, false), (Guess, false)],
                "Sure 2 times: 1 right. Review the answers that were sure but wrong: \
                 they teach you most.",
            ),
            (
                vec![(ThinkSo, true), (Guess, true)],
                "You were never sure. You know more than you think.",
            ),
            (
                vec![(ThinkSo, false), (Guess, false)],
                "You were never sure.",
            ),
            (vec![(Guess, false); 10], "You were never sure."),
            (
                vec![
                    (Sure, true),
                    (Sure, true),
                    (ThinkSo, true),
                    (Guess, false),
                    (Guess, false),
                ],
                "Sure 2 times: 2 right. You judge your knowledge well.",
            ),
            (
                vec![(ThinkSo, false), (ThinkSo, false), (ThinkSo, true)],
                "You were never sure. \"Think so\" was right less than half the time: a guess \
                 would have cost nothing.",
            ),
        ] {
            assert_eq!(summary(&answers).calibration_words(), words);
        }
    }

    /// The table of the round names a misconception even if only one answer fits it, so the finding
    /// must name it, too.
    #[test]
    fn one_answer_that_fits_a_misconception_is_not_called_a_wrong_answer_without_a_pattern() {
        let question = Question::from(&HIT);
        let of = |theta1: f64, theta2: f64| {
            let said = Response::Rays(Rays::new(theta1.to_radians(), theta2.to_radians()));
            let answer = Answer::new(said, Confidence::Sure);
            let attempt = Attempt::of_quiz("Ada", &Code::hits(7), 1, &question, &answer);
            Summary::new(Vec::leak(vec![attempt])).finding().join(" ")
        };
        let half = of(45.0, 45.0);
        let name = Misconception::HalfAndHalf.name();
        assert!(half.contains(name) && half.contains("too few"), "{half}");
        assert!(!half.contains("no known"), "{half}");
        let nonsense = of(-120.0, 120.0);
        assert!(nonsense.contains("no known misconception"), "{nonsense}");
    }

    #[test]
    fn odds_are_rounded_to_one_digit() {
        let said = [4.4e2, 4.4e3, 9.4e5, 9.6e5].map(|odds: f64| times_as(odds.ln()));
        assert_eq!(
            said,
            [
                "about 400 times",
                "about 4,000 times",
                "about 900,000 times",
                "about a million times"
            ]
        );
        assert_eq!(times_as(20.0), "more than a million times");
    }

    #[test]
    fn the_points_are_the_sum_even_below_zero() {
        let missed = summary(&[(Confidence::Sure, false); 3]);
        // The headline is never negative; the line below it explains the points.
        assert_eq!(missed.score(), "0 of 3 right");
        assert!(
            missed
                .points_words()
                .contains("a wrong \"sure\" loses points")
        );
        assert!((missed.points() + 18.0).abs() < 1e-12);
        assert!((missed.most() - 30.0).abs() < 1e-12);
        assert_eq!(missed.right(), 0);
        let caught_up = summary(&[(Confidence::ThinkSo, false), (Confidence::Sure, true)]);
        assert!((caught_up.points() - 8.0).abs() < 1e-12);
        // The sum of an empty list has no minus sign.
        assert!(summary(&[]).points().is_sign_positive());
    }

    #[test]
    fn a_mean_error_needs_some_angles() {
        let one = summary(&[(Confidence::Sure, true)]);
        assert_eq!((one.angles(), one.mean_error()), (2, None));
        let two = summary(&[(Confidence::Sure, true); 2]);
        assert_eq!(two.angles(), 4);
        assert!(two.mean_error().is_some_and(|error| error < 1e-12));
    }
}
