//! Both rays from the impact angle: equal masses, with and without loss.

use super::hit_kinds::Kind;
use super::where_to::of_kinds;
use crate::quiz::dice::Dice;
use crate::quiz::{Difficulty, Family, Question};

/// Draws a question.
pub(in crate::quiz) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let kinds = match difficulty {
        Difficulty::Easy | Difficulty::Middle => &[Kind::EqualAngle],
        Difficulty::Hard => &[Kind::LossyAngle],
    };
    of_kinds(Family::FromAngle, difficulty, kinds, dice)
}
