//! A round in progress: the step, the participants and their votes and, on devices, the state sent
//! to each.
//!
//! No vote is confirmed before an attempt to save it: changes are collected, saved together, and
//! then reported to the participants concerned.

use std::collections::BTreeSet;
use std::net::IpAddr;
use std::sync::Arc;
use std::time::Duration;

use serde_json::Value;

use super::ballot::{Said, Vote};
use super::device::ConnectionId;
use super::host::{HostCall, HostNews, JoinDetails, Newcomer};
use super::limits::{Addresses, NEW_SEATS};
use super::protocol::{ClientMessage, HandedIn, NotTaken, PupilStep, Refusal};
use super::pupil_view::PupilView;
use super::round::{ClassChange, ClassRound, Participant};
use super::step::{ClassPlace, ClassStep};
use super::way::WayOfVoting;
use crate::gradebook::HandIn;

/// How long the screen waits for the first pupil before it shows what may prevent pupils
/// from joining.
const PATIENCE: Duration = Duration::from_secs(60);
/// How many times a pupil may hand in during a session.
const MOST_HAND_INS: usize = 20;
/// The largest total size of the hand-ins of a session, in bytes.
const MOST_BYTES: usize = 1 << 26;

/// A round that is being played.
#[derive(Debug, Clone)]
pub struct Session {
    round: Arc<ClassRound>,
    /// Whether the last question is over.
    over: bool,
    /// Whether the class is still gathering.
    gathers: bool,
    /// How pupils can join, or the reason why they cannot; `None` while the server is starting.
    hosting: Option<Result<JoinDetails, String>>,
    /// Whether the round is closed to newcomers.
    shut: bool,
    /// Whether the round has a file: a round that nobody has joined needs none.
    has_file: bool,
    keeping: Keeping,
    /// The total size of the hand-ins so far, in bytes, and their folder.
    handed_bytes: usize,
    handed_in_where: Option<String>,
    /// The seats that newcomers may still take.
    new_seats: Addresses,
    /// How long pupils have been able to join without anybody joining.
    waited: Duration,
    effects: Vec<SessionEffect>,
}

/// The changes that are being saved, and the connections that wait for them.
#[derive(Debug, Clone, Default)]
struct Keeping {
    /// Changes that are not yet in a request to save, and the connections they came from.
    changes: Vec<ClassChange>,
    later: BTreeSet<ConnectionId>,
    /// The number of requests in progress, and the connections to notify when they are done.
    asked: usize,
    waiting: BTreeSet<ConnectionId>,
}

/// A request from a session.
#[derive(Debug, Clone, PartialEq)]
pub enum SessionEffect {
    /// A request to the server of the class.
    Host(HostCall),
    /// Save the current state of the round.
    Save(Arc<ClassRound>),
    /// Save these changes; the round is the state after them.
    Note(Vec<ClassChange>, Arc<ClassRound>),
    /// Save a hand-in.
    KeepHandIn(HandInOnItsWay, Box<HandIn>),
    /// Show the teacher a notice.
    Tell(String),
}

/// A hand-in that is being saved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct HandInOnItsWay {
    connection: ConnectionId,
    n: u64,
    answers: usize,
}

impl Session {
    /// Continues a round, and requests a server if it needs one.
    pub fn new(round: ClassRound) -> Self {
        let is_hosted = round.way() == WayOfVoting::Devices;
        let open = is_hosted.then(|| HostCall::Open {
            code: round.join_code(),
            address: round.address(),
        });
        Self {
            over: false,
            gathers: is_hosted,
            hosting: None,
            shut: false,
            has_file: round.join_code().is_some() || round.is_begun(),
            keeping: Keeping::default(),
            handed_bytes: 0,
            handed_in_where: None,
            new_seats: Addresses::new(NEW_SEATS),
            waited: Duration::ZERO,
            effects: open.into_iter().map(SessionEffect::Host).collect(),
            round: Arc::new(round),
        }
    }

    /// The current state of the round.
    pub fn round(&self) -> &ClassRound {
        &self.round
    }

    /// The round, shared for saving.
    pub fn shared_round(&self) -> Arc<ClassRound> {
        Arc::clone(&self.round)
    }

    fn round_mut(&mut self) -> &mut ClassRound {
        Arc::make_mut(&mut self.round)
    }

    /// The requests since the last call.
    pub fn take_effects(&mut self) -> Vec<SessionEffect> {
        std::mem::take(&mut self.effects)
    }

    fn host(&mut self, call: HostCall) {
        self.effects.push(SessionEffect::Host(call));
    }

    fn refuse(&mut self, connection: Option<ConnectionId>, why: Refusal) {
        if let Some(connection) = connection {
            self.host(HostCall::Refuse(connection, why));
        }
    }

    /// Whether everyone votes on their own device.
    pub fn is_hosted(&self) -> bool {
        self.round.way() == WayOfVoting::Devices
    }

    /// Whether the class is still gathering.
    pub fn gathers(&self) -> bool {
        self.gathers
    }

    /// How pupils can join, or the reason why they cannot; `None` while the server is starting.
    pub fn hosting(&self) -> Option<&Result<JoinDetails, String>> {
        self.hosting.as_ref()
    }

    /// Whether the round is closed to newcomers.
    pub fn is_shut(&self) -> bool {
        self.shut
    }

    /// Closes the round to newcomers, or opens it again.
    pub fn turn_key(&mut self) {
        self.shut = !self.shut;
    }

    /// The folder of the hand-ins, once there are any.
    pub fn handed_in_where(&self) -> Option<&str> {
        self.handed_in_where.as_deref()
    }

    /// The number of participants who are connected now.
    pub fn present(&self) -> usize {
        let all = self.round.participants().iter();
        all.filter(|it| it.is_present()).count()
    }

    /// The number of participants with a hand-in saved in this session.
    pub fn handed_in(&self) -> usize {
        let all = self.round.participants().iter();
        all.filter(|it| it.has_handed_in()).count()
    }

    /// The participants who are away, have no vote and have had no hand-in saved in this session.
    pub fn away(&self) -> Vec<usize> {
        let all = self.round.participants().iter().enumerate();
        let away = all.filter(|(_, it)| !it.is_present() && it.is_idle());
        away.map(|(person, _)| person).collect()
    }

    /// "27 of 32 have voted". The total consists of everyone who is connected, and of those who
    /// have voted but are away.
    pub fn turnout(&self, vote: Vote) -> String {
        let question = self.round.place().question;
        let voted = |it: &Participant| it.ballot(question).said(vote).is_some();
        let all = self.round.participants().iter();
        let all = all.filter(|it| it.is_present() || voted(it)).count();
        let count = self.round.voted(question, vote);
        match vote {
            Vote::First => format!("{count} of {all} have voted"),
            Vote::Second => format!("{count} of {all} have voted again"),
        }
    }

    /// The number of questions with points: the earlier ones, the current one once its scores are
    /// shown, and at the end all of them.
    pub fn with_points(&self) -> usize {
        let ClassPlace { question, step } = self.round.place();
        match step {
            _ if self.over => self.round.questions().len(),
            ClassStep::Scores => question + 1,
            _ => question,
        }
    }

    /// The phase, as pupils see it.
    fn step(&self) -> PupilStep {
        match () {
            () if self.gathers => PupilStep::Lobby,
            () if self.over => PupilStep::End,
            () => PupilStep::Asked(self.round.place().step),
        }
    }

    /// The vote that is open.
    pub fn open_vote(&self) -> Option<Vote> {
        self.step().vote()
    }

    /// Goes to a position in the round, and notifies everybody.
    pub fn go(&mut self, place: ClassPlace) {
        self.over = false;
        self.round_mut().go(place);
        self.save();
        self.moved();
    }

    /// Goes to the end, and notifies everybody.
    pub fn end(&mut self) {
        self.over = true;
        self.moved();
    }

    /// Begins the round once the class has gathered.
    pub fn begin(&mut self) {
        if std::mem::take(&mut self.gathers) {
            self.moved();
        }
    }

    /// Disconnects the pupils; if the round is over, they cannot return.
    pub fn close(&mut self) {
        if !self.is_hosted() {
            return;
        }
        self.host(HostCall::Close);
        if self.over {
            self.round_mut().close();
            self.save();
        }
    }

    /// Sets or withdraws a team's vote or a count, as the teacher enters it; returns whether it
    /// fits.
    pub fn enter(&mut self, change: &ClassChange) -> bool {
        let fits = self.round_mut().change(change).is_ok();
        self.save();
        fits
    }

    /// Handles news from the class.
    pub fn take_news(&mut self, news: &[HostNews]) {
        for it in news {
            match it {
                HostNews::Opened(opened) => self.opened(opened),
                HostNews::Came(newcomer) => match self.place_for(newcomer) {
                    Ok((person, is_new)) => self.seat(person, newcomer, is_new),
                    Err(why) => self.refuse(Some(newcomer.connection), why),
                },
                HostNews::Said(connection, ClientMessage::Vote { q, vote, said, n }) => {
                    self.voted(*connection, (*q, *vote), said, *n);
                }
                HostNews::Said(connection, ClientMessage::HandIn { n, file }) => {
                    self.hand_in(*connection, *n, file);
                }
                // A pupil who has joined has a seat already.
                HostNews::Said(_, ClientMessage::Join { .. }) => {}
                HostNews::Said(connection, ClientMessage::Leave) | HostNews::Gone(connection) => {
                    if let Some(person) = self.person(*connection) {
                        self.participant(person).device.connection = None;
                    }
                }
            }
        }
        self.go_on();
    }

    fn opened(&mut self, opened: &Result<JoinDetails, String>) {
        self.hosting = Some(opened.clone());
        let Ok(details) = opened else { return };
        let address = details.addresses.first().copied();
        let before = self.round.address().filter(|it| Some(*it) != address);
        if let (Some(before), Some(now)) = (before, address) {
            self.effects.push(SessionEffect::Tell(format!(
                "This round was at {before} and is now at {now}. Devices cannot reconnect by \
                 themselves: ask your pupils to open the new address."
            )));
        }
        self.round_mut().open(details.code, address);
        self.save();
    }

    /// The index of the participant who has this connection.
    fn person(&self, connection: ConnectionId) -> Option<usize> {
        let mut all = self.round.participants().iter();
        all.position(|it| it.device.connection == Some(connection))
    }

    fn participant(&mut self, person: usize) -> &mut Participant {
        &mut self.round_mut().participants[person]
    }

    /// The seat of a participant, and whether it is new.
    fn place_for(&mut self, newcomer: &Newcomer) -> Result<(usize, bool), Refusal> {
        let Newcomer { address, at, .. } = *newcomer;
        if let Some(person) = newcomer.seat.and_then(|seat| self.round.seat(seat)) {
            return Ok((person, false));
        }
        if self.round.is_removed(newcomer.seat, &newcomer.name) {
            return Err(Refusal::Kicked);
        }
        if self.shut || self.step() == PupilStep::End {
            return Err(Refusal::Closed);
        }
        if !self.new_seats.has_one(address, at) {
            return Err(Refusal::Later);
        }
        let name = self.round.newcomers_name(&newcomer.name, newcomer.fresh);
        let name = name.ok_or(Refusal::Name)?;
        if self.round.participants().len() >= self.round.way().most() {
            let person = self.who_gives_way(address).ok_or(Refusal::Full)?;
            self.change_people(&ClassChange::Vacate { person });
        }
        let seat = Some(newcomer.fresh);
        self.change(ClassChange::Join { seat, name })
            .map_err(|_| Refusal::Full)?;
        self.new_seats.take(address, at);
        Ok((self.round.participants().len() - 1, true))
    }

    /// Connects a device to a seat and disconnects the previous one.
    fn seat(&mut self, person: usize, newcomer: &Newcomer, is_new: bool) {
        let connection = newcomer.connection;
        let device = &mut self.participant(person).device;
        device.rev = 0;
        device.address = Some(newcomer.address);
        let before = device.connection.replace(connection);
        self.refuse(before, Refusal::Elsewhere);
        match is_new {
            true => self.keeping.wait_for_changes(connection),
            false => self.keeping.wait(connection),
        }
    }

    /// In a full class, the person whose seat goes to a newcomer from this address. Only a
    /// participant who has no vote and has had no hand-in saved in this session loses a seat: one
    /// who is away or, if there is none, one whose address differs from the newcomer's and has more
    /// than half of all seats, because those may belong to a single device. Of several candidates,
    /// the last to join from the address with the most seats loses the seat.
    fn who_gives_way(&self, address: IpAddr) -> Option<usize> {
        let people = self.round.participants();
        let held = |by: &Participant| {
            let addresses = people.iter().map(|it| it.device.address);
            addresses.filter(|it| *it == by.device.address).count()
        };
        let idle = people.iter().enumerate().filter(|(_, it)| {
            let holds_most = 2 * held(it) > people.len() && it.device.address != Some(address);
            (!it.is_present() || holds_most) && it.is_idle()
        });
        let last = idle.max_by_key(|(person, it)| (!it.is_present(), held(it), *person));
        last.map(|(person, _)| person)
    }

    /// Handles a vote. A vote that does not fit the question changes nothing and is not saved.
    fn voted(
        &mut self,
        connection: ConnectionId,
        (question, vote): (usize, Vote),
        text: &str,
        n: u64,
    ) {
        let Some(person) = self.person(connection) else {
            return;
        };
        let is_open = self.open_vote() == Some(vote) && question == self.round.place().question;
        let device = &mut self.participant(person).device;
        let is_new = n > device.n;
        device.n = device.n.max(n);
        if !is_open || !is_new {
            return self.keeping.wait(connection);
        }
        let said = Said::parse(text);
        let change = ClassChange::Vote {
            question,
            vote,
            person,
            said,
        };
        let fits = (text.is_empty() || said.is_some()) && self.change(change).is_ok();
        self.participant(person).device.misfit = (!fits).then_some((question, vote));
        match fits {
            true => self.keeping.wait_for_changes(connection),
            false => self.keeping.wait(connection),
        }
    }

    /// Handles a hand-in: reads it as untrusted input, and saves it before it is confirmed.
    fn hand_in(&mut self, connection: ConnectionId, n: u64, file: &Value) {
        let Some(person) = self.person(connection) else {
            return;
        };
        let device = &mut self.participant(person).device;
        if device.handed.is_none_or(|it| it.n < n) {
            device.times += 1;
            let times = device.times;
            match self.read_hand_in(times, file) {
                Ok(mut hand_in) => {
                    // The name in the class replaces the one in the file.
                    self.round.name_of(person).clone_into(&mut hand_in.name);
                    if !self.round.class().is_empty() {
                        self.round.class().clone_into(&mut hand_in.class);
                    }
                    let answers = hand_in.attempts.len();
                    let on_its_way = HandInOnItsWay {
                        connection,
                        n,
                        answers,
                    };
                    let keep = SessionEffect::KeepHandIn(on_its_way, Box::new(hand_in));
                    return self.effects.push(keep);
                }
                Err(why) => {
                    let kept = Err(why);
                    self.participant(person).device.handed = Some(HandedIn { n, kept });
                }
            }
        }
        self.keeping.wait(connection);
    }

    /// The contents of an untrusted file, unless there have been too many hand-ins.
    fn read_hand_in(&mut self, times: usize, file: &Value) -> Result<HandIn, NotTaken> {
        let bytes = self.handed_bytes + file.to_string().len();
        if times > MOST_HAND_INS || bytes > MOST_BYTES {
            return Err(NotTaken::TooMany);
        }
        self.handed_bytes = bytes;
        let read = HandIn::of_value(file.clone()).ok();
        read.filter(|it| !it.attempts.is_empty())
            .ok_or(NotTaken::Format)
    }

    /// Notifies the pupil that a hand-in was saved in this folder, or could not be saved.
    pub fn keeps_hand_in(&mut self, it: HandInOnItsWay, folder: &Result<String, String>) {
        let kept = match folder {
            Ok(folder) => {
                self.handed_in_where = Some(folder.clone());
                Ok(it.answers)
            }
            Err(reason) => {
                self.effects.push(SessionEffect::Tell(format!(
                    "A pupil's hand-in cannot be saved: {reason}."
                )));
                Err(NotTaken::NotWritten)
            }
        };
        // A pupil who has lost the connection in the meantime will hand in again.
        if let Some(person) = self.person(it.connection) {
            let device = &mut self.participant(person).device;
            device.handed = Some(HandedIn { n: it.n, kept });
            device.has_handed_in |= kept.is_ok();
            self.keeping.wait(it.connection);
            self.go_on();
        }
    }

    /// Applies a change and marks it for saving.
    fn change(&mut self, change: ClassChange) -> Result<(), String> {
        self.round_mut().change(&change)?;
        self.keeping.changes.push(change);
        Ok(())
    }

    /// Requests that the round be saved, unless it has no file and there is nothing to save yet.
    fn save(&mut self) {
        let has_content = match self.round.way() {
            WayOfVoting::Devices => !self.round.participants().is_empty(),
            WayOfVoting::Teams | WayOfVoting::Tally => self.round.is_begun(),
        };
        if self.has_file || has_content {
            // The saved round includes all changes.
            self.keeping.changes.clear();
            self.has_file = true;
            self.keeping.ask();
            self.effects.push(SessionEffect::Save(self.shared_round()));
        }
    }

    /// Continues after an attempt to save the round. If the attempt failed, the teacher has been
    /// notified and the class continues anyway.
    pub fn saved(&mut self) {
        self.keeping.asked = self.keeping.asked.saturating_sub(1);
        self.go_on();
    }

    /// Notifies everybody of a new step once everything is saved.
    fn moved(&mut self) {
        let people = self.round.participants().iter();
        let connections = people.filter_map(|it| it.device.connection);
        connections.for_each(|connection| self.keeping.wait(connection));
        self.go_on();
    }

    /// Once no request is in progress, notifies the waiting connections and requests that newer
    /// changes be saved.
    fn go_on(&mut self) {
        if self.keeping.asked > 0 {
            return;
        }
        let waiting = std::mem::take(&mut self.keeping.waiting);
        self.send_states(&waiting);
        if !self.keeping.changes.is_empty() {
            let changes = std::mem::take(&mut self.keeping.changes);
            self.has_file = true;
            self.keeping.ask();
            self.effects
                .push(SessionEffect::Note(changes, self.shared_round()));
        }
    }

    fn send_states(&mut self, connections: &BTreeSet<ConnectionId>) {
        if connections.is_empty() {
            return;
        }
        for it in &mut self.round_mut().participants {
            it.device.rev += u64::from(it.device.among(connections).is_some());
        }
        let revealed = PupilView::new(&self.round, self.step(), self.with_points());
        let people = self.round.participants().iter().enumerate();
        let states = people.filter_map(|(person, it)| {
            Some((it.device.among(connections)?, revealed.state(person, it)?))
        });
        self.host(HostCall::Tell(states.collect()));
    }

    /// Applies a change to the list of people; a pupil who loses their seat receives the reason.
    pub fn change_people(&mut self, change: &ClassChange) {
        let connection = |person: usize| self.round.participants().get(person)?.device.connection;
        let (lost, renewed) = match change {
            ClassChange::Vacate { person } => (connection(*person).zip(Some(Refusal::Full)), None),
            ClassChange::Remove { person } => {
                (connection(*person).zip(Some(Refusal::Kicked)), None)
            }
            ClassChange::Merge { from, into } => {
                let before = connection(*into).filter(|_| connection(*from).is_some());
                (before.zip(Some(Refusal::Elsewhere)), connection(*from))
            }
            ClassChange::Rename { person, .. } => (None, connection(*person)),
            _ => (None, None),
        };
        if self.change(change.clone()).is_err() {
            return;
        }
        if let Some((connection, why)) = lost {
            self.refuse(Some(connection), why);
        }
        if let Some(connection) = renewed {
            self.keeping.wait(connection);
        }
    }

    /// Carries out the teacher's change to the list of people.
    pub fn edit_people(&mut self, change: &ClassChange) {
        self.change_people(change);
        self.go_on();
    }

    /// Frees the seats of all participants who are away, have no vote and have had no hand-in saved
    /// in this session.
    pub fn remove_away(&mut self) {
        // From the last to the first, so that the remaining indices stay valid.
        for person in self.away().into_iter().rev() {
            self.change_people(&ClassChange::Vacate { person });
        }
        self.go_on();
    }

    /// Advances the time.
    pub fn advance(&mut self, passed: Duration) {
        if self.waits() {
            self.waited += passed;
        }
    }

    /// The time until the session must next be advanced, to show what may prevent pupils from
    /// joining.
    pub fn wake(&self) -> Option<Duration> {
        let left = PATIENCE.checked_sub(self.waited)?;
        (self.waits() && !left.is_zero()).then_some(left)
    }

    /// Whether pupils can join but nobody has joined yet.
    fn waits(&self) -> bool {
        matches!(self.hosting, Some(Ok(_))) && self.round.participants().is_empty()
    }

    /// Whether nobody has joined for so long that something may be wrong with the connection.
    pub fn waits_long(&self) -> bool {
        self.waits() && self.waited >= PATIENCE
    }
}

impl Keeping {
    /// Adds a connection to notify once everything requested so far is saved.
    fn wait(&mut self, connection: ConnectionId) {
        if !self.later.contains(&connection) {
            self.waiting.insert(connection);
        }
    }

    /// Adds a connection to notify once the latest change is saved.
    fn wait_for_changes(&mut self, connection: ConnectionId) {
        self.waiting.remove(&connection);
        self.later.insert(connection);
    }

    /// Records that one more request, with all changes, is in progress.
    fn ask(&mut self) {
        self.asked += 1;
        self.waiting.append(&mut self.later);
    }
}
