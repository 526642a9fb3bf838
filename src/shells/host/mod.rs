//! A server on the local network, through which the teacher's carrom serves the pupils' devices.
//!
//! The server starts listening when a screen requests it ([`HostCall::Open`]), serves the page to
//! browsers and communicates with pupils by WebSocket. It knows the code of the class and the
//! limits, but nothing about questions and votes: pupils' messages go to the screen as
//! [`HostNews`], and the screen's states go to the pupils.
//!
//! One thread accepts connections. Each connection has a thread that reads and, once its device has
//! joined, one that writes from an outbox. A newer state in the outbox replaces an older one that
//! has not been sent, so a slow device gets fewer states and does not delay the others.

mod addresses;
mod connection;
mod head;
mod page;
mod switchboard;

use std::io;
use std::net::{Ipv4Addr, SocketAddrV4, TcpListener, TcpStream};
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

use page::ServedPage;

use super::PageFile;
use crate::class::JoinCode;
use crate::class::protocol::PORT;
use crate::messages::{HostCall, HostNews, JoinDetails};
use crate::quiz::Code;
use switchboard::Switchboard;

/// How many ports are tried, from [`PORT`] on.
const PORTS: u16 = 10;
/// How long a program or a round that has just ended may take to release its port.
const LETTING_GO: Duration = Duration::from_secs(5);
/// How many connections may wait to be accepted. A whole class may join at the same moment.
#[cfg(unix)]
const BACKLOG: i32 = 1024;
/// The stack size of a connection's thread, in bytes.
const STACK: usize = 192 * 1024;

/// How a class is served.
#[derive(Clone, Default)]
pub struct HostOptions {
    /// The port; by default the one used before, or else the first free one from `PORT` on.
    pub port: Option<u16>,
    /// The page for browsers, or why there is none.
    pub page: Option<Result<Arc<PageFile>, String>>,
}

/// The server of a class.
pub struct Host {
    options: HostOptions,
    wake: Arc<dyn Fn() + Send + Sync>,
    board: Option<Arc<Switchboard>>,
    /// News for the screen, except news from pupils.
    news: Vec<HostNews>,
}

impl Host {
    /// Creates a server that is not listening yet. `wake` is called when there is news to take.
    pub fn new(options: HostOptions, wake: impl Fn() + Send + Sync + 'static) -> Self {
        Self {
            options,
            wake: Arc::new(wake),
            board: None,
            news: Vec::new(),
        }
    }

    /// Carries out a request from a screen.
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
                for (connection, state) in states {
                    board.send(*connection, state.clone());
                }
            }
            (HostCall::Refuse(connection, why), Some(board)) => board.refuse(*connection, *why),
            (HostCall::Close, _) => self.close(),
            (_, None) => {}
        }
    }

    /// The news since the last call.
    pub fn take_news(&mut self) -> Vec<HostNews> {
        let mut news = std::mem::take(&mut self.news);
        if let Some(board) = &self.board {
            news.extend(board.take_news());
        }
        news
    }

    /// The page for browsers, or why there is none.
    fn page(&self) -> Result<&PageFile, String> {
        match &self.options.page {
            Some(page) => page.as_deref().map_err(Clone::clone),
            None => Err("this program contains no page for browsers".into()),
        }
    }

    /// The page as a file for a teacher, with the teacher's own files; if the code of a round is
    /// given, the file is a SCORM package.
    ///
    /// # Errors
    /// If there is no page, or for the reasons given at [`PageFile::document`].
    pub(super) fn page_document(&self, round: Option<&Code>) -> Result<Vec<u8>, String> {
        let document = self.page()?.document(round);
        document.map_err(|error| error.to_string())
    }

    fn close(&mut self) {
        if let Some(board) = self.board.take() {
            board.close();
        }
    }

    fn open(
        &mut self,
        code: Option<JoinCode>,
        before: Option<SocketAddrV4>,
    ) -> io::Result<JoinDetails> {
        raise_limit();
        let listener = self.listen(before.map(|it| it.port()))?;
        let port = listener.local_addr()?.port();
        let code = match code {
            Some(code) => code,
            None => JoinCode::of(random()? as u64),
        };
        let page = self.page();
        let shown = page.clone().map(|_| ());
        let page = page.ok().map(|page| ServedPage::new(&page.text()));
        let page = page.transpose()?;
        let board = Arc::new(Switchboard::new(code, port, page, Arc::clone(&self.wake)));
        self.board = Some(Arc::clone(&board));
        spawn("host", move || accept(&listener, &board))?;
        Ok(JoinDetails {
            code,
            addresses: addresses::own(port, before),
            page: shown,
        })
    }

    /// Listens at the requested port. If none was requested, uses the port at which the devices
    /// look for the round, or else the first free port.
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

/// Opens a port; if the port is in use, waits for at most `patience` until it is free.
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
            // Too many files are open; wait until some of them are closed.
            thread::sleep(Duration::from_millis(50));
            continue;
        };
        let Some(entry) = board.admit(stream, address.ip()) else {
            continue;
        };
        let (id, at) = (entry.id, Arc::clone(board));
        if spawn("connection", move || connection::serve(&at, &entry)).is_err() {
            board.remove(id);
        }
    }
}

fn spawn(name: &str, work: impl FnOnce() + Send + 'static) -> io::Result<()> {
    let builder = thread::Builder::new().name(name.into()).stack_size(STACK);
    builder.spawn(work).map(drop)
}

/// Cryptographically secure random bits.
fn random() -> io::Result<u128> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes).map_err(|error| io::Error::other(error.to_string()))?;
    Ok(u128::from_le_bytes(bytes))
}

/// Raises the limit on open files, because each pupil's connection needs an open file.
fn raise_limit() {
    #[cfg(unix)]
    {
        use rustix::process::{Resource, getrlimit, setrlimit};
        let mut limit = getrlimit(Resource::Nofile);
        limit.current = limit.maximum;
        // If that fails, only the size of the class is limited.
        let _ = setrlimit(Resource::Nofile, limit);
    }
}

/// Closes a connection; a thread that is reading from it notices that.
fn hang_up(stream: &TcpStream) {
    let _ = stream.shutdown(std::net::Shutdown::Both);
}
