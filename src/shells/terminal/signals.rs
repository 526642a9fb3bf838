//! Signals: those that end carrom, those that stop it and let it go on, and the one
//! that tells of another size of the window.

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

/// How long the thread that draws may take to leave.
const PATIENCE: Duration = Duration::from_millis(300);

/// Starts the thread that waits for signals.
///
/// It is a watchdog too. The drawing thread may be stuck in writing to a blocked terminal, and the
/// reading thread spins once its window is closed; so a process that is still running after
/// [`PATIENCE`] is ended from this thread, with the terminal restored.
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
            // A send fails only when the run is over: then there is nobody to stop
            // or to wake, but the process must still end.
            let _ = inbox.send(message);
            if leave {
                thread::sleep(PATIENCE);
                end(signal);
            }
        }
    };
    spawn("signals", wait).map(drop)
}

/// Ends the process as one that a signal ended.
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

/// Whether there is a shell that could let a stopped carrom go on: one with job
/// control puts every job in a process group of its own.
pub(super) fn can_stop() -> bool {
    getsid(None).is_ok_and(|session| session != getpgrp())
}

/// Stops the whole job until it is continued, which arrives as
/// [`Message::Continue`]. The whole job, because whatever started carrom, such as
/// `cargo run`, would otherwise keep the shell waiting.
pub(super) fn stop() {
    // Fails only if there is no such group, and it is our own.
    let _ = kill_current_process_group(Signal::STOP);
}
