//! How strongly answers speak for a misconception; docs/judging.md derives it.
//!
//! Of every answer to a question that could show a misconception one asks how much more
//! likely it is from somebody who holds it than from somebody who guesses. The logarithms
//! of these ratios add up, whatever was asked: that sum is the one figure by which a
//! misconception is named, ranked, said to fade, and looked for.

use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::fmt;

use crate::quiz::question::{Answer, Fit, Misconception, Question, WrongAnswer};

/// The chance that somebody who holds a misconception answers a question that could show
/// it in another way: by a slip, by doubt, or because this once another thought came first.
pub(crate) const SLIP: f64 = 0.15;

/// How many times as likely answers have to be from somebody who holds a misconception as
/// from somebody who guesses before it is named.
pub(crate) const NAMED_ODDS: f64 = 40.0;

/// How many different questions at least have to show a misconception that is named.
pub(crate) const NAMED_QUESTIONS: usize = 2;

/// What one answer says for and against misconceptions.
#[derive(Debug, Clone, PartialEq)]
pub struct Clue {
    /// What tells the question from others.
    pub question: String,
    /// The misconceptions that an answer could have shown.
    pub could_show: Vec<Misconception>,
    /// The one it shows, if any.
    pub shows: Option<Misconception>,
    /// The chance that a guess fits one of them as this answer does, or as one that shows it
    /// would: above 0 and below 1.
    pub(crate) by_chance: f64,
}

impl Clue {
    /// What an answer to a question says.
    pub fn new(question: &Question, answer: &Answer) -> Self {
        Self::of(question, answer, |belief| Some(belief.misconception))
    }

    /// The same, with misconceptions as codes count them: see [`WrongAnswer::in_codes`].
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

    /// The log-likelihood ratio of this answer for a misconception: ln((1 − s) / g) if it
    /// shows it, ln(s / (1 − g)) if it could have, with the chances s of a slip and g that
    /// a guess fits; 0 where it could not.
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

/// What an answer weighs that shows a misconception.
fn weight_shown(by_chance: f64) -> f64 {
    ((1.0 - SLIP) / by_chance).ln()
}

/// What an answer weighs that could have shown a misconception and does not.
fn weight_not_shown(by_chance: f64) -> f64 {
    (SLIP / (1.0 - by_chance)).ln()
}

/// What some answers say of one misconception.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Evidence {
    /// Which.
    pub misconception: Misconception,
    /// The log-likelihood ratio: above 0 the answers are more likely from somebody who holds
    /// it, below 0 from somebody who guesses.
    pub weight: f64,
    /// How many answers show it.
    pub times: usize,
    /// How many could have.
    pub asked: usize,
    /// How many different questions show it.
    pub questions: usize,
}

impl Evidence {
    /// What these answers say of a misconception.
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

    /// Whether it is enough to name the misconception.
    pub(crate) fn names(&self) -> bool {
        self.weight >= NAMED_ODDS.ln() && self.questions >= NAMED_QUESTIONS
    }

    /// Whether it is enough to say that the misconception is not held: as strong as what
    /// names it, the other way round.
    pub(crate) fn denies(&self) -> bool {
        self.weight <= -NAMED_ODDS.ln()
    }

    /// The stronger first, to a millionth.
    pub(crate) fn stronger_first(&self, other: &Self) -> Ordering {
        let rank = |it: &Self| (1e6 * it.weight).round() as i64;
        rank(other).cmp(&rank(self))
    }
}

/// "2 of 5": how often it showed of how often it could have; "-" where it never could.
impl fmt::Display for Evidence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self { asked: 0, .. } => f.pad("-"),
            Self { times, asked, .. } => f.pad(&format!("{times} of {asked}")),
        }
    }
}

/// What these answers say of each misconception that they could have shown, the strongest
/// first; of equals the first of [`Misconception::ALL`].
pub(crate) fn evidence(clues: &[Clue]) -> Vec<Evidence> {
    let each = Misconception::ALL.iter();
    let mut all: Vec<Evidence> = each.map(|it| Evidence::of(*it, clues)).collect();
    all.retain(|it| it.asked > 0);
    all.sort_by(Evidence::stronger_first);
    all
}

/// The misconceptions that these answers name, the surest first.
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

    /// Two rays that fit: ln(0.85 / 0.01) = ln 85. One of three choices that does not:
    /// ln(0.15 / (2/3)) = ln 0.225.
    #[test]
    fn weights_by_hand() {
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

    /// By this the chance that a guess is ever named is at most one over the odds (Ville).
    #[test]
    fn from_a_guess_a_ratio_of_one_is_expected() {
        for by_chance in [0.01, 0.08, 0.2, 1.0 / 3.0, 0.5] {
            let ratio = by_chance * weight_shown(by_chance).exp()
                + (1.0 - by_chance) * weight_not_shown(by_chance).exp();
            assert!((ratio - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn one_question_names_nothing_however_often_it_is_answered() {
        let clues = vec![clue(1, Some(CopiedAngle), 0.01); 4];
        assert!(Evidence::of(CopiedAngle, &clues).weight > 10.0);
        assert_eq!(named(&clues), []);
    }
}
