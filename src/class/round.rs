//! A round of a class: its participants, how they join, and all their votes.

use std::net::SocketAddrV4;
use std::sync::Arc;

use super::ballot::{Ballot, Said, Vote, unsure};
use super::device::Device;
use super::join_code::{JoinCode, SeatToken};
use super::names::{folded, free_name, tidy};
use super::nicknames;
use super::step::ClassPlace;
use super::way::WayOfVoting;
use crate::progress::Tally;
use crate::quiz::{Answer, Clue, Code, Diagnosis, Grade, Misconception, Question, Response, Round};

/// A participant: a team, or a pupil on their own device.
#[derive(Debug, Clone, PartialEq)]
pub struct Participant {
    name: String,
    /// The seat token; `None` for a team, or if no device has connected.
    pub(super) seat: Option<SeatToken>,
    /// One ballot per question.
    ballots: Vec<Ballot>,
    /// The device, which is not stored.
    pub(super) device: Device,
}

impl Participant {
    /// The name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Whether the device is connected.
    pub fn is_present(&self) -> bool {
        self.device.connection.is_some()
    }

    /// Whether a hand-in of this participant is stored.
    pub fn has_handed_in(&self) -> bool {
        self.device.has_handed_in
    }

    /// The votes on a question; empty if there is no such question.
    pub fn ballot(&self, question: usize) -> Ballot {
        self.ballots.get(question).copied().unwrap_or_default()
    }

    /// Whether this participant has no vote and has never handed anything in.
    pub(super) fn is_idle(&self) -> bool {
        !self.device.has_handed_in && self.ballots.iter().all(|it| it.counts().is_none())
    }
}

/// A round that a class plays, with all its votes.
#[derive(Debug, Clone, PartialEq)]
pub struct ClassRound {
    /// The questions, which never change.
    round: Arc<Round>,
    way: WayOfVoting,
    pub(super) participants: Vec<Participant>,
    /// For each question, the counts of both votes, one per choice; empty if nothing was counted.
    pub(super) tallies: Vec<[Vec<u32>; 2]>,
    /// How pupils join on their own devices; `None` while joining is closed.
    pub(super) joining: Option<Joining>,
    place: ClassPlace,
    /// The name of the class; may be empty.
    class: String,
    /// Whether carrom gives nicknames to pupils' devices instead of asking for names.
    nicknames: bool,
    /// The number of votes that were dropped when the file was read, because they did not fit their
    /// questions.
    pub(super) dropped: usize,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Joining {
    pub(super) code: JoinCode,
    /// The address at which pupils' devices last found the round.
    pub(super) address: Option<SocketAddrV4>,
    /// The participants who were removed and have not been readmitted.
    pub(super) removed: Vec<Removed>,
}

/// A removed participant: the seat token, if a device had connected, and the name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Removed {
    pub(super) seat: Option<SeatToken>,
    pub(super) name: String,
}

impl ClassRound {
    /// A round of these teams in which nobody has voted yet. The names are those that
    /// [`team_names`](super::team_names) returned.
    pub fn new(code: Code, teams: Vec<String>) -> Self {
        let mut round = Self::voting(WayOfVoting::Teams, code);
        teams
            .into_iter()
            .for_each(|name| round.seat_new(name, None));
        round
    }

    /// A round in which hands or cards are counted.
    pub fn with_tally(code: Code) -> Self {
        Self::voting(WayOfVoting::Tally, code)
    }

    /// A round on pupils' own devices, which nobody has joined yet.
    pub fn with_devices(code: Code) -> Self {
        Self::voting(WayOfVoting::Devices, code)
    }

    /// A round without participants.
    pub(super) fn voting(way: WayOfVoting, code: Code) -> Self {
        let round = Round::of(code);
        Self {
            tallies: vec![Default::default(); round.questions().len()],
            round: Arc::new(round),
            way,
            participants: Vec::new(),
            joining: None,
            place: ClassPlace::default(),
            class: String::new(),
            nicknames: false,
            dropped: 0,
        }
    }

    /// Adds a participant at the end.
    pub(super) fn seat_new(&mut self, name: String, seat: Option<SeatToken>) {
        self.participants.push(Participant {
            name,
            seat,
            ballots: vec![Ballot::default(); self.questions().len()],
            device: Device::default(),
        });
    }

    /// Sets the name of the class, which is tidied and may be empty.
    #[must_use]
    pub fn of_class(self, name: &str) -> Self {
        let class = tidy(name);
        Self { class, ..self }
    }

    /// Sets whether carrom gives nicknames to pupils' devices instead of asking for names.
    #[must_use]
    pub fn with_nicknames(self, nicknames: bool) -> Self {
        Self { nicknames, ..self }
    }

    /// Whether carrom gives nicknames to pupils' devices.
    pub fn gives_nicknames(&self) -> bool {
        self.nicknames
    }

    /// The name of the class; may be empty.
    pub fn class(&self) -> &str {
        &self.class
    }

    /// Whether this is the name of the class, once tidied.
    pub fn is_of_class(&self, name: &str) -> bool {
        self.class == tidy(name)
    }

    /// The number of votes that were dropped when the file was read, because they did not fit their
    /// questions.
    pub fn dropped_votes(&self) -> usize {
        self.dropped
    }

    /// How the class votes.
    pub fn way(&self) -> WayOfVoting {
        self.way
    }

    /// The code for joining on devices, while pupils can join.
    pub fn join_code(&self) -> Option<JoinCode> {
        self.joining.as_ref().map(|joining| joining.code)
    }

    /// The address at which pupils' devices last found the round and will look for it again.
    pub fn address(&self) -> Option<SocketAddrV4> {
        self.joining.as_ref()?.address
    }

    /// Lets pupils join, with this code and at this address. An existing code is kept.
    pub fn open(&mut self, code: JoinCode, address: Option<SocketAddrV4>) {
        let joining = self.joining.get_or_insert(Joining {
            code,
            address,
            removed: Vec::new(),
        });
        joining.address = address;
    }

    /// Stops pupils from joining and forgets all seat tokens; names and votes are kept.
    pub fn close(&mut self) {
        self.joining = None;
        self.participants.iter_mut().for_each(|it| it.seat = None);
    }

    /// The index of the participant with this token, counted from 0.
    pub fn seat(&self, token: SeatToken) -> Option<usize> {
        let mut all = self.participants.iter();
        all.position(|it| it.seat == Some(token))
    }

    /// The names of the participants who were removed and have not been readmitted.
    pub fn removed(&self) -> impl Iterator<Item = &str> {
        let removed = self.joining.iter().flat_map(|joining| &joining.removed);
        removed.map(|it| it.name.as_str())
    }

    /// Whether a participant with this token or name was removed and has not been readmitted.
    pub fn is_removed(&self, token: Option<SeatToken>, name: &str) -> bool {
        let name = folded(&tidy(name));
        let mut removed = self.joining.iter().flat_map(|joining| &joining.removed);
        removed.any(|it| {
            let is_same_device = token.is_some() && it.seat == token;
            is_same_device || folded(&it.name) == name
        })
    }

    /// A new name for a participant, tidied; `None` if no visible letter is left, or if the name is
    /// taken.
    pub fn renamed(&self, person: usize, name: &str) -> Option<String> {
        let name = tidy(name);
        let mut others = self.participants.iter().enumerate();
        let taken = others.any(|(i, other)| i != person && folded(&other.name) == folded(&name));
        (!name.is_empty() && !taken).then_some(name)
    }

    /// The name that a newcomer with this name would get: tidied, and with a number if it is taken;
    /// `None` if no visible letter is left.
    pub fn name_for(&self, name: &str) -> Option<String> {
        let name = tidy(name);
        (!name.is_empty()).then(|| free_name(&name, &self.teams()))
    }

    /// The name that a newcomer with this token gets if they ask for this name: a nickname, if
    /// the round gives nicknames.
    pub(super) fn newcomers_name(&self, name: &str, token: SeatToken) -> Option<String> {
        if !self.nicknames {
            return self.name_for(name);
        }
        let is_taken = |it: &str| {
            let is_used = self.participants.iter().any(|other| other.name == it);
            is_used || self.is_removed(None, it)
        };
        self.name_for(&nicknames::for_device(name, token, is_taken))
    }

    fn participant(&mut self, person: usize) -> Result<&mut Participant, String> {
        let count = self.participants.len();
        let found = self.participants.get_mut(person);
        found.ok_or_else(|| format!("expected one of {count} participants"))
    }

    /// Adds a participant with a unique name. A seat token is accepted only while pupils can join.
    pub(super) fn join(&mut self, name: &str, seat: Option<SeatToken>) -> Result<(), String> {
        if self.participants.len() >= self.way.most() {
            return Err(format!("expected at most {} participants", self.way.most()));
        }
        if self.name_for(name).as_deref() != Some(name) {
            return Err(format!("expected a name that is not taken, found {name:?}"));
        }
        if self.joining.is_none() && seat.is_some() {
            return Err("expected a round that pupils can join".into());
        }
        self.seat_new(name.to_owned(), seat);
        Ok(())
    }

    pub(super) fn rename(&mut self, person: usize, name: &str) -> Result<(), String> {
        if self.renamed(person, name).as_deref() != Some(name) {
            return Err(format!("expected a name that is not taken, found {name:?}"));
        }
        self.participant(person)?.name = name.to_owned();
        Ok(())
    }

    /// Removes a participant and all their votes; they can rejoin only after being readmitted.
    pub(super) fn remove(&mut self, person: usize) -> Result<(), String> {
        let Participant { seat, name, .. } = self.participant(person)?.clone();
        self.vacate(person)?;
        if let Some(joining) = &mut self.joining {
            joining.removed.push(Removed { seat, name });
            let surplus = joining.removed.len().saturating_sub(self.way.most());
            joining.removed.drain(..surplus);
        }
        Ok(())
    }

    /// Lets a removed participant join again.
    pub(super) fn readmit(&mut self, removed: usize) -> Result<(), String> {
        let all = self.joining.as_mut().map(|joining| &mut joining.removed);
        match all.filter(|all| removed < all.len()) {
            Some(all) => {
                all.remove(removed);
                Ok(())
            }
            None => Err("expected a participant who was removed".into()),
        }
    }

    /// Frees a participant's seat and deletes their votes; they may join again.
    pub(super) fn vacate(&mut self, person: usize) -> Result<(), String> {
        self.participant(person)?;
        self.participants.remove(person);
        Ok(())
    }

    /// Merges two entries of a participant who joined twice. The votes of the duplicate replace
    /// earlier ones, and its device keeps the seat.
    pub(super) fn merge(&mut self, from: usize, into: usize) -> Result<(), String> {
        let people = self.participants.len();
        if from == into || from.max(into) >= people {
            return Err(format!("expected two of {people} participants"));
        }
        let stranger = self.participants[from].clone();
        let one = &mut self.participants[into];
        for (ballot, later) in one.ballots.iter_mut().zip(&stranger.ballots) {
            for vote in Vote::BOTH {
                ballot.put(vote, later.given(vote).or(ballot.given(vote)));
            }
        }
        one.seat = stranger.seat.or(one.seat);
        one.device = stranger.device.or_earlier(&one.device);
        self.vacate(from)
    }

    /// The code that determines the questions.
    pub fn code(&self) -> &Code {
        self.round.code()
    }

    /// The questions in order.
    pub fn questions(&self) -> &[Question] {
        self.round.questions()
    }

    /// The participants, in the order in which they joined.
    pub fn participants(&self) -> &[Participant] {
        &self.participants
    }

    /// The names of the teams, or of the people.
    pub fn teams(&self) -> Vec<&str> {
        self.participants.iter().map(Participant::name).collect()
    }

    /// The name of a participant; empty if there is none.
    pub fn name_of(&self, person: usize) -> &str {
        self.participants.get(person).map_or("", Participant::name)
    }

    /// The current position in the round.
    pub fn place(&self) -> ClassPlace {
        self.place
    }

    /// Goes to a position in the round, unless it is after the last question.
    pub fn go(&mut self, place: ClassPlace) {
        if place.question < self.questions().len() {
            self.place = place;
        }
    }

    /// The votes of a team on a question, both counted from 0; empty if there is no such team or
    /// question.
    pub fn ballot(&self, question: usize, team: usize) -> Ballot {
        let team = self.participants.get(team);
        team.map(|it| it.ballot(question)).unwrap_or_default()
    }

    /// Sets a team's vote on a question, replacing an earlier one; `None` withdraws it. A vote that
    /// the question's form does not [accept](crate::quiz::Form::accepts) is ignored.
    pub fn vote(&mut self, question: usize, team: usize, vote: Vote, said: Option<Response>) {
        self.put(question, team, vote, said.map(Said::from));
    }

    /// Like [`Self::vote`], with the confidence; returns whether the vote was accepted.
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
        let team = self.participants.get_mut(team);
        let ballot = team.and_then(|it| it.ballots.get_mut(question));
        ballot.map(|ballot| ballot.put(vote, said)).is_some()
    }

    /// The ballots on a question, one per team; none if there is no such question.
    fn ballots(&self, question: usize) -> impl Iterator<Item = &Ballot> {
        let all = self.participants.iter();
        all.filter_map(move |it| it.ballots.get(question))
    }

    /// The number of voters who gave this vote on a question.
    pub fn voted(&self, question: usize, vote: Vote) -> usize {
        if self.way == WayOfVoting::Tally {
            let counts = self.tally(question, vote).unwrap_or_default();
            return counts.iter().map(|count| *count as usize).sum();
        }
        let given = self.ballots(question).filter_map(|it| it.vote(vote));
        given.count()
    }

    /// The answers to a question in a vote, as [`Ballot::said`] returns them: one per team, or one
    /// per counted hand.
    pub fn said(&self, question: usize, vote: Vote) -> impl Iterator<Item = Response> {
        self.answers(question, vote).into_iter().map(|it| it.said)
    }

    /// Like [`Self::said`], but as [`Answer`]s, including the confidence of voters who were asked
    /// for it.
    fn answers(&self, question: usize, vote: Vote) -> Vec<Answer> {
        match self.way {
            WayOfVoting::Tally => self.counted(question, vote).map(unsure).collect(),
            WayOfVoting::Teams | WayOfVoting::Devices => self
                .ballots(question)
                .filter_map(|it| it.answer(vote))
                .collect(),
        }
    }

    /// The results of a vote.
    pub fn results(&self, question: usize, vote: Vote) -> Tally {
        let said = self.said(question, vote);
        Tally::of_grades(said.filter_map(|said| self.grade(question, Some(said))))
    }

    /// The misconceptions that the answers in a vote fit, each with the answer that fits it.
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

    /// The evidence for misconceptions in the votes on a question, one item per team that has
    /// voted or per counted hand.
    pub fn clues(&self, question: usize, vote: Vote) -> Vec<Clue> {
        let Some(asked) = self.questions().get(question) else {
            return Vec::new();
        };
        let answers = self.answers(question, vote);
        answers.iter().map(|it| Clue::new(asked, it)).collect()
    }

    /// The evidence for misconceptions in a team's votes, one item per question on which it has
    /// voted.
    pub fn clues_of(&self, team: usize, vote: Vote) -> Vec<Clue> {
        let asked = self.questions().iter().enumerate();
        let said = asked.filter_map(|(i, asked)| Some((asked, self.ballot(i, team).answer(vote)?)));
        said.map(|(asked, said)| Clue::new(asked, &said)).collect()
    }

    /// Whether anybody has voted at all.
    pub fn is_begun(&self) -> bool {
        (0..self.questions().len()).any(|question| self.has_votes(question))
    }

    /// The number of questions before the first one without votes.
    pub fn begun(&self) -> usize {
        let empty = (0..self.questions().len()).find(|question| !self.has_votes(*question));
        empty.unwrap_or(self.questions().len())
    }

    fn has_votes(&self, question: usize) -> bool {
        let given = self.ballots(question).any(|it| it.counts().is_some());
        given
            || Vote::BOTH
                .iter()
                .any(|vote| self.tally(question, *vote).is_some())
    }

    /// The grade of a vote; `None` if there is no vote.
    pub fn grade(&self, question: usize, said: Option<Response>) -> Option<Grade> {
        let question = self.questions().get(question)?;
        Some(Grade::new(question, &unsure(said?)))
    }

    /// The misconception that a vote fits.
    pub fn diagnose(&self, question: usize, said: Option<Response>) -> Option<Diagnosis> {
        self.questions().get(question)?.diagnose(&unsure(said?))
    }

    /// A team's points for a question, from 0 to [`Grade::MOST`], according to how close its vote
    /// is. Teams are not asked how sure they are.
    pub fn points(&self, question: usize, team: usize) -> f64 {
        let said = self.ballot(question, team).counts();
        let credit = self.grade(question, said).map_or(0.0, |grade| grade.credit);
        Grade::MOST * credit
    }
}
