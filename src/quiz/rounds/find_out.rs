//! Finding out what a student believes: the choice of each question depends on the answers so far.
//!
//! The student is assumed to hold one of the misconceptions, or none. The answers determine the
//! probability of each case. Several candidates are drawn at random, and the round asks the
//! question whose answer is expected to give the most information, in bits (D. V. Lindley, 1956).
//! The round ends when one misconception has been established, when all have been ruled out, or
//! when the maximum number of questions has been asked.

use std::cmp::Reverse;

use crate::quiz::misconceptions::{Clue, Evidence, SLIP, evidence};
use crate::quiz::question::{Dice, Difficulty, Family, Fit, Misconception, Question};

/// The probability, before the first answer, that the student holds none of the misconceptions.
const NONE_BEFORE: f64 = 0.25;
/// How many times as likely a common misconception is as an uncommon one, before the first answer.
const COMMON: f64 = 5.0;
/// The probability at which a named misconception is considered established.
const CLEAR: f64 = 0.95;
/// All misconceptions are considered ruled out if the probability that the student holds none is at
/// least this.
const NONE_LEFT: f64 = 0.9;
/// The minimum number of questions before the round can end.
const FEWEST: usize = 3;
/// The minimum number of questions before the first hard one.
const BEFORE_HARD: usize = 3;

/// The candidates drawn for each question: the families, and how many questions of each difficulty
/// are drawn from each family.
pub(super) const CANDIDATES: [(Family, usize); 11] = [
    (Family::FromAngle, 1),
    (Family::FromOffset, 1),
    (Family::FromPicture, 1),
    (Family::UnequalMasses, 2),
    (Family::Speeds, 1),
    (Family::Separation, 1),
    (Family::EnergyShare, 1),
    (Family::Weigh, 1),
    (Family::BothMoving, 3),
    (Family::CentreOfMass, 4),
    (Family::Concept, 6),
];

/// The candidates for the first question, none of which is hard: collisions of equal masses.
pub(super) const FIRST_CANDIDATES: [(Family, usize); 3] = [
    (Family::FromAngle, 3),
    (Family::FromOffset, 3),
    (Family::FromPicture, 3),
];

/// Misconceptions that are not tested for, because only students who have read about foils,
/// friction, restitution or the greatest deflection can show them.
const NOT_SOUGHT: [Misconception; 8] = [
    Misconception::EveryAngleAlike,
    Misconception::BeyondLargest,
    Misconception::EAsEnergy,
    Misconception::GripIgnored,
    Misconception::GripStopsAll,
    Misconception::HalfAngleForgotten,
    Misconception::TooGentle,
    Misconception::NeverBack,
];

/// The probabilities, given the answers, of each misconception that is tested for and of holding
/// none.
struct Posterior {
    held: Vec<(Misconception, f64)>,
    none: f64,
}

impl Posterior {
    /// The probabilities after answers that give this evidence.
    fn new(evidence: &[Evidence]) -> Self {
        let weight = |it: Misconception| {
            let found = evidence.iter().find(|found| found.misconception == it);
            found.map_or(0.0, |found| found.weight)
        };
        let sought = Misconception::ALL.iter().copied();
        let sought = sought.filter(|it| it.in_codes() == Some(*it) && !NOT_SOUGHT.contains(it));
        let before = |it| match Misconception::COMMON.contains(&it) {
            true => COMMON,
            false => 1.0,
        };
        let all_before: f64 = sought.clone().map(before).sum();
        let mut held: Vec<_> = sought
            .map(|it| (it, before(it) / all_before * weight(it).exp()))
            .collect();
        let none = NONE_BEFORE / (1.0 - NONE_BEFORE);
        let all = none + held.iter().map(|(_, likely)| likely).sum::<f64>();
        held.iter_mut().for_each(|(_, likely)| *likely /= all);
        Self {
            held,
            none: none / all,
        }
    }

    /// The probability that the student holds this misconception.
    fn of(&self, misconception: Misconception) -> f64 {
        let found = self.held.iter().find(|(it, _)| *it == misconception);
        found.map_or(0.0, |(_, likely)| *likely)
    }

    /// The information expected from the answer to a question, in bits: the mutual information
    /// between the belief and the answer.
    fn information(&self, question: &Question) -> f64 {
        let by_chance = question.by_chance(Fit::Whole);
        let known = question.beliefs.iter();
        let known: Vec<_> = known
            .filter_map(|belief| Some((belief, belief.in_codes()?)))
            .collect();
        let others = (1.0 - by_chance * known.len() as f64).max(0.0);
        // For each misconception that this question can show, its probability, and the probability
        // that its holder shows it: if the tolerance is small, the holder is more likely to miss
        // the answer.
        let held = known.iter().map(|(belief, misconception)| {
            let shows = (1.0 - SLIP) * question.width(belief);
            (self.of(*misconception), shows)
        });
        let elsewhere = 1.0 - held.clone().map(|(likely, _)| likely).sum::<f64>();
        let hidden: f64 = held
            .clone()
            .map(|(likely, shows)| likely * (1.0 - shows))
            .sum();
        // The answer of a student who holds none of these misconceptions can fit any of them only
        // by chance.
        let each = held
            .clone()
            .map(|(likely, shows)| likely * shows + elsewhere * by_chance);
        let of_answers: f64 = each.map(bits).sum::<f64>() + bits(hidden + elsewhere * others);
        let of_holders = held.map(|(likely, shows)| likely * (bits(shows) + bits(1.0 - shows)));
        let of_guesses = known.len() as f64 * bits(by_chance) + bits(others);
        of_answers - of_holders.sum::<f64>() - elsewhere * of_guesses
    }
}

/// −p log₂ p.
fn bits(p: f64) -> f64 {
    if p > 0.0 { -p * p.log2() } else { 0.0 }
}

/// Whether these answers settle the result: either one misconception has been named and
/// established, or all have been ruled out. `in_codes` is the evidence from the same answers when
/// misconceptions are counted as in the codes of rounds.
pub(super) fn is_settled(clues: &[Clue], in_codes: &[Clue]) -> bool {
    if clues.len() < FEWEST {
        return false;
    }
    let posterior = Posterior::new(&evidence(in_codes));
    let first = evidence(clues).into_iter().next();
    let likely = |it: Misconception| it.in_codes().map_or(0.0, |it| posterior.of(it));
    first.is_some_and(|it| it.names() && likely(it.misconception) >= CLEAR)
        || posterior.none >= NONE_LEFT
}

/// The next question of a round: the most informative of the candidates drawn from these families,
/// except questions that have already been asked.
pub(super) fn ask(
    candidates: &[(Family, usize)],
    asked: &[Question],
    in_codes: &[Clue],
    dice: &mut Dice,
) -> Option<Question> {
    let posterior = Posterior::new(&evidence(in_codes));
    let hardest = match asked.len() < BEFORE_HARD {
        true => Difficulty::Middle,
        false => Difficulty::Hard,
    };
    let difficulties = Difficulty::ALL.into_iter().filter(|it| *it <= hardest);
    let draws = candidates.iter().flat_map(|&(family, each)| {
        let of_family = difficulties.clone().map(move |it| (family, it));
        of_family.flat_map(move |it| std::iter::repeat_n(it, each))
    });
    let informative = draws.filter_map(|(family, difficulty)| {
        let (question, _) = family.ask(difficulty, dice)?;
        if asked.iter().any(|old| old.text == question.text) {
            return None;
        }
        // The information is rounded to a millionth of a bit, so that no choice depends on the
        // last digit of a logarithm.
        let information = (1e6 * posterior.information(&question)).round() as i64;
        Some((information, question))
    });
    // The first of the most informative questions.
    let best = informative.min_by_key(|(information, _)| Reverse(*information));
    best.map(|(_, question)| question)
}
