//! The votes of a class.

use std::net::SocketAddrV4;

use serde::{Deserialize, Serialize};
use strum::{EnumString, IntoStaticStr};

use super::names::{folded, free_name, tidy};
use super::{ClassPlace, DoorCode, Said, SeatToken, WayOfVoting};
use crate::quiz::{
    Answer, Clue, Code, Confidence, Diagnosis, Grade, Misconception, Question, Response, Round,
};

/// Which of the two votes on a question; its name in files is "first".
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, EnumString, IntoStaticStr)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
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

/// What a team, or somebody on a device, said to a question.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Ballot {
    /// The first vote, if one was given.
    pub first: Option<Response>,
    /// The second vote, if one was given.
    pub second: Option<Response>,
    /// How sure they were of each, where that was asked.
    pub sure: [Option<Confidence>; 2],
}

impl Ballot {
    /// One of its votes.
    pub fn vote(&self, vote: Vote) -> Option<Response> {
        match vote {
            Vote::First => self.first,
            Vote::Second => self.second,
        }
    }

    /// Puts a vote in the place of an earlier one; `None` takes that back.
    pub(super) fn put(&mut self, vote: Vote, said: Option<Said>) {
        let response = said.map(|it| it.response);
        match vote {
            Vote::First => self.first = response,
            Vote::Second => self.second = response,
        }
        self.sure[vote as usize] = said.and_then(|it| it.sure);
    }

    /// A vote with how sure they were of it.
    pub fn given(&self, vote: Vote) -> Option<Said> {
        Some(Said {
            response: self.vote(vote)?,
            sure: self.sure[vote as usize],
        })
    }

    /// What the team says at a vote: at the second what it said at first, unless it has
    /// changed that.
    pub fn said(&self, vote: Vote) -> Option<Response> {
        match vote {
            Vote::First => self.first,
            Vote::Second => self.counts(),
        }
    }

    /// What the team says at a vote, as an answer.
    fn answer(&self, vote: Vote) -> Option<Answer> {
        let given = match vote {
            Vote::First => self.given(Vote::First),
            Vote::Second => self.given(Vote::Second).or(self.given(Vote::First)),
        }?;
        let sure = given.sure.unwrap_or(UNSURE);
        Some(Answer::new(given.response, sure))
    }

    /// The vote that scores: the second, or where there is none the first.
    pub fn counts(&self) -> Option<Response> {
        self.second.or(self.first)
    }
}

/// A round that a class plays, with all its votes.
#[derive(Debug, Clone, PartialEq)]
pub struct ClassRound {
    round: Round,
    way: WayOfVoting,
    teams: Vec<String>,
    /// A row a question, a ballot a team.
    ballots: Vec<Vec<Ballot>>,
    /// For each question the counts of both votes, one a choice; empty where nobody has
    /// counted.
    pub(super) tallies: Vec<[Vec<u32>; 2]>,
    /// How pupils come in on devices of their own, as long as they may come back.
    pub(super) door: Option<Door>,
    place: ClassPlace,
    /// What the class is called; perhaps nothing.
    class: String,
    /// How many votes in its file fit none of its questions and were dropped.
    pub(super) dropped: usize,
}

/// How pupils come in, and who sits where.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Door {
    /// The code that lets them in.
    pub(super) code: DoorCode,
    /// Where their devices found it last.
    pub(super) address: Option<SocketAddrV4>,
    /// What brings each back to their place, in the order of their names; nothing for whom
    /// no device was seen.
    pub(super) seats: Vec<Option<SeatToken>>,
    /// Who was removed and has not been let in again.
    pub(super) removed: Vec<Removed>,
}

/// Somebody whom the teacher has removed: the device, if it was seen, and the name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Removed {
    pub(super) seat: Option<SeatToken>,
    pub(super) name: String,
}

impl ClassRound {
    /// A round of these teams in which nobody has voted yet. The names are those that
    /// [`team_names`](super::team_names) gave.
    pub fn new(code: Code, teams: Vec<String>) -> Self {
        Self::voting(WayOfVoting::Teams, code, teams)
    }

    /// A round in which hands or cards are counted.
    pub fn with_tally(code: Code) -> Self {
        Self::voting(WayOfVoting::Tally, code, Vec::new())
    }

    /// A round on devices of their own, to which nobody has come yet.
    pub fn with_devices(code: Code) -> Self {
        Self::voting(WayOfVoting::Devices, code, Vec::new())
    }

    /// A round of these teams or people who vote in this way.
    pub(super) fn voting(way: WayOfVoting, code: Code, teams: Vec<String>) -> Self {
        let round = Round::of(code);
        let questions = round.questions().len();
        Self {
            round,
            way,
            ballots: vec![vec![Ballot::default(); teams.len()]; questions],
            tallies: vec![Default::default(); questions],
            door: None,
            teams,
            place: ClassPlace::default(),
            class: String::new(),
            dropped: 0,
        }
    }

    /// The same round of a class of this name, tidied; perhaps nothing.
    #[must_use]
    pub fn of_class(self, name: &str) -> Self {
        let class = tidy(name);
        Self { class, ..self }
    }

    /// What the class is called; perhaps nothing.
    pub fn class(&self) -> &str {
        &self.class
    }

    /// Whether it is of a class of this name, tidied.
    pub fn is_of_class(&self, name: &str) -> bool {
        self.class == tidy(name)
    }

    /// How many votes in its file do not fit their question and were dropped when it was read.
    pub fn dropped_votes(&self) -> usize {
        self.dropped
    }

    /// How the class votes.
    pub fn way(&self) -> WayOfVoting {
        self.way
    }

    /// The code that lets pupils in on devices of their own, while the door is there.
    pub fn door(&self) -> Option<DoorCode> {
        self.door.as_ref().map(|door| door.code)
    }

    /// Where pupils' devices found the round last, and look for it.
    pub fn address(&self) -> Option<SocketAddrV4> {
        self.door.as_ref()?.address
    }

    /// Puts a door in: from now on pupils may come in with this code, at this address. A code
    /// that is there already stays as it is.
    pub fn open(&mut self, code: DoorCode, address: Option<SocketAddrV4>) {
        let seats = vec![None; self.teams.len()];
        let door = self.door.get_or_insert(Door {
            code,
            address,
            seats,
            removed: Vec::new(),
        });
        door.address = address;
    }

    /// Takes the door away with all that would bring somebody back; names and votes stay.
    pub fn close(&mut self) {
        self.door = None;
    }

    /// Who has this token, counted from 0.
    pub fn seat(&self, token: SeatToken) -> Option<usize> {
        let seats = &self.door.as_ref()?.seats;
        seats.iter().position(|seat| *seat == Some(token))
    }

    /// The names of those who were removed and have not been let in again.
    pub fn removed(&self) -> impl Iterator<Item = &str> {
        let removed = self.door.iter().flat_map(|door| &door.removed);
        removed.map(|it| it.name.as_str())
    }

    /// Whether somebody with this token or this name was removed and has not been let in again.
    pub fn is_removed(&self, token: Option<SeatToken>, name: &str) -> bool {
        let name = folded(&tidy(name));
        let mut removed = self.door.iter().flat_map(|door| &door.removed);
        removed.any(|it| {
            let is_same_device = token.is_some() && it.seat == token;
            is_same_device || folded(&it.name) == name
        })
    }

    /// What brings somebody back to their place.
    pub fn token(&self, person: usize) -> Option<SeatToken> {
        *self.door.as_ref()?.seats.get(person)?
    }

    /// Another name for somebody, tidied; `None` if nothing of it is left, or somebody else
    /// has it.
    pub fn renamed(&self, person: usize, name: &str) -> Option<String> {
        let name = tidy(name);
        let mut others = self.teams.iter().enumerate().filter(|(i, _)| *i != person);
        let taken = others.any(|(_, other)| folded(other) == folded(&name));
        (!name.is_empty() && !taken).then_some(name)
    }

    /// The name that somebody who calls themselves so would have here: tidied, and with a
    /// number where it is taken; `None` if nothing of it is left.
    pub fn name_for(&self, name: &str) -> Option<String> {
        let name = tidy(name);
        (!name.is_empty()).then(|| free_name(&name, &self.teams))
    }

    /// Lets somebody in under a name that nobody has, with the token that brings them back.
    pub(super) fn join(&mut self, name: &str, token: SeatToken) -> Result<(), String> {
        if self.teams.len() >= self.way.most() {
            return Err(format!("expected {} people at most", self.way.most()));
        }
        if tidy(name) != name || name.is_empty() || free_name(name, &self.teams) != name {
            return Err(format!("expected a name that nobody has, found {name:?}"));
        }
        let Some(door) = &mut self.door else {
            return Err("expected somebody to join where there is a door".into());
        };
        door.seats.push(Some(token));
        self.teams.push(name.to_owned());
        self.ballots
            .iter_mut()
            .for_each(|row| row.push(Ballot::default()));
        Ok(())
    }

    /// Gives somebody another name.
    pub(super) fn rename(&mut self, person: usize, name: &str) -> Result<(), String> {
        if self.renamed(person, name).as_deref() != Some(name) {
            return Err(format!("expected a name that nobody has, found {name:?}"));
        }
        match self.teams.get_mut(person) {
            Some(old) => name.clone_into(old),
            None => return Err(format!("expected one of {} people", self.teams.len())),
        }
        Ok(())
    }

    /// Removes somebody with all they said; they stay out until they are let in again.
    pub(super) fn remove(&mut self, person: usize) -> Result<(), String> {
        let removed = self.teams.get(person).map(|name| Removed {
            seat: self.token(person),
            name: name.clone(),
        });
        self.vacate(person)?;
        if let Some(door) = &mut self.door {
            door.removed.extend(removed);
            let surplus = door.removed.len().saturating_sub(self.way.most());
            door.removed.drain(..surplus);
        }
        Ok(())
    }

    /// Lets somebody come in again who was removed.
    pub(super) fn readmit(&mut self, removed: usize) -> Result<(), String> {
        let all = self.door.as_mut().map(|door| &mut door.removed);
        match all.filter(|all| removed < all.len()) {
            Some(all) => {
                all.remove(removed);
                Ok(())
            }
            None => Err("expected somebody who was removed".into()),
        }
    }

    /// Frees somebody's place, with all they said; they may come in again.
    pub(super) fn vacate(&mut self, person: usize) -> Result<(), String> {
        if person >= self.teams.len() {
            return Err(format!("expected one of {} people", self.teams.len()));
        }
        self.teams.remove(person);
        for row in &mut self.ballots {
            row.remove(person);
        }
        if let Some(door) = &mut self.door {
            door.seats.remove(person);
        }
        Ok(())
    }

    /// Makes one of two: somebody came back as a stranger. What the stranger said goes before
    /// what was said earlier, and their device keeps its place.
    pub(super) fn merge(&mut self, from: usize, into: usize) -> Result<(), String> {
        if from == into || from.max(into) >= self.teams.len() {
            return Err(format!("expected two of {} people", self.teams.len()));
        }
        for row in &mut self.ballots {
            let later = row[from];
            for vote in Vote::BOTH {
                if later.vote(vote).is_some() {
                    row[into].put(vote, later.given(vote));
                }
            }
        }
        if let Some(door) = &mut self.door {
            door.seats[into] = door.seats[from].or(door.seats[into]);
        }
        self.vacate(from)
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
    /// back. A vote that the question's form does not [accept](crate::quiz::Form::accepts) is
    /// not taken.
    pub fn vote(&mut self, question: usize, team: usize, vote: Vote, said: Option<Response>) {
        self.put(question, team, vote, said.map(Said::from));
    }

    /// The same with how sure they are; says whether it was taken.
    pub(super) fn put(
        &mut self,
        question: usize,
        team: usize,
        vote: Vote,
        said: Option<Said>,
    ) -> bool {
        let fits = |said: &Said| {
            let question = self.questions().get(question);
            question.is_some_and(|question| question.form.accepts(&said.response))
        };
        if said.as_ref().is_some_and(|said| !fits(said)) {
            return false;
        }
        let row = self.ballots.get_mut(question);
        let ballot = row.and_then(|row| row.get_mut(team));
        ballot.map(|ballot| ballot.put(vote, said)).is_some()
    }

    /// Whether somebody has voted on any question.
    pub fn has_voted(&self, person: usize) -> bool {
        let mut questions = 0..self.questions().len();
        questions.any(|question| self.ballot(question, person).counts().is_some())
    }

    /// The ballots on a question, one a team; none where there is no such question.
    fn ballots(&self, question: usize) -> impl Iterator<Item = &Ballot> {
        self.ballots.get(question).into_iter().flatten()
    }

    /// How many gave this vote on a question.
    pub fn voted(&self, question: usize, vote: Vote) -> usize {
        if self.way == WayOfVoting::Tally {
            let counts = self.tally(question, vote).unwrap_or_default();
            return counts.iter().map(|count| *count as usize).sum();
        }
        let given = self.ballots(question).filter_map(|it| it.vote(vote));
        given.count()
    }

    /// What those who have voted say to a question at a vote, as [`Ballot::said`]: one a team,
    /// or one a hand that was counted.
    pub fn said(&self, question: usize, vote: Vote) -> impl Iterator<Item = Response> {
        self.answers(question, vote).into_iter().map(|it| it.said)
    }

    /// The same as answers: with how sure they were, where that was asked.
    fn answers(&self, question: usize, vote: Vote) -> Vec<Answer> {
        match self.way {
            WayOfVoting::Tally => self.counted(question, vote).map(unsure).collect(),
            WayOfVoting::Teams | WayOfVoting::Devices => self
                .ballots(question)
                .filter_map(|it| it.answer(vote))
                .collect(),
        }
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
        let answers = self.answers(question, vote);
        answers.iter().map(|it| Clue::new(asked, it)).collect()
    }

    /// What the votes of a team say of misconceptions, one a question on which it has voted.
    pub fn clues_of(&self, team: usize, vote: Vote) -> Vec<Clue> {
        let asked = self.questions().iter().enumerate();
        let said = asked.filter_map(|(i, asked)| Some((asked, self.ballot(i, team).answer(vote)?)));
        said.map(|(asked, said)| Clue::new(asked, &said)).collect()
    }

    /// Whether anybody has voted at all.
    pub fn is_begun(&self) -> bool {
        (0..self.ballots.len()).any(|question| self.has_votes(question))
    }

    /// Questions on which anybody has voted, from the first on without a gap.
    pub fn begun(&self) -> usize {
        let empty = (0..self.ballots.len()).find(|question| !self.has_votes(*question));
        empty.unwrap_or(self.ballots.len())
    }

    fn has_votes(&self, question: usize) -> bool {
        let given = self.ballots(question).any(|it| it.counts().is_some());
        given
            || Vote::BOTH
                .iter()
                .any(|vote| self.tally(question, *vote).is_some())
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

/// The confidence of whom nobody asked; it changes nothing about the credit of a vote.
const UNSURE: Confidence = Confidence::ThinkSo;

/// A vote as an answer of whom nobody asked how sure they are.
fn unsure(said: Response) -> Answer {
    Answer::new(said, UNSURE)
}
