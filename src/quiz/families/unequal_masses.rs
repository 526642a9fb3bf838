//! Both rays with a heavier striker or a heavier target.

use super::hit_kinds::Kind;
use super::where_to::of_kinds;
use crate::quiz::dice::Dice;
use crate::quiz::{Difficulty, Family, Question};

/// Draws a question.
pub(in crate::quiz) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let kinds: &[Kind] = match difficulty {
        Difficulty::Easy => &[Kind::TournamentAngle, Kind::MarblesAngle, Kind::HeadOn],
        Difficulty::Middle => &[Kind::TournamentAngle, Kind::MarblesAngle],
        Difficulty::Hard => &[Kind::LossyMarbles],
    };
    of_kinds(Family::UnequalMasses, difficulty, kinds, dice)
}
