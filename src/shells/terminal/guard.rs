//! Sets up and restores the terminal: raw mode, the alternate screen, the mouse, bracketed paste
//! and the cursor, all of them or none.

use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, Ordering};

use crossterm::cursor::{Hide, Show};
use crossterm::event::{
    DisableBracketedPaste, DisableMouseCapture, EnableBracketedPaste, EnableMouseCapture,
};
use crossterm::style::ResetColor;
use crossterm::terminal::{
    EndSynchronizedUpdate, EnterAlternateScreen, LeaveAlternateScreen, disable_raw_mode,
    enable_raw_mode,
};
use crossterm::{execute, queue};

/// Whether the terminal is ours. There is one terminal a process, so this is the
/// process's own; the panic hook and the watchdog reach it from outside.
static HELD: AtomicBool = AtomicBool::new(false);

/// Holds the terminal; restores it when dropped.
#[derive(Debug)]
pub(super) struct Guard(());

impl Guard {
    pub(super) fn take() -> io::Result<Self> {
        let guard = Self(());
        guard.enter()?;
        Ok(guard)
    }

    /// Whether the terminal is held now.
    pub(super) fn holds(&self) -> bool {
        HELD.load(Ordering::SeqCst)
    }

    /// Gives the terminal back until [`Guard::take_again`].
    #[cfg(unix)]
    pub(super) fn give_back(&self) {
        restore();
    }

    /// Takes the terminal again, whatever was done to it in between: a process
    /// stopped from outside had no chance to give it back.
    #[cfg(unix)]
    pub(super) fn take_again(&self) -> io::Result<()> {
        restore();
        self.enter()
    }

    fn enter(&self) -> io::Result<()> {
        HELD.store(true, Ordering::SeqCst);
        enable_raw_mode()?;
        execute!(
            io::stdout(),
            EnterAlternateScreen,
            EnableMouseCapture,
            EnableBracketedPaste,
            Hide
        )
    }
}

impl Drop for Guard {
    fn drop(&mut self) {
        restore();
    }
}

/// Gives the terminal back if it is held; any thread may call this, any number of times. Failures
/// cannot be reported, because the terminal is gone.
pub(super) fn restore() {
    if !HELD.swap(false, Ordering::SeqCst) {
        return;
    }
    // First, because it cannot block: a terminal that takes no more output would
    // otherwise be left raw.
    let _ = disable_raw_mode();
    if let Ok(mut out) = unlocked_stdout() {
        let _ = queue!(
            out,
            // A picture may have been in progress.
            EndSynchronizedUpdate,
            ResetColor,
            DisableBracketedPaste,
            DisableMouseCapture,
            LeaveAlternateScreen,
            Show
        );
        let _ = out.flush();
    }
}

/// Standard output without its lock, which a thread that is stuck in writing may
/// never let go.
#[cfg(unix)]
fn unlocked_stdout() -> io::Result<impl Write> {
    use std::os::fd::AsFd;
    let own = io::stdout().as_fd().try_clone_to_owned()?;
    Ok(io::BufWriter::new(std::fs::File::from(own)))
}

#[cfg(not(unix))]
fn unlocked_stdout() -> io::Result<impl Write> {
    Ok(io::stdout())
}
