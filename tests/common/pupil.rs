//! A pupil's device simulated by a test: a WebSocket and the messages over it.

use std::io::{self, Read, Write};
use std::net::{Ipv4Addr, SocketAddrV4, TcpStream};
use std::time::Duration;

use serde_json::{Value, json};
use tungstenite::client::client;
use tungstenite::{Message, WebSocket};

/// How long a device waits before a test gives up.
const PATIENCE: Duration = Duration::from_secs(30);

pub(crate) struct Pupil {
    pub(crate) socket: WebSocket<TcpStream>,
    /// The latest state that the host sent.
    pub(crate) state: Value,
    n: u64,
}

/// A connection to a host on this computer.
pub(crate) fn connect(port: u16) -> io::Result<TcpStream> {
    connect_from(1, port)
}

/// A connection from the address `127.0.0.DEVICE`, if the system allows it, because each device in
/// a network has its own address.
pub(crate) fn connect_from(device: u8, port: u16) -> io::Result<TcpStream> {
    let host = SocketAddrV4::new(Ipv4Addr::LOCALHOST, port);
    #[cfg(target_os = "linux")]
    let stream = {
        use rustix::net::{AddressFamily, SocketType, bind, connect, socket};
        let own = SocketAddrV4::new(Ipv4Addr::new(127, 0, 0, device), 0);
        let socket = socket(AddressFamily::INET, SocketType::STREAM, None)?;
        bind(&socket, &own)?;
        connect(&socket, &host)?;
        TcpStream::from(socket)
    };
    #[cfg(not(target_os = "linux"))]
    let stream = TcpStream::connect(host)?;
    stream.set_nodelay(true)?;
    stream.set_read_timeout(Some(PATIENCE))?;
    Ok(stream)
}

/// The host's complete response to a request.
pub(crate) fn answer(port: u16, request: &[u8]) -> String {
    let mut stream = connect(port).unwrap();
    stream.write_all(request).unwrap();
    let mut answer = Vec::new();
    // The response is returned even if the connection ends with an error.
    let _ = stream.read_to_end(&mut answer);
    String::from_utf8_lossy(&answer).into_owned()
}

impl Pupil {
    /// A device that has not joined yet.
    pub(crate) fn dial(port: u16) -> io::Result<Self> {
        Self::dial_from(1, port)
    }

    fn dial_from(device: u8, port: u16) -> io::Result<Self> {
        let link = format!("ws://127.0.0.1:{port}/class");
        let stream = connect_from(device, port)?;
        let (socket, _) =
            client(link, stream).map_err(|error| io::Error::other(error.to_string()))?;
        Ok(Self {
            socket,
            state: Value::Null,
            n: 0,
        })
    }

    /// A device that joins; its state is the host's reply.
    pub(crate) fn join(port: u16, code: &str, name: &str, seat: Option<&str>) -> io::Result<Self> {
        Self::join_from(1, port, code, name, seat)
    }

    /// A device that joins from its own address, as in [`connect_from`].
    pub(crate) fn join_from(
        device: u8,
        port: u16,
        code: &str,
        name: &str,
        seat: Option<&str>,
    ) -> io::Result<Self> {
        let mut pupil = Self::dial_from(device, port)?;
        let mut join = json!({"t": "join", "v": 1, "code": code, "name": name});
        if let Some(seat) = seat {
            join["seat"] = seat.into();
        }
        pupil.say(&join.to_string())?;
        pupil.hear()?;
        pupil.n = pupil.state["n"].as_u64().unwrap_or(0);
        Ok(pupil)
    }

    pub(crate) fn say(&mut self, text: &str) -> io::Result<()> {
        let sent = self.socket.send(Message::text(text.to_owned()));
        sent.map_err(|error| io::Error::other(error.to_string()))
    }

    /// Receives the host's next message, which becomes the state.
    pub(crate) fn hear(&mut self) -> io::Result<()> {
        loop {
            match self.socket.read() {
                Ok(Message::Text(text)) => {
                    self.state = serde_json::from_str(&text)?;
                    return Ok(());
                }
                Ok(_) => {}
                Err(tungstenite::Error::Io(error)) => return Err(error),
                Err(error) => return Err(io::Error::other(error.to_string())),
            }
        }
    }

    /// Receives messages until the state satisfies a condition.
    pub(crate) fn hear_until(&mut self, stand: impl Fn(&Value) -> bool) -> io::Result<()> {
        while !stand(&self.state) {
            self.hear()?;
        }
        Ok(())
    }

    /// Votes and waits until the host has received the vote.
    pub(crate) fn vote(&mut self, said: &str) -> io::Result<()> {
        self.send_vote(said)?;
        let n = self.n;
        self.hear_until(|state| state["n"].as_u64() >= Some(n))
    }

    /// Votes without waiting for a reply.
    pub(crate) fn send_vote(&mut self, said: &str) -> io::Result<()> {
        self.n += 1;
        let vote = match self.state["step"].as_str() {
            Some("second-vote") => "second",
            _ => "first",
        };
        let vote =
            json!({"t": "vote", "q": self.state["q"], "vote": vote, "said": said, "n": self.n});
        self.say(&vote.to_string())
    }

    /// Hands a file in and returns the host's reply.
    pub(crate) fn hand_in(&mut self, file: &Value) -> io::Result<Value> {
        let n = self.state["handed"]["n"].as_u64().unwrap_or(0) + 1;
        let saying = json!({"t": "hand-in", "n": n, "file": file});
        self.say(&saying.to_string())?;
        self.hear_until(|state| state["handed"]["n"].as_u64() >= Some(n))?;
        Ok(self.state["handed"]["kept"].clone())
    }

    /// The reason that the host gives when it refuses a device.
    pub(crate) fn why(&self) -> Option<&str> {
        self.state["why"].as_str()
    }

    /// A text field of the state.
    pub(crate) fn text(&self, field: &str) -> String {
        self.state[field].as_str().unwrap_or_default().to_owned()
    }
}
