//! One connection: reads a request, and serves the page or begins a WebSocket.

use std::io::{self, ErrorKind, Read, Write};
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

use tungstenite::handshake::derive_accept_key;
use tungstenite::protocol::frame::Frame;
use tungstenite::protocol::frame::coding::{Data, OpCode};
use tungstenite::protocol::{Role, WebSocketConfig};
use tungstenite::{Error, Message, WebSocket};

use super::head::{self, HttpRequest};
use super::switchboard::{Connection, Outgoing, Switchboard};
use super::{hang_up, random, spawn};
use crate::class::protocol::{
    ClientMessage, HostMessage, LARGEST_HAND_IN, LARGEST_MESSAGE, Refusal,
};
use crate::class::{Allowance, Bucket, CodeVerdict, SeatToken};
use crate::messages::{HostNews, Newcomer};
use crate::shells::lock;

/// The time limit for the head of a request.
const HEAD_TIME: Duration = Duration::from_secs(5);
const JOIN_TIME: Duration = Duration::from_secs(10);
/// How long the host sends nothing before it pings a device, and how long a device may be silent
/// before it counts as lost.
const PING: Duration = Duration::from_secs(20);
const GONE: Duration = Duration::from_secs(65);
/// The time limits for sending one part of the page, and for all of it.
const WRITE_TIME: Duration = Duration::from_secs(10);
const PAGE_TIME: Duration = Duration::from_secs(120);
/// The delay for a device that has to try again later.
const LATER: Duration = Duration::from_secs(1);
/// How many messages a device may send at once, and per second.
const MESSAGES: Allowance = Allowance {
    at_once: 30.0,
    per_s: 10.0,
};
/// The number of messages that a hand-in counts as.
const HAND_IN: f64 = 20.0;

/// Serves a connection until it ends.
pub(super) fn serve(board: &Arc<Switchboard>, connection: &Arc<Connection>) {
    // An error here means that the connection is lost or too slow, so no reply is needed.
    let _ = answer(board, connection);
    hang_up(&connection.stream);
    board.remove(connection.id);
}

fn answer(board: &Arc<Switchboard>, connection: &Arc<Connection>) -> io::Result<()> {
    connection.stream.set_nodelay(true)?;
    connection.stream.set_write_timeout(Some(WRITE_TIME))?;
    let (request, rest) = read_head(connection, board.port)?;
    match request {
        HttpRequest::Page {
            gzip,
            known,
            head_only,
        } => match &board.page {
            Some(page) => {
                let (head, body) = page.answer(gzip, known.as_deref());
                let body = if head_only { &[] } else { body };
                send(connection, head.as_bytes(), body)
            }
            None => {
                let words = "This host has no page for browsers. On a computer with carrom, run \
                             carrom join with this address.";
                refuse(connection, 200, words)
            }
        },
        HttpRequest::Talk(key) => {
            let accept = derive_accept_key(key.as_bytes());
            let head = format!(
                "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\n\
                 Connection: Upgrade\r\nSec-WebSocket-Accept: {accept}\r\n\r\n"
            );
            (&connection.stream).write_all(head.as_bytes())?;
            talk(board, connection, rest);
            Ok(())
        }
        HttpRequest::No(status, words) => refuse(connection, status, words),
    }
}

/// Reads the head of a request; also returns the bytes after it.
fn read_head(connection: &Connection, port: u16) -> io::Result<(HttpRequest, Vec<u8>)> {
    let end = Instant::now() + HEAD_TIME;
    let mut bytes = Vec::new();
    let mut piece = [0; 1024];
    loop {
        if let Some((length, request)) = head::read(&bytes, port) {
            return Ok((request, bytes.split_off(length)));
        }
        connection.stream.set_read_timeout(Some(left(end)?))?;
        let room = head::LONGEST - bytes.len();
        match (&connection.stream).read(&mut piece[..room.min(1024)])? {
            0 => return Err(ErrorKind::UnexpectedEof.into()),
            count => bytes.extend(&piece[..count]),
        }
    }
}

/// The time left until `end`.
fn left(end: Instant) -> io::Result<Duration> {
    let left = end.saturating_duration_since(Instant::now());
    if left.is_zero() {
        return Err(ErrorKind::TimedOut.into());
    }
    Ok(left)
}

fn refuse(connection: &Connection, status: u16, words: &str) -> io::Result<()> {
    let head = format!(
        "HTTP/1.1 {status} -\r\nContent-Type: text/plain; charset=utf-8\r\nContent-Length: {}\r\n\
         X-Content-Type-Options: nosniff\r\nConnection: close\r\n\r\n",
        words.len() + 1
    );
    send(connection, head.as_bytes(), format!("{words}\n").as_bytes())
}

/// Sends a whole response, unless the transfer stalls or takes longer than [`PAGE_TIME`].
fn send(connection: &Connection, head: &[u8], body: &[u8]) -> io::Result<()> {
    let end = Instant::now() + PAGE_TIME;
    (&connection.stream).write_all(head)?;
    for piece in body.chunks(1 << 16) {
        left(end)?;
        (&connection.stream).write_all(piece)?;
    }
    // Without this, the device might lose bytes that it has not read.
    connection.stream.shutdown(std::net::Shutdown::Write)?;
    drain(connection, Duration::from_secs(2));
    Ok(())
}

/// Waits until the device has closed the connection, but no longer than `patience`.
fn drain(connection: &Connection, patience: Duration) {
    let end = Instant::now() + patience;
    let mut piece = [0; 512];
    while let Ok(left) = left(end) {
        let waits = connection.stream.set_read_timeout(Some(left));
        if waits.is_err() || !matches!((&connection.stream).read(&mut piece), Ok(1..)) {
            return;
        }
    }
}

/// A connection for a WebSocket. A read ends at the deadline or, if there is none, after [`GONE`];
/// messages are written whole.
struct ServerStream {
    connection: Arc<Connection>,
    deadline: Option<Instant>,
}

impl Read for ServerStream {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let patience = match self.deadline {
            Some(deadline) => left(deadline)?,
            None => GONE,
        };
        self.connection.stream.set_read_timeout(Some(patience))?;
        (&self.connection.stream).read(bytes)
    }
}

impl Write for ServerStream {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        write_whole(&self.connection, bytes)?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn write_whole(connection: &Connection, bytes: &[u8]) -> io::Result<()> {
    let _alone = lock(&connection.writing);
    (&connection.stream).write_all(bytes)
}

fn talk(board: &Arc<Switchboard>, connection: &Arc<Connection>, rest: Vec<u8>) {
    let config = WebSocketConfig::default()
        .read_buffer_size(2 * LARGEST_MESSAGE)
        .write_buffer_size(0)
        .max_write_buffer_size(8 * LARGEST_MESSAGE)
        .max_message_size(Some(LARGEST_MESSAGE))
        .max_frame_size(Some(LARGEST_MESSAGE));
    let wire = ServerStream {
        connection: Arc::clone(connection),
        deadline: Some(Instant::now() + JOIN_TIME),
    };
    let mut socket = WebSocket::from_partially_read(wire, rest, Role::Server, Some(config));
    let why = match join(board, connection, &mut socket) {
        Ok(()) => {
            let why = listen(board, connection, &mut socket);
            board.hear(HostNews::Gone(connection.id));
            why
        }
        Err(why) => why,
    };
    if let Some(why) = why {
        let text = HostMessage::No { why }.to_text();
        // If this fails, the connection is lost.
        let _ = socket.send(Message::text(text));
        let _ = socket.close(None);
        let _ = connection.stream.shutdown(std::net::Shutdown::Write);
        drain(connection, Duration::from_secs(1));
    }
}

/// The next message; otherwise the reason for refusing the device, or `Err(None)` if the connection
/// is lost.
fn next(socket: &mut WebSocket<ServerStream>) -> Result<ClientMessage, Option<Refusal>> {
    loop {
        match socket.read() {
            Ok(Message::Text(text)) => return ClientMessage::read(&text).map_err(Some),
            Ok(Message::Binary(_)) | Err(Error::Capacity(_) | Error::Utf8(_)) => {
                return Err(Some(Refusal::Format));
            }
            Ok(_) => {}
            Err(Error::Io(error)) if is_late(&error) && socket.get_ref().deadline.is_some() => {
                return Err(Some(Refusal::Join));
            }
            Err(_) => return Err(None),
        }
    }
}

fn is_late(error: &io::Error) -> bool {
    matches!(error.kind(), ErrorKind::TimedOut | ErrorKind::WouldBlock)
}

/// Waits for a request to join.
fn join(
    board: &Arc<Switchboard>,
    connection: &Arc<Connection>,
    socket: &mut WebSocket<ServerStream>,
) -> Result<(), Option<Refusal>> {
    let ClientMessage::Join {
        code, name, seat, ..
    } = next(socket)?
    else {
        return Err(Some(Refusal::Join));
    };
    match board.judge(connection, &code, seat) {
        CodeVerdict::Right => {}
        CodeVerdict::Wrong(delay) => {
            thread::sleep(delay);
            return Err(Some(Refusal::Code));
        }
        CodeVerdict::Unseen => {
            thread::sleep(LATER);
            return Err(Some(Refusal::Later));
        }
    }
    let fresh = SeatToken::of(random().map_err(|_| None)?);
    socket.get_mut().deadline = None;
    connection.join();
    // A pupil who has joined may send a hand-in, which is larger than other messages.
    socket.set_config(|config| {
        config.max_message_size = Some(LARGEST_HAND_IN);
        config.max_frame_size = Some(LARGEST_HAND_IN);
    });
    let writer = Arc::clone(connection);
    spawn("outbox", move || write_out(&writer)).map_err(|_| Some(Refusal::Full))?;
    board.hear(HostNews::Came(Newcomer {
        connection: connection.id,
        name,
        seat,
        fresh,
        address: connection.address,
        at: board.now(),
    }));
    Ok(())
}

/// Receives the messages of a pupil who has joined; returns why the connection ends.
fn listen(
    board: &Arc<Switchboard>,
    connection: &Arc<Connection>,
    socket: &mut WebSocket<ServerStream>,
) -> Option<Refusal> {
    let mut messages = Bucket::full(MESSAGES);
    loop {
        let message = match next(socket) {
            Ok(message) => message,
            Err(why) => return why,
        };
        let weight = match message {
            ClientMessage::HandIn { .. } => HAND_IN,
            _ => 1.0,
        };
        thread::sleep(messages.take(weight, board.now()));
        match message {
            ClientMessage::Join { .. } => return Some(Refusal::Format),
            ClientMessage::Leave => return None,
            message => board.hear(HostNews::Said(connection.id, message)),
        }
    }
}

/// Sends the contents of the outbox, and pings the device now and then.
fn write_out(connection: &Connection) {
    let text = |text: String| Frame::message(text, OpCode::Data(Data::Text), true);
    loop {
        let (frames, goes_on) = match connection.take(PING) {
            Outgoing::State(state) => (vec![text(state)], true),
            Outgoing::Nothing => (vec![Frame::ping("")], true),
            Outgoing::Last(last) => (vec![text(last), Frame::close(None)], false),
            Outgoing::Closed => return,
        };
        let mut bytes = Vec::new();
        let made = frames.into_iter().try_for_each(|it| it.format(&mut bytes));
        if made.is_err() || write_whole(connection, &bytes).is_err() {
            // A device that does not read for `WRITE_TIME` counts as lost; the reading thread
            // notices that.
            return hang_up(&connection.stream);
        }
        if !goes_on {
            let _ = connection.stream.shutdown(std::net::Shutdown::Write);
            return;
        }
    }
}
