//! Parallel forms: questions before a unit, and others after it that test the same.

use std::mem::discriminant;

use super::even;
use crate::quiz::question::{Dice, Family, Misconception, Question};

/// How many questions are drawn in search of one that is parallel to another.
const DRAWS: usize = 4000;

/// The questions of the form before: mixed, so that every common misconception is tested. Only
/// families whose questions have numbers are included, because each of their questions has many
/// parallel ones.
pub(super) fn before(families: &[Family], count: usize, dice: &mut Dice) -> Vec<Question> {
    let mut families = families.to_vec();
    families.retain(|family| *family != Family::Concept);
    even::questions(&families, count, dice)
}

/// For each question of the form before a parallel one: of the same family, topic, difficulty and
/// form, asking for the same, and able to show the same misconceptions, but with other numbers.
pub(super) fn after(before: &[Question], dice: &mut Dice) -> Vec<Question> {
    let mut questions: Vec<Question> = Vec::with_capacity(before.len());
    for asked in before {
        let mut closest = None;
        for _ in 0..DRAWS {
            let Some((drawn, _)) = asked.family.ask(asked.difficulty, dice) else {
                continue;
            };
            let is_old = |it: &Question| (&it.text, &it.form) == (&drawn.text, &drawn.form);
            let is_like = drawn.topic == asked.topic
                && discriminant(&drawn.form) == discriminant(&asked.form)
                && drawn.figures.get("asked") == asked.figures.get("asked")
                && !before.iter().chain(&questions).any(is_old);
            if !is_like {
                continue;
            }
            if held(&drawn) == held(asked) {
                closest = Some(drawn);
                break;
            }
            closest = closest.or(Some(drawn));
        }
        questions.push(closest.unwrap_or_else(|| asked.clone()));
    }
    questions
}

/// The misconceptions that a question can show, as codes count them.
fn held(question: &Question) -> Vec<Misconception> {
    let mut held: Vec<_> = { question.beliefs.iter() }
        .filter_map(|it| it.in_codes())
        .collect();
    held.sort_unstable();
    held.dedup();
    held
}
