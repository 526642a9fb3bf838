//! A round of a class: all its votes, and every change to it.

use std::net::SocketAddrV4;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::ballot::{Ballot, Said, Vote, unsure};
use super::device::Device;
use super::join_code::{JoinCode, SeatToken};
use super::names::tidy;
use super::step::ClassPlace;
use super::way::WayOfVoting;
use crate::progress::Tally;
use crate::quiz::{Answer, Clue, Code, Grade, Misconception, Question, Response, Round};

/// A participant: a team, or a pupil on their own device.
#[derive(Debug, Clone, PartialEq)]
pub struct Participant {
    pub(super) name: String,
    /// The token of the device that holds the seat; `None` if no device does.
    pub(super) seat: Option<SeatToken>,
    /// One ballot per question.
    pub(super) ballots: Vec<Ballot>,
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

    /// Whether a hand-in of this participant was saved in this session.
    pub fn has_handed_in(&self) -> bool {
        self.device.has_handed_in
    }

    /// The votes on a question; empty if there is no such question.
    pub fn ballot(&self, question: usize) -> Ballot {
        self.ballots.get(question).copied().unwrap_or_default()
    }

    /// Whether this participant has no vote and has had no hand-in saved in this session.
    pub(super) fn is_idle(&self) -> bool {
        !self.device.has_handed_in && self.ballots.iter().all(|it| it.counts().is_none())
    }
}

/// A change in a round. Questions, people and choices are counted from 0.
///
/// The file of a round begins with the state at the time of the last complete write. Later changes
/// are appended, so the file is not rewritten for each of 250 votes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum ClassChange {
    /// A vote was given or withdrawn.
    Vote {
        /// The question.
        question: usize,
        /// The first or the second vote.
        vote: Vote,
        /// The voter.
        person: usize,
        /// The vote.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        said: Option<Said>,
    },
    /// Hands were counted, or the count was withdrawn.
    Count {
        /// The question.
        question: usize,
        /// The first or the second vote.
        vote: Vote,
        /// The number of votes for each choice.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        counts: Option<Vec<u32>>,
    },
    /// A participant joined and was added at the end of the list.
    Join {
        /// Their seat token, if they have a device.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        seat: Option<SeatToken>,
        /// Their name, which must be unique.
        name: String,
    },
    /// A participant was renamed.
    Rename {
        /// The participant.
        person: usize,
        /// Their new name.
        name: String,
    },
    /// A participant and all their votes were removed; later participants' indices shift by one.
    Remove {
        /// The participant.
        person: usize,
    },
    /// A removed participant may join again.
    Readmit {
        /// Their index among the removed participants.
        removed: usize,
    },
    /// A participant's seat was freed, and they may rejoin; later participants' indices shift.
    Vacate {
        /// The participant.
        person: usize,
    },
    /// A participant had joined twice.
    Merge {
        /// The duplicate, which is removed.
        from: usize,
        /// The original participant.
        into: usize,
    },
}

impl ClassChange {
    /// The line of JSON that stores the change.
    pub fn line(&self) -> String {
        // Every field can be written as JSON.
        serde_json::to_string(self).unwrap_or_default()
    }

    /// Reads a change from its line.
    ///
    /// # Errors
    /// The reason, if the line is not a change.
    pub fn read(line: &str) -> Result<Self, String> {
        serde_json::from_str(line).map_err(|error| format!("expected a change: {error}"))
    }

    /// Whether a line is a vote, valid or not.
    pub(super) fn is_vote(line: &str) -> bool {
        line.starts_with("{\"vote\":")
    }
}

/// A change in a file: one line of JSON.
#[derive(Serialize)]
pub(super) struct Then {
    change: String,
}

impl From<&ClassChange> for Then {
    fn from(change: &ClassChange) -> Self {
        let change = change.line();
        Self { change }
    }
}

/// The text that is appended to the file of a round for these changes.
///
/// # Errors
/// The reason if it cannot be written, which does not happen in practice.
pub fn appended(changes: &[ClassChange]) -> Result<String, String> {
    #[derive(Serialize)]
    struct Appended {
        then: Vec<Then>,
    }
    let then = changes.iter().map(Then::from).collect();
    toml::to_string(&Appended { then }).map_err(|error| error.to_string())
}

/// A round that a class plays, with all its votes.
#[derive(Debug, Clone, PartialEq)]
pub struct ClassRound {
    /// The questions, which never change.
    round: Arc<Round>,
    pub(super) way: WayOfVoting,
    pub(super) participants: Vec<Participant>,
    /// For each question, the counts of both votes, one per choice; empty if nothing was counted.
    pub(super) tallies: Vec<[Vec<u32>; 2]>,
    /// How pupils join on their own devices; `None` while joining is closed.
    pub(super) joining: Option<Joining>,
    place: ClassPlace,
    /// The name of the class; may be empty.
    class: String,
    /// Whether carrom gives nicknames to pupils' devices instead of asking for names.
    pub(super) nicknames: bool,
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

    /// Adds a participant to the end of the list.
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

    /// Applies a change.
    ///
    /// # Errors
    /// The reason, if the change does not fit the round; the round then stays unchanged.
    pub fn change(&mut self, change: &ClassChange) -> Result<(), String> {
        let taken = |taken: bool, expected: &str| match taken {
            true => Ok(()),
            false => Err(format!("expected {expected}, found {}", change.line())),
        };
        match change {
            ClassChange::Vote {
                question,
                vote,
                person,
                said,
            } => {
                let put = self.put(*question, *person, *vote, *said);
                taken(put, "a participant's vote on one of its questions")
            }
            ClassChange::Count {
                question,
                vote,
                counts,
            } => {
                let put = self.count(*question, *vote, counts.as_deref());
                taken(put, "a count for each choice of one of its questions")
            }
            ClassChange::Join { seat, name } => self.join(name, *seat),
            ClassChange::Rename { person, name } => self.rename(*person, name),
            ClassChange::Remove { person } => self.remove(*person),
            ClassChange::Readmit { removed } => self.readmit(*removed),
            ClassChange::Vacate { person } => self.vacate(*person),
            ClassChange::Merge { from, into } => self.merge(*from, *into),
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

    /// The answers to a question in a vote, as [`Ballot::said`] returns them: one per team that
    /// has voted, or one per counted hand.
    pub fn said(&self, question: usize, vote: Vote) -> impl Iterator<Item = Response> {
        self.answers(question, vote).into_iter().map(|it| it.said)
    }

    /// How often an answer was given in a vote.
    pub fn votes_for(&self, question: usize, vote: Vote, said: Response) -> usize {
        self.said(question, vote).filter(|it| *it == said).count()
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
            let misconception = self.diagnose(question, Some(said))?;
            Some((misconception, said))
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
        let mut votes = Vote::BOTH.into_iter();
        given || votes.any(|vote| self.tally(question, vote).is_some())
    }

    /// The grade of a vote; `None` if there is no vote.
    pub fn grade(&self, question: usize, said: Option<Response>) -> Option<Grade> {
        let question = self.questions().get(question)?;
        Some(Grade::new(question, &unsure(said?)))
    }

    /// The misconception that a vote fits.
    pub fn diagnose(&self, question: usize, said: Option<Response>) -> Option<Misconception> {
        let question = self.questions().get(question)?;
        let (belief, _) = question.belief_of(&unsure(said?))?;
        Some(belief.misconception)
    }

    /// A team's points for a question, from 0 to [`Grade::MOST`], according to how close its vote
    /// is. How sure the voter is makes no difference.
    pub fn points(&self, question: usize, team: usize) -> f64 {
        let said = self.ballot(question, team).counts();
        let credit = self.grade(question, said).map_or(0.0, |grade| grade.credit);
        Grade::MOST * credit
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_read_back_as_written() {
        let seat = SeatToken::of(7);
        for line in [
            r#"{"vote":{"question":2,"vote":"first","person":16,"said":"rays -0.5 still"}}"#,
            r#"{"vote":{"question":2,"vote":"second","person":16,"said":"sure choice 2"}}"#,
            r#"{"vote":{"question":2,"vote":"first","person":0}}"#,
            r#"{"count":{"question":0,"vote":"first","counts":[4,17,9,2]}}"#,
            r#"{"count":{"question":0,"vote":"second"}}"#,
            &format!(r#"{{"join":{{"seat":"{seat}","name":"Ada Lovelace"}}}}"#),
            r#"{"join":{"name":"Ants"}}"#,
            r#"{"rename":{"person":2,"name":"Bo  <b>"}}"#,
            r#"{"remove":{"person":249}}"#,
            r#"{"readmit":{"removed":0}}"#,
            r#"{"vacate":{"person":249}}"#,
            r#"{"merge":{"from":3,"into":0}}"#,
        ] {
            let change = ClassChange::read(line).unwrap_or_else(|it| panic!("{line}: {it}"));
            assert_eq!(change.line(), line);
        }
        for line in [
            "",
            "vote 1 first 1",
            r#"{"vote":{"question":-1,"vote":"first","person":0}}"#,
            r#"{"vote":{"question":0,"vote":"third","person":0}}"#,
            r#"{"vote":{"question":0,"vote":"first","person":0,"said":"rays"}}"#,
            r#"{"vote":{"question":0,"vote":"first","person":0,"sad":"rays 1 2"}}"#,
            r#"{"count":{"question":0,"vote":"first","counts":["x"]}}"#,
            r#"{"join":{"seat":"12","name":"Ada"}}"#,
            r#"{"merge":{"from":1}}"#,
            r#"{"leave":{"person":1}}"#,
        ] {
            assert!(ClassChange::read(line).is_err(), "{line}");
        }
    }
}
