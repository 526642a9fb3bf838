//! The connection of a pupil's carrom to a class: one WebSocket to the host.

use std::collections::BTreeMap;
use std::io::{self, ErrorKind, Read, Write};
use std::net::{Shutdown, TcpStream, ToSocketAddrs};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

use tungstenite::client::client_with_config;
use tungstenite::protocol::{Role, WebSocketConfig};
use tungstenite::{Message, WebSocket};

use super::lock;
use crate::messages::{JoinCall, JoinNews};

/// How long the host may take to accept a connection.
const PATIENCE: Duration = Duration::from_secs(5);
/// The length of silence after which the host counts as lost; the host sends something at least
/// every 20 seconds.
const GONE: Duration = Duration::from_secs(65);
/// The maximum size of one message from the host, in bytes.
const LARGEST_STATE: usize = 1 << 20;

pub(crate) struct Client {
    hear: Arc<dyn Fn(JoinNews) + Send + Sync>,
    /// The number of the current connection; results of earlier ones are ignored.
    call: Arc<AtomicU64>,
    /// The current connection, to write to; a thread reads from it.
    writer: Arc<Mutex<Option<WebSocket<ClientStream>>>>,
    address: String,
    /// What is remembered of earlier connections, by address.
    seats: BTreeMap<String, JoinNews>,
}

/// A connection that writes whole messages.
#[derive(Clone)]
struct ClientStream {
    stream: Arc<TcpStream>,
    writing: Arc<Mutex<()>>,
}

impl Read for ClientStream {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        (&*self.stream).read(bytes)
    }
}

impl Write for ClientStream {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let _alone = lock(&self.writing);
        (&*self.stream).write_all(bytes)?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Client {
    /// Creates a client that is not connected yet; `hear` receives all events.
    pub(crate) fn new(hear: impl Fn(JoinNews) + Send + Sync + 'static) -> Self {
        Self {
            hear: Arc::new(hear),
            call: Arc::default(),
            writer: Arc::default(),
            address: String::new(),
            seats: BTreeMap::new(),
        }
    }

    /// Carries out a screen's request.
    pub(crate) fn call(&mut self, call: &JoinCall) {
        match call {
            JoinCall::Dial { address } => {
                self.hang_up();
                self.address.clone_from(address);
                if let Some(remembered) = self.seats.get(address) {
                    (self.hear)(remembered.clone());
                }
                self.dial();
            }
            JoinCall::Say { text } => self.say(text),
            JoinCall::Remember { seat, name, .. } => {
                let (seat, name) = (seat.clone(), name.clone());
                let remembered = JoinNews::Remembered { seat, name };
                self.seats.insert(self.address.clone(), remembered);
            }
            JoinCall::HangUp => self.hang_up(),
        }
    }

    fn hang_up(&self) {
        self.call.fetch_add(1, Ordering::SeqCst);
        if let Some(writer) = lock(&self.writer).take() {
            let _ = writer.get_ref().stream.shutdown(Shutdown::Both);
        }
    }

    fn dial(&self) {
        let (hear, address) = (Arc::clone(&self.hear), self.address.clone());
        let (calls, place) = (Arc::clone(&self.call), Arc::clone(&self.writer));
        let own = calls.load(Ordering::SeqCst);
        let is_current = move || calls.load(Ordering::SeqCst) == own;
        let talk = move || {
            let say = |news| {
                if is_current() {
                    hear(news);
                }
            };
            if let Ok(mut socket) = connect(&address) {
                let wire = socket.get_ref().clone();
                let mut writer = lock(&place);
                if !is_current() {
                    return;
                }
                *writer = Some(WebSocket::from_raw_socket(wire, Role::Client, None));
                drop(writer);
                say(JoinNews::Reached);
                listen(&mut socket, &say);
            }
            say(JoinNews::Lost);
        };
        let builder = thread::Builder::new().name("client".into());
        if builder.spawn(talk).is_err() {
            (self.hear)(JoinNews::Lost);
        }
    }

    fn say(&self, text: &str) {
        if let Some(writer) = lock(&self.writer).as_mut() {
            // The reading thread notices that the connection is closed.
            let _ = writer.send(Message::text(text));
        }
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        self.hang_up();
    }
}

fn connect(address: &str) -> io::Result<WebSocket<ClientStream>> {
    let connect = |place| TcpStream::connect_timeout(&place, PATIENCE).ok();
    let stream = address.to_socket_addrs()?.find_map(connect);
    let stream = stream.ok_or(ErrorKind::NotConnected)?;
    stream.set_nodelay(true)?;
    stream.set_read_timeout(Some(PATIENCE))?;
    stream.set_write_timeout(Some(PATIENCE))?;
    let wire = ClientStream {
        stream: Arc::new(stream),
        writing: Arc::default(),
    };
    let config = WebSocketConfig::default()
        .read_buffer_size(1 << 14)
        .max_message_size(Some(LARGEST_STATE))
        .max_frame_size(Some(LARGEST_STATE));
    let link = format!("ws://{address}/class");
    let (socket, _) = client_with_config(link, wire, Some(config))
        .map_err(|error| io::Error::other(error.to_string()))?;
    socket.get_ref().stream.set_read_timeout(Some(GONE))?;
    Ok(socket)
}

/// Receives the host's messages until the connection is lost.
fn listen(socket: &mut WebSocket<ClientStream>, say: &impl Fn(JoinNews)) {
    while let Ok(message) = socket.read() {
        match message {
            Message::Text(text) => {
                let text = text.to_string();
                say(JoinNews::Heard { text });
            }
            Message::Ping(_) => {
                // This sends the queued reply at once.
                let _ = socket.flush();
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use std::net::{Ipv4Addr, TcpListener};
    use std::sync::mpsc;

    use super::*;

    #[test]
    fn a_connection_that_is_made_too_late_does_not_replace_the_current_one() {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).unwrap();
        let address = listener.local_addr().unwrap().to_string();
        let accept = || {
            let (stream, _) = listener.accept().unwrap();
            stream.set_read_timeout(Some(PATIENCE)).unwrap();
            stream
        };
        let (hear, heard) = mpsc::channel();
        let mut client = Client::new(move |news| drop(hear.send(news)));
        let dial = JoinCall::Dial { address };
        client.call(&dial);
        let late = accept();
        client.call(&JoinCall::HangUp);
        client.call(&dial);
        let mut current = tungstenite::accept(accept()).unwrap();
        assert_eq!(heard.recv(), Ok(JoinNews::Reached));
        let mut late = tungstenite::accept(late).unwrap();
        assert!(late.read().is_err(), "the client closes it");
        let text = "a vote".to_owned();
        client.call(&JoinCall::Say { text: text.clone() });
        assert_eq!(current.read().unwrap(), Message::text(text));
    }
}
