//! What a session asks of whoever serves its class, and what it hears.

use std::net::{IpAddr, SocketAddrV4};
use std::time::Duration;

use serde_json::Value;

use super::ballot::Vote;
use super::device::LineId;
use super::door::{DoorCode, SeatToken};
use super::protocol::{PupilState, Refusal, Saying};

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

impl HostNews {
    /// What somebody who is in says; `None` if they ask to come in once more.
    pub(crate) fn said(line: LineId, saying: Saying) -> Option<Self> {
        Some(match saying {
            Saying::Vote { q, vote, said, n } => Self::Voted {
                line,
                question: q,
                vote,
                said,
                n,
            },
            Saying::HandIn { n, file } => Self::HandedIn { line, n, file },
            Saying::Leave => Self::Gone(line),
            Saying::Join { .. } => return None,
        })
    }
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
