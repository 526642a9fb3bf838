//! Messages from other threads to the drawing thread.

use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::Sender;

use crate::messages::{Input, Key};
#[cfg(unix)]
use crate::widgets::Blocks;

/// The largest number of inputs from the user that may wait to be handled. Nobody makes that many
/// between two frames.
const MOST_WAITING: usize = 1000;

/// Sends messages from the keyboard and from signals, and counts those not yet received.
#[derive(Debug, Clone)]
pub(super) struct Inbox {
    sender: Sender<Message>,
    /// The number of waiting inputs from the user.
    waiting: Arc<AtomicUsize>,
    /// The number of waiting requests to quit. Inputs from the user before such a request are
    /// discarded.
    leaving: Arc<AtomicUsize>,
}

impl Inbox {
    pub(super) fn new(sender: Sender<Message>) -> Self {
        Self {
            sender,
            waiting: Arc::default(),
            leaving: Arc::default(),
        }
    }

    /// Sends a message; returns whether anybody still receives it. Inputs from the user are dropped
    /// if too many wait.
    pub(super) fn send(&self, message: Message) -> bool {
        if message.leaves() {
            self.leaving.fetch_add(1, Ordering::SeqCst);
        } else if message.is_typed()
            && self.waiting.load(Ordering::SeqCst) >= MOST_WAITING
            && self.leaving.load(Ordering::SeqCst) == 0
        {
            return true;
        }
        if message.is_typed() {
            self.waiting.fetch_add(1, Ordering::SeqCst);
        }
        self.sender.send(message).is_ok()
    }

    /// Records that a message was received; returns whether it should be handled.
    pub(super) fn take(&self, message: &Message) -> bool {
        if message.is_typed() {
            self.waiting.fetch_sub(1, Ordering::SeqCst);
        }
        if message.leaves() {
            self.leaving.fetch_sub(1, Ordering::SeqCst);
            return true;
        }
        !message.is_typed() || self.leaving.load(Ordering::SeqCst) == 0
    }
}

/// An event for the main loop.
#[derive(Debug)]
pub(super) enum Message {
    Input(Input),
    /// There is news from the class that this program serves.
    Hosted,
    /// The terminal can no longer be read.
    Lost(io::Error),
    /// The block elements that the terminal is known to draw.
    #[cfg(unix)]
    Blocks(Blocks),
    /// The signal with this number requests that carrom end.
    #[cfg(unix)]
    Leave(i32),
    /// The player has pressed Ctrl+Z to return to the shell.
    #[cfg(unix)]
    Stop,
    /// carrom was stopped and is running again.
    #[cfg(unix)]
    Continue,
}

impl Message {
    /// Whether the message is an input from the user.
    fn is_typed(&self) -> bool {
        matches!(
            self,
            Self::Input(Input::Key(_) | Input::Mouse(_) | Input::Paste(_))
        )
    }

    /// Whether the message is a request to quit.
    fn leaves(&self) -> bool {
        match self {
            Self::Input(Input::Key(Key::Ctrl('c'))) => true,
            #[cfg(unix)]
            Self::Leave(_) => true,
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::mpsc;

    use super::*;

    fn key(c: char) -> Message {
        Message::Input(Input::Key(Key::Char(c)))
    }

    /// How many of these messages are handled if all are sent at once.
    fn counted(messages: impl Iterator<Item = Message>) -> usize {
        let (sender, receiver) = mpsc::channel();
        let inbox = Inbox::new(sender);
        messages.for_each(|message| assert!(inbox.send(message)));
        let counted = receiver.try_iter().filter(|it| inbox.take(it)).count();
        assert_eq!(inbox.waiting.load(Ordering::SeqCst), 0);
        counted
    }

    #[test]
    fn excess_keys_in_a_burst_are_dropped() {
        assert_eq!(counted((0..5).map(|_| key('a'))), 5);
        assert_eq!(counted((0..100_000).map(|_| key('a'))), MOST_WAITING);
        let sizes = (0..5000).map(|_| Message::Input(Input::Resize(80, 24)));
        assert_eq!(counted(sizes), 5000);
    }

    #[test]
    fn keys_typed_before_quitting_are_discarded() {
        let leave = || Message::Input(Input::Key(Key::Ctrl('c')));
        let typed = || (0..100_000).map(|_| key('a'));
        assert_eq!(counted(typed().chain([leave()])), 1);
        assert_eq!(counted(typed().chain([leave(), key('y')])), 2);
    }
}
