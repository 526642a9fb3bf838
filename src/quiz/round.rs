//! A round: ten questions fixed by a seed.

use super::Question;
use super::dice::Dice;
use super::kind::Difficulty;

/// Ten questions, mixed in kind and rising in difficulty.
///
/// The seed is a code that players give each other, so the same seed must bring the
/// same questions on every machine and in every version. They follow from it alone:
/// the dice are PCG32 as described in the `dice` file, the kinds, their order and
/// their possible figures stand in the `kind` file, and all three are part of the
/// format.
#[derive(Debug, Clone, PartialEq)]
pub struct Round {
    seed: u64,
    questions: Vec<Question>,
}

impl Round {
    /// How many questions a round has.
    pub const LENGTH: usize = 10;

    /// The round of a seed.
    pub fn new(seed: u64) -> Self {
        let mut dice = Dice::new(seed);
        let mut questions = Vec::with_capacity(Self::LENGTH);
        for difficulty in Difficulty::ALL {
            let mut kinds = difficulty.kinds().to_vec();
            dice.shuffle(&mut kinds);
            for kind in kinds {
                questions.extend(kind.draw(difficulty, &questions, &mut dice));
            }
        }
        Self { seed, questions }
    }

    /// The code that fixes it.
    pub fn seed(&self) -> u64 {
        self.seed
    }

    /// Its questions in order.
    pub fn questions(&self) -> &[Question] {
        &self.questions
    }
}
