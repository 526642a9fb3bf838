//! How participants join and leave a round, and their names.

use std::net::SocketAddrV4;

use super::ballot::Vote;
use super::join_code::{JoinCode, SeatToken};
use super::names::{folded, free_name, tidy};
use super::nicknames;
use super::round::{ClassRound, Joining, Participant, Removed};

impl ClassRound {
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
        let all = all.filter(|all| removed < all.len());
        all.ok_or("expected a participant who was removed")?
            .remove(removed);
        Ok(())
    }

    /// Frees a participant's seat and deletes their votes; they may join again.
    pub(super) fn vacate(&mut self, person: usize) -> Result<(), String> {
        self.participant(person)?;
        self.participants.remove(person);
        Ok(())
    }

    /// Merges two entries of a participant who joined twice. The votes of the duplicate replace
    /// earlier ones, and its device takes the seat.
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
}
