//! The votes of the teams.

use super::ClassPlace;
use crate::quiz::{
    Answer, Clue, Code, Confidence, Diagnosis, Grade, Misconception, Question, Response, Round,
};

/// Which of the two votes on a question.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Vote {
    /// Predicted in silence.
    First,
    /// After talking.
    Second,
}

impl Vote {
    /// Both, in order.
    pub const BOTH: [Self; 2] = [Self::First, Self::Second];
}

/// What a team said to a question.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Ballot {
    /// Its first vote, if it gave one.
    pub first: Option<Response>,
    /// Its second vote, if it gave one.
    pub second: Option<Response>,
}

impl Ballot {
    /// One of its votes.
    pub fn vote(&self, vote: Vote) -> Option<Response> {
        match vote {
            Vote::First => self.first,
            Vote::Second => self.second,
        }
    }

    /// What the team says at a vote: at the second what it said at first, unless it has
    /// changed that.
    pub fn said(&self, vote: Vote) -> Option<Response> {
        match vote {
            Vote::First => self.first,
            Vote::Second => self.counts(),
        }
    }

    /// The vote that scores: the second, or where there is none the first.
    pub fn counts(&self) -> Option<Response> {
        self.second.or(self.first)
    }
}

/// A round that teams play, with all their votes.
#[derive(Debug, Clone, PartialEq)]
pub struct ClassRound {
    round: Round,
    teams: Vec<String>,
    /// A row a question, a ballot a team.
    ballots: Vec<Vec<Ballot>>,
    place: ClassPlace,
}

impl ClassRound {
    /// A round of these teams in which nobody has voted yet. The names are those that
    /// [`team_names`](super::team_names) gave.
    pub fn new(code: Code, teams: Vec<String>) -> Self {
        let round = Round::of(code);
        let ballots = vec![vec![Ballot::default(); teams.len()]; round.questions().len()];
        Self {
            round,
            teams,
            ballots,
            place: ClassPlace::default(),
        }
    }

    /// The code that fixes its questions.
    pub fn code(&self) -> &Code {
        self.round.code()
    }

    /// Its questions in order.
    pub fn questions(&self) -> &[Question] {
        self.round.questions()
    }

    /// The names of the teams.
    pub fn teams(&self) -> &[String] {
        &self.teams
    }

    /// Where in the round the class is.
    pub fn place(&self) -> ClassPlace {
        self.place
    }

    /// Goes to a place in the round; to one behind the last question it does not.
    pub fn go(&mut self, place: ClassPlace) {
        if place.question < self.questions().len() {
            self.place = place;
        }
    }

    /// What a team said to a question, both counted from 0; nothing where there is no
    /// such team or question.
    pub fn ballot(&self, question: usize, team: usize) -> Ballot {
        let ballot = self.ballots(question).nth(team);
        ballot.copied().unwrap_or_default()
    }

    /// Takes a team's vote on a question, in the place of an earlier one; `None` takes it
    /// back. A vote of another kind than was asked for is not taken.
    pub fn vote(&mut self, question: usize, team: usize, vote: Vote, said: Option<Response>) {
        let fits = |said: &Response| {
            self.questions()
                .get(question)
                .is_some_and(|question| question.form.distance(said, said) <= 0.0)
        };
        if said.as_ref().is_some_and(|said| !fits(said)) {
            return;
        }
        let row = self.ballots.get_mut(question);
        if let Some(ballot) = row.and_then(|row| row.get_mut(team)) {
            match vote {
                Vote::First => ballot.first = said,
                Vote::Second => ballot.second = said,
            }
        }
    }

    /// The ballots on a question, one a team; none where there is no such question.
    fn ballots(&self, question: usize) -> impl Iterator<Item = &Ballot> {
        self.ballots.get(question).into_iter().flatten()
    }

    /// How many teams gave this vote on a question.
    pub fn voted(&self, question: usize, vote: Vote) -> usize {
        let given = self.ballots(question).filter_map(|it| it.vote(vote));
        given.count()
    }

    /// What the teams that have voted say to a question at a vote, as [`Ballot::said`].
    pub fn said(&self, question: usize, vote: Vote) -> impl Iterator<Item = Response> {
        self.ballots(question).filter_map(move |it| it.said(vote))
    }

    /// How good that was.
    pub fn grades(&self, question: usize, vote: Vote) -> Vec<Grade> {
        let said = self.said(question, vote);
        said.filter_map(|said| self.grade(question, Some(said)))
            .collect()
    }

    /// The misconceptions that it fitted, each with what was said.
    pub fn held(
        &self,
        question: usize,
        vote: Vote,
    ) -> impl Iterator<Item = (Misconception, Response)> {
        self.said(question, vote).filter_map(move |said| {
            let diagnosis = self.diagnose(question, Some(said))?;
            Some((diagnosis.misconception, said))
        })
    }

    /// What the votes on a question say of misconceptions, one a team that has voted.
    pub fn clues(&self, question: usize, vote: Vote) -> Vec<Clue> {
        let Some(asked) = self.questions().get(question) else {
            return Vec::new();
        };
        let said = self.said(question, vote);
        said.map(|said| Clue::new(asked, &unsure(said))).collect()
    }

    /// What the votes of a team say of misconceptions, one a question on which it has voted.
    pub fn clues_of(&self, team: usize, vote: Vote) -> Vec<Clue> {
        let asked = self.questions().iter().enumerate();
        let said = asked.filter_map(|(i, asked)| Some((asked, self.ballot(i, team).said(vote)?)));
        said.map(|(asked, said)| Clue::new(asked, &unsure(said)))
            .collect()
    }

    /// Whether anybody has voted at all.
    pub fn is_begun(&self) -> bool {
        let mut ballots = self.ballots.iter().flatten();
        ballots.any(|ballot| ballot.counts().is_some())
    }

    /// Questions on which at least one team has voted, from the first on without a gap.
    pub fn begun(&self) -> usize {
        let empty = |row: &Vec<Ballot>| row.iter().all(|it| it.counts().is_none());
        let place = self.ballots.iter().position(empty);
        place.unwrap_or(self.ballots.len())
    }

    /// How good a vote was; `None` where none was given.
    pub fn grade(&self, question: usize, said: Option<Response>) -> Option<Grade> {
        let question = self.questions().get(question)?;
        Some(Grade::new(question, &unsure(said?)))
    }

    /// The misconception that a vote fits.
    pub fn diagnose(&self, question: usize, said: Option<Response>) -> Option<Diagnosis> {
        self.questions().get(question)?.diagnose(&unsure(said?))
    }

    /// Points of a team for a question, 0 to [`Grade::MOST`], by how near its vote is;
    /// how sure a team is, is not asked.
    pub fn points(&self, question: usize, team: usize) -> f64 {
        let said = self.ballot(question, team).counts();
        let credit = self.grade(question, said).map_or(0.0, |grade| grade.credit);
        Grade::MOST * credit
    }
}

/// A vote as an answer, with the confidence that changes nothing about its credit.
fn unsure(said: Response) -> Answer {
    Answer::new(said, Confidence::ThinkSo)
}
