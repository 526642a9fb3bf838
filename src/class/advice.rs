//! Advice after a first vote.

use super::ballot::Vote;
use super::round::ClassRound;
use crate::progress::Tally;

/// What to do after a first vote, by the share that is right (C. H. Crouch and E. Mazur, *Peer
/// Instruction: Ten years of experience and results*, 2001): talking helps where some have
/// understood and some have not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Advice {
    /// Fewer than three of ten are right: nobody could convince the others.
    ExplainAgain,
    /// In between: discussion helps most.
    Talk,
    /// More than eight of ten are right.
    GoOn,
}

impl Advice {
    /// The advice after the first vote on a question; `None` if nobody has voted.
    pub fn of(round: &ClassRound, question: usize) -> Option<Self> {
        let Tally {
            attempts, right, ..
        } = round.results(question, Vote::First);
        match attempts {
            0 => None,
            all if 10 * right < 3 * all => Some(Self::ExplainAgain),
            all if 10 * right > 8 * all => Some(Self::GoOn),
            _ => Some(Self::Talk),
        }
    }

    /// The words for the teacher, which do not reveal the right answer.
    pub const fn words(self) -> &'static str {
        match self {
            Self::ExplainAgain => "Under 30 % are right: explain once more, vote again.",
            Self::Talk => "30 to 80 % are right: talking helps most now.",
            Self::GoOn => "More than 80 % are right: go on to the shot.",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quiz::Code;

    #[test]
    fn the_share_that_is_right_advises() {
        let mut round = ClassRound::with_tally(Code::parse("concept-1").unwrap());
        assert_eq!(Advice::of(&round, 0), None);
        let truth = round.questions()[0].form.truth();
        let choices = round.choices(0);
        let right = choices.iter().position(|it| *it == truth).unwrap();
        let wrong = usize::from(right == 0);
        for (of_ten, advice) in [
            (2, Advice::ExplainAgain),
            (3, Advice::Talk),
            (8, Advice::Talk),
            (9, Advice::GoOn),
        ] {
            let mut counts = vec![0; choices.len()];
            (counts[right], counts[wrong]) = (of_ten, 10 - of_ten);
            assert!(round.count(0, Vote::First, Some(&counts)));
            assert_eq!(Advice::of(&round, 0), Some(advice), "{of_ten}");
        }
    }
}
