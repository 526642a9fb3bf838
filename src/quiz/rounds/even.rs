//! Mixed questions in which every misconception is met often enough to be seen.
//!
//! The families of the older mixed rounds come alike often, so that some misconceptions could
//! show themselves in every other question and others in none of twenty. Here of some
//! questions, drawn with the dice, the one is asked that can show most of what has not been
//! met enough.

use crate::quiz::question::{Dice, Difficulty, Family, Form, Misconception, Question};

/// How many questions are drawn for each that is asked.
const CANDIDATES: usize = 32;

/// How much a common misconception should be met in a round of twenty, and another, counted
/// as [`shown`].
const ENOUGH: [u32; 2] = [16, 3];

/// How many times as much what a common misconception lacks weighs.
const PREFERRED: u32 = 8;

/// What a question can show, and how strongly: about the logarithm, to the base of 3, of how
/// much more likely what fits is than from a guess. Whole, so that no choice hangs on the
/// last digit. What has to be reckoned to less than half of the widest that can count as
/// right shows too seldom to count.
fn shown(question: &Question) -> impl Iterator<Item = (Misconception, u32)> {
    let strength = match question.form {
        Form::Rays { .. } => 4,
        Form::Number { .. } | Form::Shot(_) => 2,
        Form::Choice { .. } => 1,
    };
    let wide = question
        .beliefs
        .iter()
        .filter(|it| question.width(it) > 0.5);
    wide.filter_map(move |belief| Some((belief.in_codes()?, strength)))
}

/// How much each misconception has been met.
#[derive(Default)]
struct TimesMet(Vec<(Misconception, u32)>);

impl TimesMet {
    fn of(&self, misconception: Misconception) -> u32 {
        let met = self.0.iter().filter(|(it, _)| *it == misconception);
        met.map(|(_, strength)| strength).sum()
    }

    /// How much a question adds of what has not been met enough, in a round of `count`.
    fn gain(&self, question: &Question, count: usize) -> u32 {
        let each = shown(question).map(|(it, strength)| {
            let common = Misconception::COMMON.contains(&it);
            let enough = ENOUGH[usize::from(!common)] * count as u32;
            let missing = enough.saturating_sub(20 * self.of(it));
            (20 * strength).min(missing) * if common { PREFERRED } else { 1 }
        });
        each.sum()
    }
}

/// In a round shorter than this every third question is of a family that has not come yet,
/// whatever it can show: what is mixed is to stay so. A longer one has room for both.
const LONG: usize = 16;

/// Questions of these families, rising in difficulty. No family comes twice in a row, and none
/// much oftener than once in four.
pub(super) fn questions(families: &[Family], count: usize, dice: &mut Dice) -> Vec<Question> {
    let mut met = TimesMet::default();
    let mut questions: Vec<Question> = Vec::with_capacity(count);
    for i in 0..count {
        let difficulty = Difficulty::rising(i, count);
        let mut best: Option<(u32, Question)> = None;
        for _ in 0..CANDIDATES {
            let Some(family) = dice.pick(families) else {
                continue;
            };
            let Some((question, _)) = family.ask(difficulty, dice) else {
                continue;
            };
            let again = questions.last().is_some_and(|last| last.family == *family);
            let often = questions.iter().filter(|it| it.family == *family).count();
            let old = questions.iter().any(|it| it.text == question.text);
            if again || old || often > count / 4 {
                continue;
            }
            let gain = match count < LONG && i % 3 == 2 {
                true => u32::from(often == 0),
                false => met.gain(&question, count),
            };
            if best.as_ref().is_none_or(|(most, _)| gain > *most) {
                best = Some((gain, question));
            }
        }
        if let Some((_, question)) = best {
            met.0.extend(shown(&question));
            questions.push(question);
        }
    }
    questions
}
