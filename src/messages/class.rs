//! A class on the pupils' own devices: the requests that a pupil's carrom sends to its connection
//! with the host, and the events that the connection sends back. A page receives the requests and
//! sends the events as JSON.

use serde::{Deserialize, Serialize};

/// A request from a pupil's carrom to its connection with the host.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(tag = "do", rename_all = "kebab-case")]
pub enum JoinCall {
    /// Connect to the host, and close any other connection.
    Dial {
        /// The address of the host; a page can only connect to the host that has served it.
        #[serde(skip)]
        address: String,
    },
    /// Send a text to the host.
    Say {
        /// The text.
        text: String,
    },
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
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(tag = "is", rename_all = "kebab-case")]
pub enum JoinNews {
    /// The connection is open.
    Reached,
    /// The host has sent a text.
    Heard {
        /// The text.
        text: String,
    },
    /// The host cannot be reached, or the connection has been lost.
    Lost,
    /// What was saved during an earlier connection.
    Remembered {
        /// The token for the pupil's seat, as text.
        seat: String,
        /// The pupil's name.
        name: String,
    },
    /// The device was asleep or the page was hidden, and carrom is now active again.
    Awake,
}
