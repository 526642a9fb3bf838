//! Signals: those that end carrom, those that stop and continue it, and the one that reports a new
//! window size.

use std::io;
use std::process;
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use rustix::process::{Signal, getpgrp, getsid, kill_current_process_group};
use signal_hook::consts::{SIGCONT, SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGTSTP, SIGWINCH};
use signal_hook::iterator::Signals;

use super::message::{Inbox, Message};
use super::{guard, spawn};
use crate::messages::Input;

/// How long the drawing thread may take to quit, and how long restoring the terminal may then take.
const PATIENCE: Duration = Duration::from_millis(300);

/// Starts the thread that waits for signals.
///
/// This thread is also a watchdog. The drawing thread may be stuck in a write to a blocked
/// terminal. Therefore this thread restores the terminal and ends the process if the drawing thread
/// has not ended it within [`PATIENCE`].
pub(super) fn watch(inbox: Inbox) -> io::Result<()> {
    let mut signals = Signals::new([SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP, SIGCONT, SIGWINCH])?;
    let wait = move || {
        for signal in signals.forever() {
            let message = match signal {
                SIGTSTP => Message::Stop,
                SIGCONT => Message::Continue,
                SIGWINCH => match crossterm::terminal::size() {
                    Ok((columns, rows)) => Message::Input(Input::Resize(columns, rows)),
                    Err(_) => continue,
                },
                _ => Message::Leave(signal),
            };
            let leave = matches!(message, Message::Leave(_));
            // A send fails only when the run is over. Then there is nothing to stop or to wake, but
            // the process must still end.
            let _ = inbox.send(message);
            if leave {
                thread::sleep(PATIENCE);
                end(signal);
            }
        }
    };
    spawn("signals", wait).map(drop)
}

/// Restores the terminal, and ends the process with the exit status that a shell reports for a
/// process ended by this signal.
fn end(signal: i32) -> ! {
    // Writing to a stuck terminal would hold up this thread as well.
    let (done, restored) = mpsc::channel();
    thread::spawn(move || {
        guard::restore();
        let _ = done.send(());
    });
    let _ = restored.recv_timeout(PATIENCE);
    process::exit(128 + signal)
}

/// Whether there is a shell that could continue carrom after it was stopped. A shell with job
/// control puts every job in its own process group.
pub(super) fn can_stop() -> bool {
    getsid(None).is_ok_and(|session| session != getpgrp())
}

/// Stops the whole job until it is continued; then [`Message::Continue`] arrives. If only carrom
/// stopped, the program that started it, such as `cargo run`, would keep the shell waiting.
pub(super) fn stop() {
    // This could fail only if the group did not exist, but this process belongs to the group.
    let _ = kill_current_process_group(Signal::STOP);
}
