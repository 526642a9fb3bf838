//! The messages between a session and the server of its class.

use std::net::{IpAddr, SocketAddrV4};
use std::time::Duration;

use super::device::ConnectionId;
use super::join_code::{JoinCode, SeatToken};
use super::protocol::{ClientMessage, PupilState, Refusal};

/// A request from the teacher's carrom to the server of its class.
#[derive(Debug, Clone, PartialEq)]
pub enum HostCall {
    /// Let pupils join.
    Open {
        /// The code to use; `None` for a new one.
        code: Option<JoinCode>,
        /// The address at which devices that joined earlier look for the class.
        address: Option<SocketAddrV4>,
    },
    /// Send pupils their states.
    Tell(Vec<(ConnectionId, PupilState)>),
    /// Tell a pupil why they are refused or removed, and disconnect them.
    Refuse(ConnectionId, Refusal),
    /// Stop pupils from joining, and disconnect everyone.
    Close,
}

/// News from the class for the teacher's carrom.
#[derive(Debug, Clone, PartialEq)]
pub enum HostNews {
    /// How pupils can join, or the reason why they cannot.
    Opened(Result<JoinDetails, String>),
    /// A pupil who has the right code is asking to join.
    Came(Newcomer),
    /// A pupil who has joined has sent this message.
    Said(ConnectionId, ClientMessage),
    /// A pupil has left, or cannot be reached.
    Gone(ConnectionId),
}

/// A pupil who is asking to join.
#[derive(Debug, Clone, PartialEq)]
pub struct Newcomer {
    /// The connection.
    pub connection: ConnectionId,
    /// The name as it was typed.
    pub name: String,
    /// Their seat token, if they joined before.
    pub seat: Option<SeatToken>,
    /// The seat token that they get if they are new.
    pub fresh: SeatToken,
    /// The address of the device.
    pub address: IpAddr,
    /// The time of the request, counted from a fixed moment.
    pub at: Duration,
}

/// How pupils can join.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct JoinDetails {
    /// The code for joining.
    pub code: JoinCode,
    /// The addresses that the server listens on, best first.
    pub addresses: Vec<SocketAddrV4>,
    /// `Ok` if the page is served at these addresses; otherwise the reason why it is not, and then
    /// only pupils who have installed carrom can join.
    pub page: Result<(), String>,
}
