//! A class in one process: the teacher's app and the apps of pupils, on simulated time and without
//! a network. The apps exchange exactly the messages that they would send over a network.

use std::net::{IpAddr, Ipv4Addr, SocketAddrV4};
use std::time::Duration;

use crate::app::App;
use crate::class::protocol::{ClientMessage, HostMessage, Refusal};
use crate::class::{JoinCode, SeatToken};
use crate::messages::{
    ConnectionId, HostCall, HostNews, Input, JoinCall, JoinDetails, JoinNews, Newcomer,
};
use crate::shells::Headless;

/// The address of the class for all pupils.
const ADDRESS: SocketAddrV4 = SocketAddrV4::new(Ipv4Addr::new(192, 168, 43, 117), 8090);

/// A class in one process.
pub struct Classroom {
    host: Headless,
    pupils: Vec<PupilDevice>,
    code: Option<JoinCode>,
    /// The number of connections so far.
    connections: ConnectionId,
    /// The simulated time since the start.
    passed: Duration,
}

struct PupilDevice {
    name: String,
    game: Headless,
    /// The current connection; `None` if there is none.
    connection: Option<ConnectionId>,
    /// Whether the host can be reached.
    reaches: bool,
    /// What is remembered of an earlier connection.
    remembered: Option<JoinNews>,
}

impl PupilDevice {
    fn hears(&mut self, news: JoinNews) {
        self.game.input(&Input::Joined(news));
    }
}

/// A participant in a class.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Who {
    /// The teacher.
    Host,
    /// A pupil, by index; pupils are numbered in the order in which they were added.
    Pupil(usize),
}

impl Classroom {
    /// Creates a class with a teacher's app and without pupils.
    pub fn new(host: Headless) -> Self {
        let mut class = Self {
            host,
            pupils: Vec::new(),
            code: None,
            connections: 0,
            passed: Duration::ZERO,
        };
        class.settle();
        class
    }

    /// Adds a pupil with an app; returns the participant.
    pub fn add(&mut self, name: &str, app: App, columns: u16, rows: u16) -> Who {
        self.pupils.push(PupilDevice {
            name: name.to_owned(),
            game: Headless::new(app, columns, rows),
            connection: None,
            reaches: true,
            remembered: None,
        });
        self.settle();
        Who::Pupil(self.pupils.len() - 1)
    }

    /// The pupil with this name, as given to [`Self::add`].
    pub fn pupil(&self, name: &str) -> Option<Who> {
        let at = self.pupils.iter().position(|pupil| pupil.name == name);
        at.map(Who::Pupil)
    }

    /// The app of a participant.
    pub fn game(&mut self, who: Who) -> &mut Headless {
        match who {
            Who::Pupil(at) if at < self.pupils.len() => &mut self.pupils[at].game,
            Who::Pupil(_) | Who::Host => &mut self.host,
        }
    }

    /// The app of a participant, detached from the class.
    pub fn into_game(mut self, who: Who) -> Headless {
        match who {
            Who::Pupil(at) if at < self.pupils.len() => self.pupils.swap_remove(at).game,
            Who::Pupil(_) | Who::Host => self.host,
        }
    }

    /// The code for joining, once pupils can join.
    pub fn code(&self) -> Option<JoinCode> {
        self.code
    }

    /// Disconnects a pupil's device from the host, or lets it connect again.
    pub fn reach(&mut self, who: Who, reaches: bool) {
        let Who::Pupil(at) = who else { return };
        let Some(pupil) = self.pupils.get_mut(at) else {
            return;
        };
        pupil.reaches = reaches;
        if !reaches && let Some(connection) = pupil.connection.take() {
            pupil.hears(JoinNews::Lost);
            self.notify_host(HostNews::Gone(connection));
        }
        self.settle();
    }

    /// Advances simulated time for all participants.
    pub fn pass(&mut self, time: Duration) {
        self.passed += time;
        if self.pupils.is_empty() {
            self.host.pass(time);
            return self.settle();
        }
        const STEP: Duration = Duration::from_millis(100);
        let mut left = time;
        while !left.is_zero() {
            let step = STEP.min(left);
            self.host.pass(step);
            self.pupils.iter_mut().for_each(|it| it.game.pass(step));
            self.settle();
            left -= step;
        }
    }

    /// Carries messages in both directions until there are none left.
    pub fn settle(&mut self) {
        loop {
            let calls = self.host.take_host_calls();
            let mut quiet = calls.is_empty();
            calls.iter().for_each(|call| self.host_calls(call));
            for at in 0..self.pupils.len() {
                let calls = self.pupils[at].game.take_join_calls();
                quiet &= calls.is_empty();
                calls.iter().for_each(|call| self.pupil_calls(at, call));
            }
            if quiet {
                return;
            }
        }
    }

    fn host_calls(&mut self, call: &HostCall) {
        match call {
            HostCall::Open { code, .. } => {
                let code = code.unwrap_or(JoinCode::of(123_456_789));
                self.code = Some(code);
                let details = JoinDetails {
                    code,
                    addresses: vec![ADDRESS],
                    page: Ok(()),
                };
                self.notify_host(HostNews::Opened(Ok(details)));
            }
            HostCall::Tell(states) => {
                for (connection, state) in states {
                    let message = HostMessage::State(Box::new(state.clone()));
                    self.send(*connection, &message);
                }
            }
            HostCall::Refuse(connection, why) => {
                self.send(*connection, &HostMessage::No { why: *why });
                if let Some(pupil) = self.at(*connection) {
                    pupil.connection = None;
                }
            }
            HostCall::Close => {
                self.code = None;
                for pupil in &mut self.pupils {
                    if pupil.connection.take().is_some() {
                        pupil.hears(JoinNews::Lost);
                    }
                }
            }
        }
    }

    fn notify_host(&mut self, news: HostNews) {
        self.host.input(&Input::Hosted(vec![news]));
    }

    fn at(&mut self, connection: ConnectionId) -> Option<&mut PupilDevice> {
        let mut all = self.pupils.iter_mut();
        all.find(|it| it.connection == Some(connection))
    }

    fn send(&mut self, connection: ConnectionId, message: &HostMessage) {
        if let Some(pupil) = self.at(connection) {
            let text = message.to_text();
            pupil.hears(JoinNews::Heard { text });
        }
    }

    fn pupil_calls(&mut self, at: usize, call: &JoinCall) {
        let code = self.code;
        let pupil = &mut self.pupils[at];
        match call {
            JoinCall::Dial { .. } => {
                let before = pupil.connection.take();
                if let Some(remembered) = pupil.remembered.clone() {
                    pupil.hears(remembered);
                }
                if pupil.reaches && code.is_some() {
                    self.connections += 1;
                    pupil.connection = Some(self.connections);
                    pupil.hears(JoinNews::Reached);
                } else {
                    pupil.hears(JoinNews::Lost);
                }
                if let Some(connection) = before {
                    self.notify_host(HostNews::Gone(connection));
                }
            }
            JoinCall::Say { text } => {
                if let Some(connection) = pupil.connection {
                    // The address of the device, different for each pupil.
                    let address = Ipv4Addr::from(10 << 24 | (at as u32 + 1));
                    self.hear(connection, address.into(), text);
                }
            }
            JoinCall::Remember { seat, name, .. } => {
                let (seat, name) = (seat.clone(), name.clone());
                pupil.remembered = Some(JoinNews::Remembered { seat, name });
            }
            JoinCall::HangUp => {
                if let Some(connection) = pupil.connection.take() {
                    self.notify_host(HostNews::Gone(connection));
                }
            }
        }
    }

    /// Passes a message to the host, as its server would.
    fn hear(&mut self, connection: ConnectionId, address: IpAddr, text: &str) {
        let no = |why| HostMessage::No { why };
        let news = match ClientMessage::read(text) {
            Ok(ClientMessage::Join {
                code, name, seat, ..
            }) => {
                if code.parse().ok() != self.code {
                    return self.send(connection, &no(Refusal::Code));
                }
                HostNews::Came(Newcomer {
                    connection,
                    name,
                    seat,
                    fresh: SeatToken::of(u128::from(connection)),
                    address,
                    at: self.passed,
                })
            }
            Ok(message) => HostNews::Said(connection, message),
            Err(why) => return self.send(connection, &no(why)),
        };
        self.notify_host(news);
    }
}
