//! A class on pupils' own devices: the requests that a pupil's carrom sends to its connection to
//! the host, and the events that arrive.

/// A request from a pupil's carrom to its connection.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum JoinCall {
    /// Connect to the host at this address; close any other connection.
    Dial(String),
    /// Send this text.
    Say(String),
    /// Save how the pupil can rejoin the class.
    Remember {
        /// The token of the pupil's seat, as text.
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
    /// The host cannot be reached, or the connection was lost, for this reason.
    Lost(String),
    /// Remembered from an earlier connection: the token, and the name.
    Remembered(String, String),
    /// The device was asleep or the page was hidden, and is active again.
    Awake,
}
