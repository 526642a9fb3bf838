//! The teams giving their votes.

use crate::class::{ClassRound, Vote};
use crate::widgets::AnswerInput;
use crate::widgets::input::ListView;

/// Answers nearer to each other than this are the same, counted in what still counts as
/// right.
const SAME: f64 = 1e-6;

/// The teams giving one of their two votes on a question.
#[derive(Debug, Clone)]
pub(super) struct VoteEntry {
    /// Which vote.
    pub(super) vote: Vote,
    question: usize,
    /// The teams; after the last of them comes going on.
    pub(super) teams: ListView,
    /// What the team at the mark is about to say.
    pub(super) input: Option<AnswerInput>,
    /// Whether the class may see it meanwhile.
    pub(super) is_open: bool,
}

impl VoteEntry {
    /// Before any key: at the first team that has not voted. After talking every team
    /// keeps its vote unless it says otherwise, so there the mark is at going on.
    pub(super) fn new(round: &ClassRound, question: usize, vote: Vote) -> Self {
        let mut entry = Self {
            vote,
            question,
            teams: ListView::default(),
            input: None,
            is_open: false,
        };
        entry.choose_next(round);
        entry
    }

    /// The row of the mark: a team, or how many teams there are at going on.
    pub(super) fn at(&self, round: &ClassRound) -> usize {
        self.teams.chosen(round.teams().len() + 1)
    }

    /// Whether the team at the mark has a vote that it can take back.
    pub(super) fn has_voted(&self, round: &ClassRound) -> bool {
        let ballot = round.ballot(self.question, self.at(round));
        ballot.vote(self.vote).is_some()
    }

    /// Puts the mark at the team that is next to vote, or at going on.
    fn choose_next(&mut self, round: &ClassRound) {
        let count = round.teams().len();
        let waits = |team: &usize| round.ballot(self.question, *team).first.is_none();
        let waiting = (0..count).find(|team| self.vote == Vote::First && waits(team));
        self.teams.choose(waiting.unwrap_or(count));
    }

    /// Lets a team make or change its vote.
    pub(super) fn open(&mut self, team: usize, round: &ClassRound) {
        let Some(question) = round.questions().get(self.question) else {
            return;
        };
        self.teams.choose(team);
        self.is_open = false;
        let ballot = round.ballot(self.question, team);
        self.input = Some(match ballot.said(self.vote) {
            Some(said) => AnswerInput::saying(&question.form, &said),
            None => AnswerInput::new(&question.form),
        });
    }

    /// Takes back the vote of the team at the mark.
    pub(super) fn take_back(&self, round: &mut ClassRound) {
        round.vote(self.question, self.at(round), self.vote, None);
    }

    /// Gives the vote that was made, and goes to the next team.
    pub(super) fn give(&mut self, round: &mut ClassRound) {
        let team = self.at(round);
        let said = self.input.take().and_then(|input| input.said());
        let before = round.ballot(self.question, team).first;
        // Whoever says the same again has kept the vote.
        let same = match (round.questions().get(self.question), said, before) {
            (Some(question), Some(said), Some(before)) => {
                question.form.distance(&said, &before) < SAME
            }
            _ => false,
        };
        let kept = self.vote == Vote::Second && same;
        round.vote(self.question, team, self.vote, said.filter(|_| !kept));
        self.choose_next(round);
    }
}
