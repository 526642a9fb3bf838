//! A class on the pupils' own devices: the requests that a pupil's carrom sends to its connection
//! with the host, and the events that the connection sends back.

/// A request from a pupil's carrom to its connection with the host.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum JoinCall {
    /// Connect to the host at this address, and close any other connection.
    Dial(String),
    /// Send this text to the host.
    Say(String),
    /// Save the information that the pupil needs to rejoin the class.
    Remember {
        /// The token for the pupil's seat, as text.
        seat: String,
        /// The pupil's name.
        name: String,
        /// The code of the class.
        code: String,
    },
    /// Close the connection.
    HangUp,
}

/// An event from a pupil's connection to the host.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum JoinNews {
    /// The connection is open.
    Reached,
    /// The host has sent this text.
    Heard(String),
    /// The host cannot be reached, or the connection has been lost.
    Lost,
    /// The token and the name that were saved during an earlier connection.
    Remembered(String, String),
    /// The device was asleep or the page was hidden, and carrom is now active again.
    Awake,
}
