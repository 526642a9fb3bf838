//! The connection of a pupil's carrom to the host. It reconnects after an interruption.

use std::time::Duration;

use serde_json::Value;

use super::form::Entry;
use crate::class::protocol::{
    ClientMessage, HandedIn, HostMessage, LARGEST_HAND_IN, PupilState, PupilStep, Refusal, VERSION,
};
use crate::class::{Said, SeatToken, Vote, is_nickname};
use crate::messages::{JoinCall, JoinNews};
use crate::screens::Context;

/// The longest wait before the first attempt to reconnect and before any later one, in
/// milliseconds.
const BACK_OFF: [u64; 2] = [300, 5000];

/// The connection to the host.
#[derive(Debug, Clone, Default)]
pub(super) struct Link {
    entry: Entry,
    /// The token that returns the pupil to their seat.
    seat: Option<SeatToken>,
    state: LinkState,
    /// How often the connection has failed since the host last sent a state.
    tries: u32,
    /// Why the host has not let the pupil in yet, if the host has given a reason.
    pub(super) held_up: Option<Refusal>,
    /// The number of the last vote on this device.
    n: u64,
    /// A vote that the host has not confirmed yet, and whether it was sent on this connection.
    pending: Option<ClientMessage>,
    said: bool,
    /// The number of the last hand-in on this device.
    handed: u64,
    /// A hand-in to which the host has not replied yet.
    handing_in: Option<ClientMessage>,
}

#[derive(Debug, Clone, PartialEq, Eq, Default)]
enum LinkState {
    #[default]
    /// The device is connecting, or has asked to join.
    Joining,
    In,
    /// The device will try to reconnect after this time.
    Waiting(Duration),
    /// The host has refused, or the pupil has left.
    Over,
}

impl Link {
    /// Connects to the host.
    pub(super) fn dial(entry: Entry, cx: &mut Context) -> Self {
        let mut link = Self {
            entry,
            ..Self::default()
        };
        link.redial(cx);
        link
    }

    fn redial(&mut self, cx: &mut Context) {
        self.state = LinkState::Joining;
        let address = self.entry.address.clone();
        cx.join(JoinCall::Dial { address });
    }

    /// Whether the device is connected and has joined, so that the screen shows the current state.
    pub(super) fn is_in(&self) -> bool {
        self.state == LinkState::In
    }

    /// Whether a vote has not been confirmed yet.
    pub(super) fn is_sending(&self) -> bool {
        self.pending.is_some()
    }

    /// Whether the host has not replied to a hand-in yet.
    pub(super) fn is_handing_in(&self) -> bool {
        self.handing_in.is_some()
    }

    /// Processes an event; returns the message from the host, if the screen has to show it.
    pub(super) fn take(&mut self, news: &JoinNews, cx: &mut Context) -> Option<HostMessage> {
        match news {
            _ if self.state == LinkState::Over => {}
            JoinNews::Remembered { seat, name } => {
                // A different name means a different pupil on the same device.
                if *name == self.entry.name && self.seat.is_none() {
                    self.seat = seat.parse().ok();
                }
            }
            JoinNews::Reached => {
                self.state = LinkState::Joining;
                let join = ClientMessage::Join {
                    v: VERSION,
                    code: self.entry.code.clone(),
                    name: self.entry.name.clone(),
                    seat: self.seat,
                };
                say(&join, cx);
            }
            JoinNews::Heard { text } => return self.hear(text, cx),
            JoinNews::Lost => {
                let wait = self.back_off(cx.seed());
                self.tries += 1;
                self.state = LinkState::Waiting(wait);
            }
            // The connection may have been lost without notice while the device was asleep.
            JoinNews::Awake => self.redial(cx),
        }
        None
    }

    fn hear(&mut self, text: &str, cx: &mut Context) -> Option<HostMessage> {
        // A newer host may send messages that this version does not know.
        let message = HostMessage::read(text)?;
        match &message {
            HostMessage::State(state) => {
                let first = self.state != LinkState::In;
                self.state = LinkState::In;
                self.tries = 0;
                self.held_up = None;
                if is_nickname(&state.name) {
                    self.entry.name.clone_from(&state.name);
                }
                if first && self.seat != Some(state.seat) {
                    cx.join(JoinCall::Remember {
                        seat: state.seat.to_string(),
                        name: self.entry.name.clone(),
                        code: self.entry.code.clone(),
                    });
                }
                self.seat = Some(state.seat);
                if state.n >= self.n {
                    self.pending = None;
                } else {
                    self.said &= !first;
                    self.say_again(state, cx);
                }
                self.n = self.n.max(state.n);
                self.hear_of_hand_in(state.handed, first, cx);
            }
            HostMessage::No { why } if why.is_passing() => {
                self.held_up = Some(*why);
                return self.take(&JoinNews::Lost, cx);
            }
            HostMessage::No { .. } => self.hang_up(cx),
        }
        Some(message)
    }

    /// Sends an unconfirmed vote again after a loss of the connection, once its question is asked
    /// again: a restarted host first waits for the class.
    fn say_again(&mut self, state: &PupilState, cx: &mut Context) {
        let open = state.step.vote();
        match &self.pending {
            _ if self.said => {}
            Some(ClientMessage::Vote { q, .. })
                if *q == state.q && state.step == PupilStep::Lobby => {}
            Some(message @ ClientMessage::Vote { q, vote, .. })
                if *q == state.q && open == Some(*vote) =>
            {
                say(message, cx);
                self.said = true;
            }
            _ => self.pending = None,
        }
    }

    /// Processes the result of a hand-in. A hand-in without a reply is sent again after a loss of
    /// the connection.
    fn hear_of_hand_in(&mut self, handed: Option<HandedIn>, first: bool, cx: &mut Context) {
        let heard = handed.map_or(0, |it| it.n);
        if heard >= self.handed {
            self.handing_in = None;
        } else if first && let Some(message) = &self.handing_in {
            say(message, cx);
        }
        self.handed = self.handed.max(heard);
    }

    /// Hands in this file; returns whether it is small enough.
    pub(super) fn hand_in(&mut self, file: Value, cx: &mut Context) -> bool {
        let n = self.handed.saturating_add(1);
        let message = ClientMessage::HandIn { n, file };
        let text = message.to_text();
        if text.len() > LARGEST_HAND_IN {
            return false;
        }
        if self.is_in() {
            cx.join(JoinCall::Say { text });
        }
        self.handed = n;
        self.handing_in = Some(message);
        true
    }

    /// Votes; `None` withdraws the vote.
    pub(super) fn vote(&mut self, q: usize, vote: Vote, said: Option<Said>, cx: &mut Context) {
        self.n = self.n.saturating_add(1);
        let said = said.map(Said::to_text).unwrap_or_default();
        let n = self.n;
        let message = ClientMessage::Vote { q, vote, said, n };
        if self.is_in() {
            say(&message, cx);
        }
        self.said = self.is_in();
        self.pending = Some(message);
    }

    /// Leaves the class permanently.
    pub(super) fn hang_up(&mut self, cx: &mut Context) {
        if self.is_in() {
            say(&ClientMessage::Leave, cx);
        }
        cx.join(JoinCall::HangUp);
        self.state = LinkState::Over;
    }

    pub(super) fn advance(&mut self, passed: Duration, cx: &mut Context) {
        if let LinkState::Waiting(left) = &mut self.state {
            *left = left.saturating_sub(passed);
            if left.is_zero() {
                self.redial(cx);
            }
        }
    }

    pub(super) fn wake(&self) -> Option<Duration> {
        match self.state {
            LinkState::Waiting(left) => Some(left),
            _ => None,
        }
    }

    /// The wait before the next attempt: it differs between pupils, so that a whole class does not
    /// reconnect at once, and its bounds double with each attempt, up to a maximum.
    fn back_off(&self, seed: u64) -> Duration {
        let [least, most] = BACK_OFF;
        let longest = most.min(least << self.tries.min(8));
        let mixed = (seed ^ u64::from(self.tries) << 32).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 40;
        Duration::from_millis(longest / 2 + mixed % (longest / 2 + 1))
    }
}

fn say(message: &ClientMessage, cx: &mut Context) {
    let text = message.to_text();
    cx.join(JoinCall::Say { text });
}
