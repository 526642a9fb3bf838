//! The connection to a participant's device.

use std::collections::BTreeSet;
use std::net::IpAddr;

use super::ballot::Vote;
use super::protocol::HandedIn;

/// The unique number of a connection.
pub type ConnectionId = u64;

/// The device of a participant, while this program serves the class.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Device {
    /// The device's connection; `None` while the device is disconnected.
    pub(super) connection: Option<ConnectionId>,
    /// The address of its current or last connection.
    pub(super) address: Option<IpAddr>,
    /// The number of the last vote that was handled.
    pub(super) n: u64,
    /// The number of the last state sent on this connection.
    pub(super) rev: u64,
    /// The last vote, if it did not fit its question: the question, and which of its two votes it
    /// was.
    pub(super) misfit: Option<(usize, Vote)>,
    /// The result of the last hand-in.
    pub(super) handed: Option<HandedIn>,
    /// The number of hand-ins, and whether any of them is stored.
    pub(super) times: usize,
    pub(super) has_handed_in: bool,
}

impl Device {
    /// The device's connection, if it is one of these.
    pub(super) fn among(&self, connections: &BTreeSet<ConnectionId>) -> Option<ConnectionId> {
        self.connection.filter(|it| connections.contains(it))
    }

    /// This device if it is connected, including hand-ins by the earlier one; otherwise the earlier
    /// one.
    pub(super) fn or_earlier(self, earlier: &Self) -> Self {
        match self.connection {
            None => *earlier,
            Some(_) => Self {
                handed: self.handed.or(earlier.handed),
                has_handed_in: self.has_handed_in || earlier.has_handed_in,
                ..self
            },
        }
    }
}
