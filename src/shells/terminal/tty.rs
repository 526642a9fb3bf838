//! The input of a terminal on Unix.

use std::collections::VecDeque;
use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::os::fd::AsFd;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, SyncSender};
use std::thread;
use std::time::Duration;

use crossterm::event::Event;

use super::decoder::Decoder;
use super::message::Message;
use super::reader::message;
use super::{spawn, version};
use crate::shells::receive;

/// The largest number of blocks of input that are read ahead of the decoder.
const READ_AHEAD: usize = 16;

/// The terminal's input as messages.
pub(super) struct Tty {
    bytes: Receiver<io::Result<Vec<u8>>>,
    decoder: Decoder,
    events: VecDeque<Event>,
}

impl Tty {
    /// Starts reading from standard input, which is a terminal.
    ///
    /// A separate thread reads, because the decoder needs a time limit and not every system can
    /// wait for a terminal with a time limit.
    pub(super) fn open() -> io::Result<Self> {
        let terminal = File::from(io::stdin().as_fd().try_clone_to_owned()?);
        let (sender, bytes) = mpsc::sync_channel(READ_AHEAD);
        spawn("terminal", move || read(terminal, &sender))?;
        Ok(Self {
            bytes,
            decoder: Decoder::default(),
            events: VecDeque::new(),
        })
    }

    /// Waits for the next event or reply; returns its message, or `None` if carrom ignores it.
    pub(super) fn next(&mut self) -> io::Result<Option<Message>> {
        loop {
            if let Some(version) = self.decoder.take_version() {
                return Ok(Some(Message::Blocks(version::blocks(&version))));
            }
            if let Some(event) = self.events.pop_front() {
                return Ok(message(&event));
            }
            match receive(&self.bytes, self.decoder.patience()) {
                Ok(bytes) => self.decoder.feed(&bytes?, &mut self.events),
                Err(RecvTimeoutError::Timeout) => self.decoder.pause(&mut self.events),
                Err(RecvTimeoutError::Disconnected) => return Err(ErrorKind::BrokenPipe.into()),
            }
        }
    }
}

/// Reads until the terminal is closed or the receiver is dropped.
fn read(mut terminal: File, sender: &SyncSender<io::Result<Vec<u8>>>) {
    let mut buffer = [0; 1 << 12];
    loop {
        let bytes = match terminal.read(&mut buffer) {
            Ok(0) => Err(ErrorKind::UnexpectedEof.into()),
            Ok(count) => Ok(buffer.get(..count).unwrap_or_default().to_vec()),
            Err(error) if error.kind() == ErrorKind::Interrupted => continue,
            // Another program may have set the terminal to non-blocking mode.
            Err(error) if error.kind() == ErrorKind::WouldBlock => {
                thread::sleep(Duration::from_millis(10));
                continue;
            }
            Err(error) => Err(error),
        };
        let is_last = bytes.is_err();
        if sender.send(bytes).is_err() || is_last {
            return;
        }
    }
}
