//! How strongly answers indicate a misconception; docs/judging.md derives the formula.
//!
//! For every answer to a question that could show a misconception, the likelihood ratio compares
//! somebody who holds the misconception with somebody who guesses. The logarithms of these ratios
//! add up, whatever the questions were. This sum determines how a misconception is ranked, whether
//! it is reported as fading, and which questions test for it. A misconception is named if the sum
//! is large enough and enough different questions show the misconception.

use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::fmt;

use crate::quiz::question::{Answer, Fit, Misconception, Question, WrongAnswer};

/// The probability that, when a question could show a misconception, the answer of somebody who
/// holds it does not show it: because of a slip, a doubt, or another idea.
pub(crate) const SLIP: f64 = 0.15;

/// A misconception is named once the answers are this many times as likely for somebody who holds
/// it as for somebody who guesses.
pub(crate) const NAMED_ODDS: f64 = 40.0;

/// The minimum number of different questions that must show a misconception before it is named.
pub(crate) const NAMED_QUESTIONS: usize = 2;

/// The evidence that one answer gives for and against misconceptions.
#[derive(Debug, Clone, PartialEq)]
pub struct Clue {
    /// The text that identifies the question.
    pub question: String,
    /// The misconceptions that an answer to the question could have shown.
    pub could_show: Vec<Misconception>,
    /// The misconception that the answer shows, if any.
    pub shows: Option<Misconception>,
    /// The probability, above 0 and below 1, that a guess fits a given one of these misconceptions
    /// as fully as this answer fits one. If the answer fits none, this is the probability that a
    /// guess fits a given one completely.
    pub(crate) by_chance: f64,
}

impl Clue {
    /// The evidence that an answer to a question gives.
    pub fn new(question: &Question, answer: &Answer) -> Self {
        Self::of(question, answer, |belief| Some(belief.misconception))
    }

    /// The evidence when misconceptions are counted as in the codes of rounds: see
    /// [`WrongAnswer::in_codes`].
    pub(in crate::quiz) fn in_codes(question: &Question, answer: &Answer) -> Self {
        Self::of(question, answer, WrongAnswer::in_codes)
    }

    fn of(
        question: &Question,
        answer: &Answer,
        counted: fn(&WrongAnswer) -> Option<Misconception>,
    ) -> Self {
        let found = question.belief_of(answer);
        Self {
            question: question.text.clone(),
            could_show: question.beliefs.iter().filter_map(counted).collect(),
            shows: found.and_then(|(belief, _)| counted(belief)),
            by_chance: question.by_chance(found.map_or(Fit::Whole, |(_, fit)| fit)),
        }
    }

    /// The log-likelihood ratio of this answer for a misconception: ln((1 − s) / g) if the answer
    /// shows the misconception, ln(s / (1 − g)) if it could have shown the misconception but does
    /// not, and 0 if it could not have shown it. Here s is the probability of a slip, and g the
    /// probability that a guess fits.
    pub fn weight(&self, misconception: Misconception) -> f64 {
        if self.shows == Some(misconception) {
            weight_shown(self.by_chance)
        } else if self.could_show.contains(&misconception) {
            weight_not_shown(self.by_chance)
        } else {
            0.0
        }
    }
}

/// The weight of an answer that shows a misconception.
fn weight_shown(by_chance: f64) -> f64 {
    ((1.0 - SLIP) / by_chance).ln()
}

/// The weight of an answer that could have shown a misconception but does not.
fn weight_not_shown(by_chance: f64) -> f64 {
    (SLIP / (1.0 - by_chance)).ln()
}

/// The evidence of several answers for or against one misconception.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Evidence {
    /// The misconception for or against which the answers are evidence.
    pub misconception: Misconception,
    /// The log-likelihood ratio: if it is above 0, the answers are more likely for somebody who
    /// holds the misconception; if it is below 0, they are more likely for somebody who guesses.
    pub weight: f64,
    /// The number of answers that show the misconception.
    pub times: usize,
    /// The number of answers that could have shown the misconception.
    pub asked: usize,
    /// The number of different questions whose answers show the misconception.
    pub questions: usize,
}

impl Evidence {
    /// The evidence of these answers for a misconception.
    pub(crate) fn of<'a>(
        misconception: Misconception,
        clues: impl IntoIterator<Item = &'a Clue>,
    ) -> Self {
        let mut evidence = Self {
            misconception,
            weight: 0.0,
            times: 0,
            asked: 0,
            questions: 0,
        };
        let mut questions = BTreeSet::new();
        for clue in clues {
            let shows = clue.shows == Some(misconception);
            if shows || clue.could_show.contains(&misconception) {
                evidence.weight += clue.weight(misconception);
                evidence.asked += 1;
                evidence.times += usize::from(shows);
            }
            if shows {
                questions.insert(clue.question.as_str());
            }
        }
        evidence.questions = questions.len();
        evidence
    }

    /// Whether the evidence is enough to name the misconception.
    pub(crate) fn names(&self) -> bool {
        self.weight >= NAMED_ODDS.ln() && self.questions >= NAMED_QUESTIONS
    }

    /// Whether the evidence is enough to conclude that the student does not hold the misconception:
    /// it must be as strong as the evidence needed to name a misconception, but against it.
    pub(crate) fn denies(&self) -> bool {
        self.weight <= -NAMED_ODDS.ln()
    }

    /// Compares evidence, stronger evidence first; weights are rounded to a millionth.
    pub(crate) fn stronger_first(&self, other: &Self) -> Ordering {
        let rank = |it: &Self| (1e6 * it.weight).round() as i64;
        rank(other).cmp(&rank(self))
    }
}

/// "2 of 5": the number of answers that show the misconception, and the number that could have
/// shown it; "-" if none could have shown it.
impl fmt::Display for Evidence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self { asked: 0, .. } => f.pad("-"),
            Self { times, asked, .. } => f.pad(&format!("{times} of {asked}")),
        }
    }
}

/// The evidence of these answers for each misconception that they could have shown, with the
/// strongest evidence first; misconceptions with equally strong evidence are in the order of
/// [`Misconception::ALL`].
pub(crate) fn evidence(clues: &[Clue]) -> Vec<Evidence> {
    let each = Misconception::ALL.iter();
    let mut all: Vec<Evidence> = each.map(|it| Evidence::of(*it, clues)).collect();
    all.retain(|it| it.asked > 0);
    all.sort_by(Evidence::stronger_first);
    all
}

/// The misconceptions named by these answers, strongest evidence first.
pub fn named(clues: &[Clue]) -> Vec<Evidence> {
    let mut all = evidence(clues);
    all.retain(Evidence::names);
    all
}

#[cfg(test)]
mod tests {
    use Misconception::{AlwaysSquare, CopiedAngle, Lossless};

    use super::*;

    fn clue(question: u32, shows: Option<Misconception>, by_chance: f64) -> Clue {
        Clue {
            question: question.to_string(),
            could_show: vec![CopiedAngle, AlwaysSquare],
            shows,
            by_chance,
        }
    }

    /// Two matching rays contribute a weight of ln(0.85 / 0.01) = ln 85. An answer that does not
    /// match, with three choices, contributes ln(0.15 / (2/3)) = ln 0.225.
    #[test]
    fn weights_agree_with_a_calculation_by_hand() {
        let clues = [
            clue(1, Some(CopiedAngle), 0.01),
            clue(2, None, 1.0 / 3.0),
            clue(3, Some(CopiedAngle), 0.01),
        ];
        let copied = Evidence::of(CopiedAngle, &clues);
        assert!((copied.weight - (85.0_f64 * 85.0 * 0.225).ln()).abs() < 1e-12);
        assert_eq!((copied.times, copied.asked, copied.questions), (2, 3, 2));
        assert_eq!(copied.to_string(), "2 of 3");
        assert!(copied.names() && !copied.denies());
        let square = Evidence::of(AlwaysSquare, &clues);
        assert!((square.weight - (0.15_f64 / 0.99 * 0.15 / 0.99 * 0.225).ln()).abs() < 1e-12);
        assert!(square.denies() && !square.names());
        let none = Evidence::of(Lossless, &clues);
        assert_eq!((none.weight, none.to_string()), (0.0, "-".into()));
        let order: Vec<_> = evidence(&clues).iter().map(|it| it.misconception).collect();
        assert_eq!(order, [CopiedAngle, AlwaysSquare]);
        assert_eq!(named(&clues), [copied]);
    }

    /// Because this expected value is 1, the probability that a misconception is ever named for
    /// somebody who guesses is at most one divided by the odds (Ville's inequality).
    #[test]
    fn the_expected_ratio_of_a_guess_is_one() {
        for by_chance in [0.01, 0.08, 0.2, 1.0 / 3.0, 0.5] {
            let ratio = by_chance * weight_shown(by_chance).exp()
                + (1.0 - by_chance) * weight_not_shown(by_chance).exp();
            assert!((ratio - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn one_question_names_no_misconception_however_often_it_is_answered() {
        let clues = vec![clue(1, Some(CopiedAngle), 0.01); 4];
        assert!(Evidence::of(CopiedAngle, &clues).weight > 10.0);
        assert_eq!(named(&clues), []);
    }
}
