//! How somebody on a device of their own is reached.

use std::net::IpAddr;

use super::ballot::Vote;
use super::protocol::HandedIn;

/// The number of a connection, which no other one ever has.
pub type LineId = u64;

/// The device of somebody, for as long as this carrom serves the class.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Device {
    /// Its connection; `None` while it is away.
    pub(super) line: Option<LineId>,
    /// Where its connection comes from, or came from.
    pub(super) address: Option<IpAddr>,
    /// The number of the last vote that was handled.
    pub(super) n: u64,
    /// The number of the last state that this connection was told.
    pub(super) rev: u64,
    /// Where the last vote was, if it did not fit the question.
    pub(super) misfit: Option<(usize, Vote)>,
    /// What came of the last that was handed in.
    pub(super) handed: Option<HandedIn>,
    /// How often something was, and whether something of it is kept.
    pub(super) times: usize,
    pub(super) has_handed_in: bool,
}

impl Device {
    /// This one in the place of another, where it is connected.
    pub(super) fn or_earlier(self, earlier: &Self) -> Self {
        match self.line {
            None => *earlier,
            Some(_) => Self {
                handed: self.handed.or(earlier.handed),
                has_handed_in: self.has_handed_in || earlier.has_handed_in,
                ..self
            },
        }
    }
}
