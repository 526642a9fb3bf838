//! The messages between a session and the server of its class.

use std::net::{IpAddr, SocketAddrV4};
use std::time::Duration;

use serde_json::Value;

use super::ballot::Vote;
use super::device::LineId;
use super::door::{DoorCode, SeatToken};
use super::protocol::{PupilState, Refusal, Saying};

/// A request of the teacher's carrom to the server of its class.
#[derive(Debug, Clone, PartialEq)]
pub enum HostCall {
    /// Let pupils join.
    Open {
        /// The code to use; `None` for a new one.
        code: Option<DoorCode>,
        /// The address where their devices look for it, if they joined before.
        address: Option<SocketAddrV4>,
    },
    /// Send pupils their states.
    Tell(Vec<(LineId, PupilState)>),
    /// Tell a pupil why they are refused or removed, and disconnect.
    Refuse(LineId, Refusal),
    /// Let nobody join any more, and disconnect everyone.
    Close,
}

/// News for the teacher's carrom from its class.
#[derive(Debug, Clone, PartialEq)]
pub enum HostNews {
    /// Pupils can join, or the reason why they cannot.
    Opened(Result<OpenDoor, String>),
    /// A pupil with the right code asks to join.
    Came {
        /// The connection.
        line: LineId,
        /// The name as it was typed.
        name: String,
        /// Their seat token, if they were here before.
        seat: Option<SeatToken>,
        /// Their new seat token, if they are new.
        fresh: SeatToken,
        /// Where from.
        address: IpAddr,
        /// The time, from a fixed moment.
        at: Duration,
    },
    /// A pupil votes.
    Voted {
        /// The connection.
        line: LineId,
        /// The question, counted from 0.
        question: usize,
        /// Which vote.
        vote: Vote,
        /// The vote as text; an empty text takes it back.
        said: String,
        /// The number of the vote.
        n: u64,
    },
    /// A pupil hands in answers given alone.
    HandedIn {
        /// The connection.
        line: LineId,
        /// The number of the hand-in.
        n: u64,
        /// The file, as it was sent.
        file: Value,
    },
    /// A pupil has left, or cannot be reached.
    Gone(LineId),
}

impl HostNews {
    /// A message of a pupil who has joined; `None` for a second request to join.
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

/// Where pupils join.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OpenDoor {
    /// The code for joining.
    pub code: DoorCode,
    /// The addresses where it listens, the best first.
    pub addresses: Vec<SocketAddrV4>,
    /// Whether the page is served there, or the reason why not: then only other carroms can join.
    pub page: Result<(), String>,
}
