//! A round whose pupils vote on devices of their own, as the teacher's screen sees it: who is
//! in, what they say, and what they are told.
//!
//! Nothing is told of a vote before it is kept: changes are collected, asked to be kept all
//! at once, and whoever they are of hears of it when that is done.

mod door_page;
mod handing_in;
mod people;
mod qr;

use std::collections::BTreeSet;
use std::net::IpAddr;
use std::time::Duration;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use crate::class::protocol::{HandedIn, PupilState, PupilStep, Refusal, VERSION};
use crate::class::{
    AskedQuestion, Ballot, ClassChange, ClassRound, ClassStep, NewSeats, Said, SeatToken,
    ToldTruth, Vote, standings,
};
use crate::messages::{HostCall, HostNews, Key, LineId, Mouse, OpenDoor, StoreRequest};
use crate::quiz::{Answer, Confidence, Form, Response, explain};
use crate::screens::Context;
use crate::widgets::Look;
use crate::widgets::input::{KeyTable, ListAction};
use handing_in::HandingIn;
use people::People;

/// How long nobody may have come before the screen says what may be in the way.
const PATIENCE: Duration = Duration::from_secs(60);

/// What keys do about pupils on their own devices.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum HostingAction {
    /// show how to come in: the address and the code
    Door,
    /// show who is in, and who has voted
    Names,
    /// on with the round
    GoOn,
    /// let nobody new in, or let them in again
    Shut,
    /// choose somebody
    List(ListAction),
    /// give them another name
    Rename,
    /// somebody came back as a stranger: make one of the two
    Merge,
    /// take them off the list
    Remove,
    /// take all off the list who are away and never voted
    RemoveAway,
    /// back to the page before
    Back,
    /// as it was
    NotYet,
}

/// The pupils of a round on their own devices.
#[derive(Debug, Clone)]
pub(in crate::screens::class) struct Hosting {
    door: DoorState,
    /// Whether the round has a file: one that nobody has joined needs none.
    has_file: bool,
    /// Who is reached how, in the order of the round's names.
    presence: Vec<Presence>,
    /// Whether nobody new is let in.
    shut: bool,
    keeping: Keeping,
    handing_in: HandingIn,
    new_seats: NewSeats,
    /// How long the door has been open without anybody coming in.
    waited: Duration,
    page: Option<HostPage>,
    /// Whether the class still gathers.
    pub(in crate::screens::class) gathers: bool,
}

/// Whether pupils can come in.
#[derive(Debug, Clone)]
enum DoorState {
    Opening,
    Open(OpenDoor),
    Failed(String),
}

/// How somebody is reached.
#[derive(Debug, Clone, Copy, Default)]
struct Presence {
    /// Their connection; `None` while they are away.
    line: Option<LineId>,
    /// Where their connection comes from, or came from.
    address: Option<IpAddr>,
    /// The number of their last vote that was handled.
    n: u64,
    /// The number of the last state that this connection was told.
    rev: u64,
    /// Where their last vote was, if it did not fit the question.
    misfit: Option<(usize, Vote)>,
    /// What came of the last that they handed in.
    handed: Option<HandedIn>,
    /// How often they did, and whether something of it is kept.
    times: usize,
    has_handed_in: bool,
}

/// What is on its way to the disk, and who waits for it.
#[derive(Debug, Clone, Default)]
struct Keeping {
    /// Changes that nobody was asked to keep yet, and the connections that they came by.
    changes: Vec<ClassChange>,
    later: BTreeSet<LineId>,
    /// How many requests are under way, and the connections to be told when they are done.
    asked: usize,
    waiting: BTreeSet<LineId>,
}

/// A page of its own.
#[derive(Debug, Clone)]
enum HostPage {
    /// How to come in.
    Door,
    /// Who is in.
    People(People),
}

/// What of the round a pupil's state follows from, besides the votes.
#[derive(Debug, Clone, Copy)]
pub(in crate::screens::class) struct Scene {
    /// The ticket with which the round is kept.
    pub(in crate::screens::class) ticket: u64,
    /// Where the class is.
    pub(in crate::screens::class) step: PupilStep,
    /// How many questions have their points.
    pub(in crate::screens::class) asked: usize,
}

impl Hosting {
    /// The door of a round, which is asked to be opened.
    pub(in crate::screens::class) fn open(round: &ClassRound, cx: &mut Context) -> Self {
        cx.host(HostCall::Open {
            code: round.door(),
            address: round.address(),
        });
        Self {
            door: DoorState::Opening,
            has_file: round.door().is_some(),
            presence: vec![Presence::default(); round.teams().len()],
            shut: false,
            keeping: Keeping::default(),
            handing_in: HandingIn::default(),
            new_seats: NewSeats::default(),
            waited: Duration::ZERO,
            page: Some(HostPage::Door),
            gathers: true,
        }
    }

    /// How many are in just now.
    pub(in crate::screens::class) fn present(&self) -> usize {
        let lines = self.presence.iter().filter(|it| it.line.is_some());
        lines.count()
    }

    /// Those who are away and never voted, nor handed anything in.
    fn away(&self, round: &ClassRound) -> Vec<usize> {
        let all = self.presence.iter().enumerate();
        let away = all.filter(|(person, it)| it.line.is_none() && self.is_idle(*person, round));
        away.map(|(person, _)| person).collect()
    }

    /// Whether somebody never voted, nor handed anything in.
    fn is_idle(&self, person: usize, round: &ClassRound) -> bool {
        let presence = self.presence.get(person);
        presence.is_some_and(|it| !it.has_handed_in) && !round.has_voted(person)
    }

    /// "27 of 32 have voted": of those who are in, and those who have voted and are away.
    pub(in crate::screens::class) fn turnout(&self, round: &ClassRound, vote: Vote) -> String {
        let question = round.place().question;
        let voted = |person: usize| round.ballot(question, person).said(vote).is_some();
        let here = |person: &usize| {
            let line = self.presence.get(*person).and_then(|it| it.line);
            line.is_some() || voted(*person)
        };
        let all: Vec<usize> = (0..round.teams().len()).filter(here).collect();
        let count = all.iter().filter(|person| voted(**person)).count();
        match vote {
            Vote::First => format!("{count} of {} have voted", all.len()),
            Vote::Second => {
                let changed = round.voted(question, Vote::Second);
                format!("{changed} of {} have voted again", all.len())
            }
        }
    }

    /// Takes in what was heard of the class.
    pub(in crate::screens::class) fn take_news(
        &mut self,
        news: &[HostNews],
        round: &mut ClassRound,
        scene: Scene,
        cx: &mut Context,
    ) {
        for it in news {
            match it {
                HostNews::Opened(Ok(door)) => {
                    let address = door.addresses.first().copied();
                    let before = round.address().filter(|it| Some(*it) != address);
                    if let (Some(before), Some(now)) = (before, address) {
                        cx.tell(format!(
                            "This round was at {before} and is now at {now}. Devices cannot come \
                             back by themselves: ask your pupils to open the new address."
                        ));
                    }
                    round.open(door.code, address);
                    self.door = DoorState::Open(door.clone());
                    self.save(round, scene, cx);
                }
                HostNews::Opened(Err(reason)) => self.door = DoorState::Failed(reason.clone()),
                HostNews::Came {
                    line,
                    name,
                    seat,
                    fresh,
                    address,
                    at,
                } => {
                    let known = seat.and_then(|seat| round.seat(seat));
                    let seated = match known {
                        Some(person) => Ok(person),
                        None if round.is_removed(*seat, name) => Err(Refusal::Kicked),
                        None if self.shut || scene.step == PupilStep::End => Err(Refusal::Closed),
                        None if !self.new_seats.has_one(*address, *at) => Err(Refusal::Later),
                        None => self.let_in(name, *fresh, *address, round, cx),
                    };
                    match seated {
                        Ok(person) => {
                            self.seat(person, *line, *address, cx);
                            if known.is_none() {
                                self.new_seats.take(*address, *at);
                                self.keeping.wait_for_changes(*line);
                            }
                        }
                        Err(why) => cx.host(HostCall::Refuse(*line, why)),
                    }
                }
                HostNews::Voted {
                    line,
                    question,
                    vote,
                    said,
                    n,
                } => {
                    let open =
                        scene.step.vote() == Some(*vote) && *question == round.place().question;
                    if let Some(person) = self.person(*line)
                        && let Some(presence) = self.presence.get_mut(person)
                    {
                        let is_new = *n > presence.n;
                        presence.n = presence.n.max(*n);
                        let fits = open && is_new && self.vote(person, *vote, said, round);
                        match fits {
                            true => self.keeping.wait_for_changes(*line),
                            false => self.keeping.wait(*line),
                        }
                    }
                }
                HostNews::HandedIn { line, n, file } => {
                    if let Some(person) = self.person(*line) {
                        self.hand_in(person, *line, *n, file, round, cx);
                    }
                }
                HostNews::Gone(line) => {
                    if let Some(person) = self.person(*line) {
                        self.presence[person].line = None;
                    }
                }
            }
        }
        self.go_on(round, scene, cx);
    }

    /// Who is reached by a connection.
    fn person(&self, line: LineId) -> Option<usize> {
        let mut all = self.presence.iter();
        all.position(|presence| presence.line == Some(line))
    }

    /// Puts somebody in their place; whoever sat there has to leave.
    fn seat(&mut self, person: usize, line: LineId, address: IpAddr, cx: &mut Context) {
        let Some(presence) = self.presence.get_mut(person) else {
            return;
        };
        presence.rev = 0;
        presence.address = Some(address);
        if let Some(before) = presence.line.replace(line) {
            cx.host(HostCall::Refuse(before, Refusal::Elsewhere));
        }
        self.keeping.wait(line);
    }

    /// Lets somebody new in, if there is a place for them.
    fn let_in(
        &mut self,
        name: &str,
        seat: SeatToken,
        address: IpAddr,
        round: &mut ClassRound,
        cx: &mut Context,
    ) -> Result<usize, Refusal> {
        let name = round.name_for(name).ok_or(Refusal::Name)?;
        if round.teams().len() >= round.way().most() {
            let person = self.who_gives_way(address, round).ok_or(Refusal::Full)?;
            self.change_people(&ClassChange::Vacate { person }, round, cx);
        }
        let change = ClassChange::Join { seat, name };
        self.change(change, round).map_err(|_| Refusal::Full)?;
        self.presence.push(Presence::default());
        Ok(self.presence.len() - 1)
    }

    /// In a full class, the person whose seat goes to a newcomer from this address. Only somebody who
    /// has never voted nor handed anything in loses a seat: if they are away, or if more than half of
    /// all seats belong to their address, which may be one device. The address with the most seats
    /// gives way first, and of its seats the last.
    fn who_gives_way(&self, address: IpAddr, round: &ClassRound) -> Option<usize> {
        let held = |by: &Presence| {
            let all = self.presence.iter();
            all.filter(|it| it.address == by.address).count()
        };
        let idle = self.presence.iter().enumerate().filter(|(person, it)| {
            let holds_most = 2 * held(it) > self.presence.len() && it.address != Some(address);
            (it.line.is_none() || holds_most) && self.is_idle(*person, round)
        });
        let last = idle.max_by_key(|(person, it)| (it.line.is_none(), held(it), *person));
        last.map(|(person, _)| person)
    }

    /// Takes a vote; says whether it fits the question. One that does not changes nothing and
    /// is not kept.
    fn vote(&mut self, person: usize, vote: Vote, said: &str, round: &mut ClassRound) -> bool {
        let question = round.place().question;
        let parsed = Said::parse(said);
        let change = ClassChange::Vote {
            question,
            vote,
            person,
            said: parsed,
        };
        let is_said = said.is_empty() || parsed.is_some();
        let fits = is_said && self.change(change, round).is_ok();
        if let Some(presence) = self.presence.get_mut(person) {
            presence.misfit = (!fits).then_some((question, vote));
        }
        fits
    }

    /// Lets something change, to be kept.
    fn change(&mut self, change: ClassChange, round: &mut ClassRound) -> Result<(), String> {
        round.change(&change)?;
        self.keeping.changes.push(change);
        Ok(())
    }

    /// Has the round kept as it stands, if it has a file or somebody has joined.
    pub(in crate::screens::class) fn save(
        &mut self,
        round: &ClassRound,
        scene: Scene,
        cx: &mut Context,
    ) {
        if !self.has_file && round.teams().is_empty() {
            return;
        }
        // What has changed is in it.
        self.keeping.changes.clear();
        self.has_file = true;
        self.keeping.ask(
            scene.ticket,
            StoreRequest::SaveClass(Box::new(round.clone())),
            cx,
        );
    }

    /// The round is kept, or it cannot be: the teacher was told so, and the class goes on.
    pub(in crate::screens::class) fn saved(
        &mut self,
        round: &ClassRound,
        scene: Scene,
        cx: &mut Context,
    ) {
        self.keeping.asked = self.keeping.asked.saturating_sub(1);
        self.go_on(round, scene, cx);
    }

    /// The class is somewhere else: everybody is told, once all is kept.
    pub(in crate::screens::class) fn moved(
        &mut self,
        round: &ClassRound,
        scene: Scene,
        cx: &mut Context,
    ) {
        let lines = self.presence.iter().filter_map(|it| it.line);
        lines.for_each(|line| self.keeping.wait(line));
        self.go_on(round, scene, cx);
    }

    /// While nothing is on its way to the disk: tells those who wait for what is there, and
    /// sends what has changed since.
    fn go_on(&mut self, round: &ClassRound, scene: Scene, cx: &mut Context) {
        let away = match self.page {
            Some(HostPage::People(_)) => self.away(round).len(),
            _ => 0,
        };
        if let Some(HostPage::People(people)) = &mut self.page {
            people.renew(round, scene.step.vote(), away);
        }
        if self.keeping.asked > 0 {
            return;
        }
        let waiting = std::mem::take(&mut self.keeping.waiting);
        self.tell(&waiting, round, scene, cx);
        if !self.keeping.changes.is_empty() {
            let changes = std::mem::take(&mut self.keeping.changes);
            self.has_file = true;
            let round = Box::new(round.clone());
            self.keeping
                .ask(scene.ticket, StoreRequest::NoteClass { changes, round }, cx);
        }
    }

    /// Tells pupils how things stand.
    fn tell(
        &mut self,
        lines: &BTreeSet<LineId>,
        round: &ClassRound,
        scene: Scene,
        cx: &mut Context,
    ) {
        if lines.is_empty() {
            return;
        }
        let told = Told::new(round, scene);
        let mut states = Vec::new();
        for (person, presence) in self.presence.iter_mut().enumerate() {
            if let Some(line) = presence.line.filter(|line| lines.contains(line)) {
                presence.rev += 1;
                if let Some(state) = told.state(round, person, presence) {
                    states.push((line, state));
                }
            }
        }
        cx.host(HostCall::Tell(states));
    }

    /// Ends it: nobody can come back, and all hang up.
    pub(in crate::screens::class) fn close(cx: &mut Context) {
        cx.host(HostCall::Close);
    }

    /// The keys that there are at every step.
    pub(in crate::screens::class) fn keys(&self) -> KeyTable<HostingAction> {
        KeyTable::new("class")
            .on('j', HostingAction::Door, "how to join")
            .on('w', HostingAction::Names, "who is in")
    }

    /// The keys of a page of its own, if one is open.
    pub(in crate::screens::class) fn page_keys(&self) -> Option<KeyTable<HostingAction>> {
        use HostingAction::{Door, GoOn, Names, Shut};
        let shut = if self.shut {
            "let them in"
        } else {
            "close the door"
        };
        match self.page.as_ref()? {
            HostPage::Door => Some(
                KeyTable::new("class")
                    .on(Key::Enter, GoOn, "on with the round")
                    .or([(Key::Char(' '), GoOn), (Key::Char('j'), GoOn)])
                    .on('w', Names, "who is in")
                    .on('c', Shut, shut),
            ),
            HostPage::People(people) => {
                let keys = people.keys(shut);
                Some(keys.or([(Key::Char('j'), Door)]))
            }
        }
    }

    /// Takes a key that types; says whether it was one.
    pub(in crate::screens::class) fn typed(&mut self, key: Key) -> bool {
        match &mut self.page {
            Some(HostPage::People(people)) => people.typed(key),
            _ => false,
        }
    }

    /// Takes the mouse, if a page is open; gives what is to be done.
    pub(in crate::screens::class) fn mouse(
        &mut self,
        mouse: &Mouse,
        area: Rect,
    ) -> Option<HostingAction> {
        match &mut self.page {
            Some(HostPage::People(people)) => people
                .mouse(mouse, area)
                .then_some(HostingAction::List(ListAction::Open)),
            _ => None,
        }
    }

    /// What is asked before an action is done that cannot be undone.
    pub(in crate::screens::class) fn confirmation(
        &mut self,
        action: HostingAction,
        round: &ClassRound,
    ) -> Option<String> {
        let away = self.away(round).len();
        match (&mut self.page, action) {
            (Some(HostPage::People(_)), HostingAction::RemoveAway) => Some(format!(
                "Take {away} off the list who are away and never voted? They can join again."
            )),
            (Some(HostPage::People(people)), _) => people.confirmation(action, round),
            _ => None,
        }
    }

    /// Does what a key stands for.
    pub(in crate::screens::class) fn act(
        &mut self,
        action: HostingAction,
        round: &mut ClassRound,
        scene: Scene,
        cx: &mut Context,
    ) {
        match (action, &mut self.page) {
            (HostingAction::Door, _) => self.page = Some(HostPage::Door),
            (HostingAction::Names, _) => {
                let away = self.away(round).len();
                self.page = Some(HostPage::People(People::new(
                    round,
                    scene.step.vote(),
                    away,
                )));
            }
            (HostingAction::GoOn | HostingAction::NotYet, None) => {}
            (HostingAction::GoOn, _) => {
                self.page = None;
                self.gathers = false;
            }
            (HostingAction::Back, _) => self.page = self.gathers.then_some(HostPage::Door),
            (HostingAction::Shut, _) => self.shut = !self.shut,
            (HostingAction::RemoveAway, _) => {
                // From the last on, so that nobody moves up before it is their turn.
                for person in self.away(round).into_iter().rev() {
                    self.change_people(&ClassChange::Vacate { person }, round, cx);
                }
                self.go_on(round, scene, cx);
            }
            (action, Some(HostPage::People(people))) => {
                if let Some(change) = people.act(action, round) {
                    self.change_people(&change, round, cx);
                }
                self.go_on(round, scene, cx);
            }
            _ => {}
        }
    }

    /// Lets the list of people change, with who is reached how.
    fn change_people(&mut self, change: &ClassChange, round: &mut ClassRound, cx: &mut Context) {
        if self.change(change.clone(), round).is_err() {
            return;
        }
        if let (
            Some(HostPage::People(people)),
            ClassChange::Remove { person }
            | ClassChange::Vacate { person }
            | ClassChange::Merge { from: person, .. },
        ) = (&mut self.page, change)
        {
            people.gone(*person);
        }
        match change {
            ClassChange::Vacate { person } => {
                let gone = self.presence.remove(*person);
                if let Some(line) = gone.line {
                    cx.host(HostCall::Refuse(line, Refusal::Full));
                }
            }
            ClassChange::Remove { person } => {
                let gone = self.presence.remove(*person);
                if let Some(line) = gone.line {
                    cx.host(HostCall::Refuse(line, Refusal::Kicked));
                }
            }
            ClassChange::Merge { from, into } => {
                let stranger = self.presence[*from];
                if let Some(line) = stranger.line {
                    let before = std::mem::replace(&mut self.presence[*into], stranger);
                    let one = &mut self.presence[*into];
                    one.handed = one.handed.or(before.handed);
                    one.has_handed_in |= before.has_handed_in;
                    if let Some(before) = before.line {
                        cx.host(HostCall::Refuse(before, Refusal::Elsewhere));
                    }
                    self.keeping.wait(line);
                }
                self.presence.remove(*from);
            }
            ClassChange::Rename { person, .. } => {
                if let Some(line) = self.presence[*person].line {
                    self.keeping.wait(line);
                }
            }
            _ => {}
        }
    }

    /// Lets time pass.
    pub(in crate::screens::class) fn advance(&mut self, passed: Duration) {
        if self.waits() {
            self.waited += passed;
        }
    }

    /// When it next needs time: when it may have to say what is in the way.
    pub(in crate::screens::class) fn wake(&self) -> Option<Duration> {
        let left = PATIENCE.checked_sub(self.waited)?;
        (self.waits() && !left.is_zero()).then_some(left)
    }

    /// Whether the door is open and nobody has come yet.
    fn waits(&self) -> bool {
        matches!(self.door, DoorState::Open(_)) && self.presence.is_empty()
    }

    /// Draws the page of its own, if one is open; says whether it did.
    pub(in crate::screens::class) fn draw(
        &self,
        round: &ClassRound,
        area: Rect,
        buf: &mut Buffer,
        look: &Look,
    ) -> bool {
        match &self.page {
            None => return false,
            Some(HostPage::Door) => door_page::draw(self, round, area, buf, look),
            Some(HostPage::People(people)) => people.draw(self, round, area, buf, look),
        }
        true
    }
}

impl Keeping {
    /// Somebody is to be told when all is kept that was asked for so far.
    fn wait(&mut self, line: LineId) {
        if !self.later.contains(&line) {
            self.waiting.insert(line);
        }
    }

    /// Somebody is to be told when what has changed last is kept.
    fn wait_for_changes(&mut self, line: LineId) {
        self.waiting.remove(&line);
        self.later.insert(line);
    }

    fn ask(&mut self, ticket: u64, wish: StoreRequest, cx: &mut Context) {
        self.asked += 1;
        let later = std::mem::take(&mut self.later);
        self.waiting.extend(later);
        cx.keep(ticket, wish);
    }
}

/// What all pupils are told alike.
struct Told {
    scene: Scene,
    question: Option<AskedQuestion>,
    spread: Vec<u32>,
    /// Points and place of each, once there are any.
    scores: Vec<Option<(f64, usize)>>,
}

impl Told {
    fn new(round: &ClassRound, scene: Scene) -> Self {
        let number = round.place().question;
        let question = round.questions().get(number);
        let is_asked = matches!(scene.step, PupilStep::Asked(_));
        let mut spread = Vec::new();
        let is_spread = [ClassStep::Talk, ClassStep::SecondVote].map(PupilStep::Asked);
        if let Some(Form::Choice { options, .. }) = question.map(|it| &it.form)
            && is_spread.contains(&scene.step)
        {
            spread = vec![0; options.len()];
            for said in round.said(number, Vote::First) {
                if let Response::Choice(choice) = said
                    && let Some(count) = spread.get_mut(choice)
                {
                    *count += 1;
                }
            }
        }
        let mut scores = vec![None; round.teams().len()];
        if [PupilStep::Asked(ClassStep::Scores), PupilStep::End].contains(&scene.step) {
            for it in standings(round, scene.asked) {
                if let Some(score) = scores.get_mut(it.team) {
                    *score = Some((it.points, it.place));
                }
            }
        }
        Self {
            scene,
            question: question.filter(|_| is_asked).map(AskedQuestion::new),
            spread,
            scores,
        }
    }

    /// How things stand for one of them.
    fn state(&self, round: &ClassRound, person: usize, presence: &Presence) -> Option<PupilState> {
        let q = round.place().question;
        let ballot = round.ballot(q, person);
        let text = |vote| ballot.given(vote).map(Said::to_text).unwrap_or_default();
        let is_told = [ClassStep::Shot, ClassStep::Scores].map(PupilStep::Asked);
        let is_told = is_told.contains(&self.scene.step);
        Some(PupilState {
            v: VERSION,
            rev: presence.rev,
            seat: round.token(person)?,
            name: round.teams().get(person)?.clone(),
            q,
            of: round.questions().len(),
            step: self.scene.step,
            n: presence.n,
            misfit: self
                .scene
                .step
                .vote()
                .is_some_and(|vote| presence.misfit == Some((q, vote))),
            first: text(Vote::First),
            second: text(Vote::Second),
            question: self.question.clone(),
            spread: self.spread.clone(),
            told: is_told.then(|| truth(round, person, &ballot)).flatten(),
            score: self.scores.get(person).copied().flatten(),
            handed: presence.handed,
        })
    }
}

/// The truth, with what is to be said to what this pupil said.
fn truth(round: &ClassRound, person: usize, ballot: &Ballot) -> Option<ToldTruth> {
    let number = round.place().question;
    let question = round.questions().get(number)?;
    let why = match ballot.counts() {
        Some(said) => explain(question, &Answer::new(said, Confidence::ThinkSo)).text,
        None => question.why.clone(),
    };
    let points = ballot.counts().map(|_| round.points(number, person));
    Some(ToldTruth::new(question, why, points))
}
