//! The teams giving their votes.

use crate::class::{ClassRound, Vote};
use crate::messages::Key;
use crate::widgets::{AnswerInput, Outcome};

/// Answers nearer to each other than this are the same, counted in what still counts as
/// right.
const SAME: f64 = 1e-6;

/// The teams giving one of their two votes on a question.
#[derive(Debug, Clone)]
pub(super) struct Booths {
    /// Which vote.
    pub(super) vote: Vote,
    question: usize,
    /// The team that the mark is at; after the last team it is at going on.
    pub(super) at: usize,
    /// What the team at the mark is about to say.
    pub(super) input: Option<AnswerInput>,
}

/// What follows from a key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Polled {
    /// It meant nothing here.
    Ignored,
    /// The mark moved, or a vote is being made.
    Stay,
    /// A vote was given or taken back.
    Voted,
    /// On to what comes next.
    GoOn,
}

impl Booths {
    /// Before any key: at the first team that has not voted. After talking every team
    /// keeps its vote unless it says otherwise, so there the mark is at going on.
    pub(super) fn new(round: &ClassRound, question: usize, vote: Vote) -> Self {
        let mut booths = Self {
            vote,
            question,
            at: 0,
            input: None,
        };
        booths.at = match vote {
            Vote::First => booths.waiting(round).unwrap_or(round.teams().len()),
            Vote::Second => round.teams().len(),
        };
        booths
    }

    /// The first team that has not given its first vote.
    fn waiting(&self, round: &ClassRound) -> Option<usize> {
        let mut teams = 0..round.teams().len();
        teams.find(|team| round.ballot(self.question, *team).first.is_none())
    }

    /// Takes a key.
    pub(super) fn key(&mut self, key: Key, round: &mut ClassRound) -> Polled {
        if self.input.is_some() {
            return self.input_key(key, round);
        }
        let last = round.teams().len();
        match key {
            Key::Up | Key::BackTab => self.at = self.at.saturating_sub(1),
            Key::Down | Key::Tab => self.at = (self.at + 1).min(last),
            Key::Home => self.at = 0,
            Key::End => self.at = last,
            Key::Enter | Key::Char(' ') if self.at == last => return Polled::GoOn,
            Key::Enter | Key::Char(' ') => self.open(self.at, round),
            Key::Char(digit @ '1'..='8') => {
                let team = usize::from(digit as u8 - b'1');
                if team >= last {
                    return Polled::Ignored;
                }
                self.open(team, round);
            }
            Key::Delete | Key::Char('x' | 'X') if self.at < last => {
                round.vote(self.question, self.at, self.vote, None);
                return Polled::Voted;
            }
            _ => return Polled::Ignored,
        }
        Polled::Stay
    }

    /// Lets a team make or change its vote.
    pub(super) fn open(&mut self, team: usize, round: &ClassRound) {
        let Some(question) = round.questions().get(self.question) else {
            return;
        };
        self.at = team;
        let ballot = round.ballot(self.question, team);
        let said = match self.vote {
            Vote::First => ballot.first,
            Vote::Second => ballot.counts(),
        };
        self.input = Some(match said {
            Some(said) => AnswerInput::saying(&question.form, &said),
            None => AnswerInput::new(&question.form),
        });
    }

    fn input_key(&mut self, key: Key, round: &mut ClassRound) -> Polled {
        let Some(input) = &mut self.input else {
            return Polled::Ignored;
        };
        match input.update(key) {
            Outcome::Used => Polled::Stay,
            Outcome::Done(()) => {
                let said = input.said();
                self.input = None;
                let before = round.ballot(self.question, self.at).first;
                // Whoever says the same again has kept the vote.
                let same = match (round.questions().get(self.question), said, before) {
                    (Some(question), Some(said), Some(before)) => {
                        question.form.distance(&said, &before) < SAME
                    }
                    _ => false,
                };
                let kept = self.vote == Vote::Second && same;
                let vote = said.filter(|_| !kept);
                round.vote(self.question, self.at, self.vote, vote);
                self.at = match self.vote {
                    Vote::First => self.waiting(round).unwrap_or(round.teams().len()),
                    Vote::Second => round.teams().len(),
                };
                Polled::Voted
            }
            Outcome::Ignored if key == Key::Escape => {
                self.input = None;
                Polled::Stay
            }
            Outcome::Ignored => Polled::Ignored,
        }
    }
}
