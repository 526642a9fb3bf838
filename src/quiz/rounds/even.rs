//! Mixed questions that test the common misconceptions often enough to detect them.
//!
//! In the older mixed rounds all families are equally frequent, so some misconceptions could show
//! up in every second question and others in none of twenty. In newer rounds several candidates are
//! drawn at random for each question, and carrom chooses the one that best tests what has not been
//! tested enough.

use std::cmp::Reverse;

use crate::quiz::question::{Dice, Difficulty, Family, Form, Misconception, Question};

/// The number of candidates drawn for each question.
const CANDIDATES: usize = 32;

/// How much each common misconception, and how much every other misconception, should be tested in
/// a round of twenty questions, in the units of [`shown`].
const ENOUGH: [u32; 2] = [16, 3];

/// The weight of a missing test of a common misconception; a missing test of any other
/// misconception has a weight of 1.
const PREFERRED: u32 = 8;

/// The misconceptions that a question can show, and how strongly: roughly the base-3 logarithm of
/// how many times as likely a fitting answer is from a student who holds the misconception as from
/// one who guesses. Whole numbers are used, so that no choice depends on the last digit. If the
/// tolerance is at most half the largest tolerance, even a student who holds the misconception
/// rarely calculates the answer accurately enough, so that misconception is left out.
fn shown(question: &Question) -> impl Iterator<Item = (Misconception, u32)> {
    let strength = match question.form {
        Form::Rays { .. } => 4,
        Form::Number { .. } | Form::Shot(_) => 2,
        Form::Choice { .. } => 1,
    };
    let beliefs = question.beliefs.iter();
    let wide = beliefs.filter(|it| question.width(it) > 0.5);
    wide.filter_map(move |belief| Some((belief.in_codes()?, strength)))
}

/// How much a question contributes to the tests that are still missing, in a round of `count`
/// questions; `tested` is how much each misconception has been tested so far.
fn gain(question: &Question, tested: &[(Misconception, u32)], count: usize) -> u32 {
    let each = shown(question).map(|(it, strength)| {
        let common = Misconception::COMMON.contains(&it);
        let enough = ENOUGH[usize::from(!common)] * count as u32;
        let so_far = tested.iter().filter(|(other, _)| *other == it);
        let so_far: u32 = so_far.map(|(_, strength)| strength).sum();
        let missing = enough.saturating_sub(20 * so_far);
        (20 * strength).min(missing) * if common { PREFERRED } else { 1 }
    });
    each.sum()
}

/// In a round shorter than this, every third question comes from a family not used yet, whatever
/// the question can show, to keep the round varied. A longer round is varied anyway.
const LONG: usize = 16;

/// Questions from these families, with rising difficulty. No family comes twice in a row, and none
/// has more than a quarter of the questions plus one.
pub(super) fn questions(families: &[Family], count: usize, dice: &mut Dice) -> Vec<Question> {
    let mut tested = Vec::new();
    let mut questions: Vec<Question> = Vec::with_capacity(count);
    for i in 0..count {
        let difficulty = Difficulty::rising(i, count);
        let candidates = (0..CANDIDATES).filter_map(|_| {
            let family = dice.pick(families)?;
            let (question, _) = family.ask(difficulty, dice)?;
            let again = questions.last().is_some_and(|last| last.family == *family);
            let often = questions.iter().filter(|it| it.family == *family).count();
            let old = questions.iter().any(|it| it.text == question.text);
            if again || old || often > count / 4 {
                return None;
            }
            let gain = match count < LONG && i % 3 == 2 {
                true => u32::from(often == 0),
                false => gain(&question, &tested, count),
            };
            Some((gain, question))
        });
        // The first of the candidates with the highest gain.
        if let Some((_, question)) = candidates.min_by_key(|(gain, _)| Reverse(*gain)) {
            tested.extend(shown(&question));
            questions.push(question);
        }
    }
    questions
}
