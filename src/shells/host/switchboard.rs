//! All connections of a class, and their news.

use std::collections::{BTreeMap, HashSet, VecDeque};
use std::net::{IpAddr, TcpStream};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::{Duration, Instant};

use super::{ServedPage, hang_up};
use crate::class::protocol::{HostMessage, PupilState, Refusal};
use crate::class::{CodeVerdict, GuardedCode, JoinCode, SeatToken};
use crate::messages::{ConnectionId, HostNews};
use crate::shells::lock;

/// The maximum number of simultaneous connections. If there are more, the address with the most
/// connections that have not joined loses the oldest of these, so that a client that opens many
/// affects only itself.
const MOST_CONNECTIONS: usize = 600;

/// All connections of a class.
pub(super) struct Switchboard {
    code: Mutex<GuardedCode>,
    /// The seat tokens of all devices that have joined.
    seats: Mutex<HashSet<SeatToken>>,
    opened: Instant,
    /// The port that the server listens on.
    pub(super) port: u16,
    pub(super) page: Option<ServedPage>,
    wake: Arc<dyn Fn() + Send + Sync>,
    connections: Mutex<BTreeMap<ConnectionId, Arc<Connection>>>,
    news: Mutex<VecDeque<HostNews>>,
    next: AtomicU64,
    closed: AtomicBool,
}

pub(super) struct Connection {
    /// A number that no other connection has.
    pub(super) id: ConnectionId,
    /// The address of the device.
    pub(super) address: IpAddr,
    pub(super) stream: TcpStream,
    /// A lock that is held while a frame is being written.
    pub(super) writing: Mutex<()>,
    joined: AtomicBool,
    outbox: Mutex<Outbox>,
    filled: Condvar,
}

/// The latest message to send; it replaces earlier unsent ones.
#[derive(Default)]
struct Outbox {
    state: Option<String>,
    last: Option<String>,
    closed: bool,
}

/// The contents of an outbox.
pub(super) enum Outgoing {
    /// The pupil's latest state, as text.
    State(String),
    /// The last message, as text, after which the connection is closed.
    Last(String),
    Nothing,
    Closed,
}

impl Switchboard {
    pub(super) fn new(
        code: JoinCode,
        port: u16,
        page: Option<ServedPage>,
        wake: Arc<dyn Fn() + Send + Sync>,
    ) -> Self {
        Self {
            code: Mutex::new(GuardedCode::new(code)),
            seats: Mutex::default(),
            opened: Instant::now(),
            port,
            page,
            wake,
            connections: Mutex::default(),
            news: Mutex::default(),
            next: AtomicU64::new(1),
            closed: AtomicBool::new(false),
        }
    }

    /// Adds a connection; `None` if there is no room for it.
    pub(super) fn admit(&self, stream: TcpStream, address: IpAddr) -> Option<Arc<Connection>> {
        let mut connections = lock(&self.connections);
        if connections.len() >= MOST_CONNECTIONS {
            let id = Self::superfluous(&connections)?;
            if let Some(connection) = connections.remove(&id) {
                hang_up(&connection.stream);
            }
        }
        let id = self.next.fetch_add(1, Ordering::Relaxed);
        let connection = Arc::new(Connection {
            id,
            address,
            stream,
            writing: Mutex::default(),
            joined: AtomicBool::new(false),
            outbox: Mutex::default(),
            filled: Condvar::new(),
        });
        connections.insert(id, Arc::clone(&connection));
        Some(connection)
    }

    /// The connection to close when there are too many; `None` if all of them have joined.
    fn superfluous(connections: &BTreeMap<ConnectionId, Arc<Connection>>) -> Option<ConnectionId> {
        let mut held: BTreeMap<IpAddr, (usize, ConnectionId)> = BTreeMap::new();
        for (id, connection) in connections
            .iter()
            .filter(|(_, connection)| !connection.has_joined())
        {
            held.entry(connection.address).or_insert((0, *id)).0 += 1;
        }
        let most = held.values().max_by_key(|(count, _)| *count)?;
        Some(most.1)
    }

    /// Removes a lost connection.
    pub(super) fn remove(&self, id: ConnectionId) {
        if let Some(connection) = lock(&self.connections).remove(&id) {
            connection.close();
        }
    }

    fn connection(&self, id: ConnectionId) -> Option<Arc<Connection>> {
        lock(&self.connections).get(&id).cloned()
    }

    /// The time since the server was opened.
    pub(super) fn now(&self) -> Duration {
        self.opened.elapsed()
    }

    /// Checks a typed code. A device that has joined before can always return, however many wrong
    /// codes others try.
    pub(super) fn judge(
        &self,
        connection: &Connection,
        typed: &str,
        seat: Option<SeatToken>,
    ) -> CodeVerdict {
        let was_in = seat.is_some_and(|seat| lock(&self.seats).contains(&seat));
        let mut code = lock(&self.code);
        if was_in && code.is(typed) {
            return CodeVerdict::Right;
        }
        code.judge(typed, connection.address, self.now())
    }

    /// Sends a pupil the state.
    pub(super) fn send(&self, id: ConnectionId, state: PupilState) {
        if let Some(connection) = self.connection(id) {
            lock(&self.seats).insert(state.seat);
            lock(&connection.outbox).state = Some(HostMessage::State(Box::new(state)).to_text());
            connection.filled.notify_all();
        }
    }

    /// Tells a pupil why the connection is being closed.
    pub(super) fn refuse(&self, id: ConnectionId, why: Refusal) {
        if let Some(connection) = self.connection(id) {
            lock(&connection.outbox).last = Some(HostMessage::No { why }.to_text());
            connection.filled.notify_all();
        }
    }

    pub(super) fn hear(&self, news: HostNews) {
        let mut all = lock(&self.news);
        let was_empty = all.is_empty();
        all.push_back(news);
        drop(all);
        if was_empty {
            (self.wake)();
        }
    }

    /// The news since the last call.
    pub(super) fn take_news(&self) -> Vec<HostNews> {
        lock(&self.news).drain(..).collect()
    }

    /// Whether the class is over.
    pub(super) fn is_closed(&self) -> bool {
        self.closed.load(Ordering::SeqCst)
    }

    pub(super) fn close(&self) {
        self.closed.store(true, Ordering::SeqCst);
        let connections = std::mem::take(&mut *lock(&self.connections));
        for connection in connections.values() {
            connection.close();
            hang_up(&connection.stream);
        }
        // A connection wakes the accepting thread, so that the thread notices the end.
        let own = (std::net::Ipv4Addr::LOCALHOST, self.port);
        let _ = TcpStream::connect_timeout(&own.into(), Duration::from_secs(1));
    }
}

impl Connection {
    fn has_joined(&self) -> bool {
        self.joined.load(Ordering::SeqCst)
    }

    /// Records that the device has joined.
    pub(super) fn join(&self) {
        self.joined.store(true, Ordering::SeqCst);
    }

    fn close(&self) {
        lock(&self.outbox).closed = true;
        self.filled.notify_all();
    }

    /// Waits for a message to send, but no longer than `patience`.
    pub(super) fn take(&self, patience: Duration) -> Outgoing {
        let empty = |it: &mut Outbox| it.state.is_none() && it.last.is_none() && !it.closed;
        let waited = self
            .filled
            .wait_timeout_while(lock(&self.outbox), patience, empty);
        let (mut outbox, _) = waited.unwrap_or_else(PoisonError::into_inner);
        match (outbox.state.take(), outbox.last.take()) {
            (_, Some(last)) => Outgoing::Last(last),
            (Some(state), None) => Outgoing::State(state),
            (None, None) if outbox.closed => Outgoing::Closed,
            (None, None) => Outgoing::Nothing,
        }
    }
}
