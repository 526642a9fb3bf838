//! Advice after a first vote.

use super::ballot::Vote;
use super::round::ClassRound;
use crate::progress::Tally;

/// What to do after the first vote, depending on the share of right votes (C. H. Crouch and E.
/// Mazur, *Peer Instruction: Ten years of experience and results*, 2001): discussion helps when
/// some have understood and others have not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Advice {
    /// Fewer than three in ten are right: too few to convince the others.
    ExplainAgain,
    /// Between three and eight in ten are right: discussion helps most.
    Talk,
    /// More than eight in ten are right.
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

    /// The text for the teacher, which does not reveal the right answer.
    pub const fn words(self) -> &'static str {
        match self {
            Self::ExplainAgain => "Under 30 % are right: explain, then vote again.",
            Self::Talk => "30 to 80 % are right: discussion helps most now.",
            Self::GoOn => "More than 80 % are right: continue to the shot.",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quiz::Code;

    #[test]
    fn the_advice_depends_on_the_share_of_right_votes() {
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
