//! The teams giving their votes.

use crate::class::{ClassChange, ClassRound, Said, Session, Vote};
use crate::quiz::Response;
use crate::widgets::AnswerInput;
use crate::widgets::input::ListView;

/// Answers nearer to each other than this are the same, counted in what still counts as
/// right.
const SAME: f64 = 1e-6;

/// The teams giving one of their two votes on a question.
#[derive(Debug, Clone)]
pub(super) struct VoteEntry {
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
        self.teams.chosen(round.participants().len() + 1)
    }

    /// Whether the team at the mark has a vote that it can take back.
    pub(super) fn has_voted(&self, round: &ClassRound) -> bool {
        let ballot = round.ballot(self.question, self.at(round));
        ballot.vote(self.vote).is_some()
    }

    /// Puts the mark at the team that is next to vote, or at going on.
    fn choose_next(&mut self, round: &ClassRound) {
        let count = round.participants().len();
        let waits = |team: &usize| {
            round
                .ballot(self.question, *team)
                .vote(Vote::First)
                .is_none()
        };
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

    /// What takes back the vote of the team at the mark.
    pub(super) fn take_back(&self, round: &ClassRound) -> ClassChange {
        self.change(self.at(round), None)
    }

    fn change(&self, person: usize, said: Option<Response>) -> ClassChange {
        ClassChange::Vote {
            question: self.question,
            vote: self.vote,
            person,
            said: said.map(Said::from),
        }
    }

    /// Gives the vote that was made, and goes to the next team.
    pub(super) fn give(&mut self, session: &mut Session) {
        let round = session.round();
        let team = self.at(round);
        let said = self.input.take().and_then(|input| input.said());
        let before = round.ballot(self.question, team).vote(Vote::First);
        // Whoever says the same again has kept the vote.
        let same = match (round.questions().get(self.question), said, before) {
            (Some(question), Some(said), Some(before)) => {
                question.form.distance(&said, &before) < SAME
            }
            _ => false,
        };
        let kept = self.vote == Vote::Second && same;
        session.enter(&self.change(team, said.filter(|_| !kept)));
        self.choose_next(session.round());
    }
}
