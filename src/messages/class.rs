//! A class on its own devices: what the teacher's carrom and a pupil's ask of whoever
//! reaches the other, and what they hear.

use std::net::{IpAddr, SocketAddrV4};
use std::time::Duration;

use serde_json::Value;

use crate::class::protocol::{PupilState, Refusal};
use crate::class::{DoorCode, SeatToken, Vote};

/// The number of a connection, which no other one ever has.
pub type LineId = u64;

/// What a teacher's carrom asks of whoever serves its class.
#[derive(Debug, Clone, PartialEq)]
pub enum HostCall {
    /// Let pupils come in.
    Open {
        /// With this code; without one with a new one.
        code: Option<DoorCode>,
        /// Where their devices look for it, if they were in before.
        address: Option<SocketAddrV4>,
    },
    /// Tell pupils how things stand, each for themselves.
    Tell(Vec<(LineId, PupilState)>),
    /// Tell somebody why they are not let in, or no longer, and hang up.
    Refuse(LineId, Refusal),
    /// Let nobody in any more, and hang up on all.
    Close,
}

/// What a teacher's carrom hears of its class.
#[derive(Debug, Clone, PartialEq)]
pub enum HostNews {
    /// Pupils can come in, or why not.
    Opened(Result<OpenDoor, String>),
    /// Somebody with the right code wants to come in.
    Came {
        /// The connection.
        line: LineId,
        /// The name as it was typed.
        name: String,
        /// What brings them back, if they were here.
        seat: Option<SeatToken>,
        /// What will bring them back, if they are new.
        fresh: SeatToken,
        /// Where from.
        address: IpAddr,
        /// When, since any moment that is the same for all.
        at: Duration,
    },
    /// Somebody votes.
    Voted {
        /// The connection.
        line: LineId,
        /// The question, counted from 0.
        question: usize,
        /// Which vote.
        vote: Vote,
        /// What is said, as text; nothing takes it back.
        said: String,
        /// The number of the vote.
        n: u64,
    },
    /// Somebody hands in what they have answered alone.
    HandedIn {
        /// The connection.
        line: LineId,
        /// The number of what is handed in.
        n: u64,
        /// The file, as it was sent.
        file: Value,
    },
    /// Somebody has gone, or cannot be reached.
    Gone(LineId),
}

/// Where pupils come in.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OpenDoor {
    /// The code that lets them in.
    pub code: DoorCode,
    /// Where it listens, the best first.
    pub addresses: Vec<SocketAddrV4>,
    /// Whether the page is served there, or why not: then only other carroms can join.
    pub page: Result<(), String>,
}

/// What a pupil's carrom asks of whoever reaches the host.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum JoinCall {
    /// Reach the host at this address; hang up on any other.
    Dial(String),
    /// Say this.
    Say(String),
    /// Remember what brings the pupil back there, and under which name.
    Remember {
        /// What brings them back, as text.
        seat: String,
        /// Their name.
        name: String,
        /// The code of the class.
        code: String,
    },
    /// Hang up.
    HangUp,
}

/// What a pupil's carrom hears.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum JoinNews {
    /// The host is reached.
    Reached,
    /// The host says this.
    Heard(String),
    /// The host cannot be reached, or no longer: why.
    Lost(String),
    /// What was remembered of an earlier time there: the token, and the name.
    Remembered(String, String),
    /// The device was asleep or out of sight, and is back.
    Awake,
}
