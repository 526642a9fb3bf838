//! Both rays from the offset: the angle has to be found first.

use super::hit_kinds::Kind;
use super::where_to::of_kinds;
use crate::quiz::dice::Dice;
use crate::quiz::{Difficulty, Family, Question};

/// Draws a question.
pub(in crate::quiz) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let kinds: &[Kind] = match difficulty {
        Difficulty::Easy | Difficulty::Middle => &[Kind::EqualOffset],
        Difficulty::Hard => &[Kind::TournamentOffset, Kind::MarblesOffset],
    };
    of_kinds(Family::FromOffset, difficulty, kinds, dice)
}
