//! A class on its own devices: a server in the local network, for the teacher's carrom.
//!
//! It listens when a screen asks for it ([`HostCall::Open`]), gives the page to browsers and
//! talks with pupils by WebSocket. It knows the code of the class and how much may come from
//! whom, and nothing of questions and votes: what pupils say goes to the screen as
//! [`HostNews`], what the screen says of each goes to them.
//!
//! A thread accepts; each connection has one that reads, and once it has joined one that
//! writes, from an outbox in which a newer state takes the place of an older one that was not
//! sent yet: who reads slowly gets fewer states, and holds up nobody.

mod addresses;
mod head;
mod line;
mod page;
mod switchboard;

use std::io;
use std::net::{Ipv4Addr, SocketAddrV4, TcpListener, TcpStream};
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

pub use page::ServedPage;

use crate::class::DoorCode;
use crate::messages::{HostCall, HostNews, OpenDoor};
use switchboard::Switchboard;

/// The port where none is asked for; the next ones are tried where it is taken.
pub(crate) const PORT: u16 = 8090;
/// How many ports are tried.
const PORTS: u16 = 10;
/// How long a carrom that has just ended, or a round that was just left, may need to let go of its
/// port.
const LETTING_GO: Duration = Duration::from_millis(300);
/// How many connections may wait to be accepted: a class that comes all at once.
#[cfg(unix)]
const BACKLOG: i32 = 1024;
/// The stack of a thread of a connection, in bytes.
const STACK: usize = 192 * 1024;

/// How a class is served.
#[derive(Clone, Default)]
pub struct HostOptions {
    /// The port; without one the first free one from `PORT` on.
    pub port: Option<u16>,
    /// The page for browsers, or why there is none.
    pub page: Option<Result<Arc<ServedPage>, String>>,
}

/// What serves a class.
pub struct Host {
    options: HostOptions,
    wake: Arc<dyn Fn() + Send + Sync>,
    board: Option<Arc<Switchboard>>,
    /// What the screen is to hear though no pupil said it.
    news: Vec<HostNews>,
}

impl Host {
    /// Serves nobody yet. `wake` is called when there is news where there was none.
    pub fn new(options: HostOptions, wake: impl Fn() + Send + Sync + 'static) -> Self {
        Self {
            options,
            wake: Arc::new(wake),
            board: None,
            news: Vec::new(),
        }
    }

    /// Does what a screen asks for.
    pub fn call(&mut self, call: &HostCall) {
        match (call, &self.board) {
            (HostCall::Open { code, address }, _) => {
                self.close();
                let opened = self.open(*code, *address);
                let opened = opened.map_err(|error| error.to_string());
                self.news.push(HostNews::Opened(opened));
                (self.wake)();
            }
            (HostCall::Tell(states), Some(board)) => {
                for (line, state) in states {
                    board.tell(*line, state.clone());
                }
            }
            (HostCall::Refuse(line, why), Some(board)) => board.refuse(*line, *why),
            (HostCall::Close, _) => self.close(),
            (_, None) => {}
        }
    }

    /// What was heard since the last call.
    pub fn take_news(&mut self) -> Vec<HostNews> {
        let mut news = std::mem::take(&mut self.news);
        if let Some(board) = &self.board {
            news.extend(board.take_news());
        }
        news
    }

    fn close(&mut self) {
        if let Some(board) = self.board.take() {
            board.close();
        }
    }

    fn open(
        &mut self,
        code: Option<DoorCode>,
        before: Option<SocketAddrV4>,
    ) -> io::Result<OpenDoor> {
        raise_limit();
        let listener = self.listen(before.map(|it| it.port()))?;
        let port = listener.local_addr()?.port();
        let code = match code {
            Some(code) => code,
            None => DoorCode::of(random()? as u64),
        };
        let page = match &self.options.page {
            Some(page) => page.clone(),
            None => Err("this carrom contains no page for browsers".into()),
        };
        let told = page.as_ref().map(|_| ()).map_err(Clone::clone);
        let board = Arc::new(Switchboard::new(
            code,
            port,
            page.ok(),
            Arc::clone(&self.wake),
        ));
        self.board = Some(Arc::clone(&board));
        spawn("host", move || accept(&listener, &board))?;
        Ok(OpenDoor {
            code,
            addresses: addresses::own(port, before),
            page: told,
        })
    }

    /// Listens at the port that was asked for. Where none was, at the one where devices look
    /// for the round, or else at the first free one.
    fn listen(&self, before: Option<u16>) -> io::Result<TcpListener> {
        let first = self.options.port.or(before).map(|port| (port, LETTING_GO));
        let others = match self.options.port {
            Some(_) => 0..0,
            None => PORT..PORT + PORTS,
        };
        let others = others.map(|port| (port, Duration::ZERO));
        let mut failed = io::Error::from(io::ErrorKind::AddrInUse);
        for (port, patience) in first.into_iter().chain(others) {
            match bind(port, patience) {
                Ok(listener) => {
                    #[cfg(unix)]
                    rustix::net::listen(&listener, BACKLOG)?;
                    return Ok(listener);
                }
                Err(error) => {
                    failed = io::Error::new(error.kind(), format!("port {port}: {error}"));
                }
            }
        }
        Err(failed)
    }
}

impl Drop for Host {
    fn drop(&mut self) {
        self.close();
    }
}

/// Takes a port, or waits so long for whoever has it.
fn bind(port: u16, patience: Duration) -> io::Result<TcpListener> {
    let end = Instant::now() + patience;
    loop {
        match TcpListener::bind((Ipv4Addr::UNSPECIFIED, port)) {
            Err(error) if error.kind() == io::ErrorKind::AddrInUse && Instant::now() < end => {
                thread::sleep(Duration::from_millis(10));
            }
            bound => return bound,
        }
    }
}

/// Accepts connections until the class is over.
fn accept(listener: &TcpListener, board: &Arc<Switchboard>) {
    loop {
        let accepted = listener.accept();
        if board.is_closed() {
            return;
        }
        let Ok((stream, address)) = accepted else {
            // Too many files are open: some of them will close.
            thread::sleep(Duration::from_millis(50));
            continue;
        };
        let Some(entry) = board.admit(stream, address.ip()) else {
            continue;
        };
        let (id, at) = (entry.id, Arc::clone(board));
        if spawn("line", move || line::serve(&at, &entry)).is_err() {
            board.remove(id);
        }
    }
}

/// Starts a thread of this name.
fn spawn(name: &str, work: impl FnOnce() + Send + 'static) -> io::Result<()> {
    let builder = thread::Builder::new().name(name.into()).stack_size(STACK);
    builder.spawn(work).map(drop)
}

/// Random bits that nobody can guess.
fn random() -> io::Result<u128> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes).map_err(|error| io::Error::other(error.to_string()))?;
    Ok(u128::from_le_bytes(bytes))
}

/// Lets the process open as many files as it may: a pupil is one.
fn raise_limit() {
    #[cfg(unix)]
    {
        use rustix::process::{Resource, getrlimit, setrlimit};
        let mut limit = getrlimit(Resource::Nofile);
        limit.current = limit.maximum;
        // A smaller class is a class, too.
        let _ = setrlimit(Resource::Nofile, limit);
    }
}

/// Hangs up a connection from another thread; whoever reads from it hears of it.
fn hang_up(stream: &TcpStream) {
    let _ = stream.shutdown(std::net::Shutdown::Both);
}
