//! Sets up and restores the terminal: raw mode, the alternate screen, the mouse, bracketed paste
//! and the cursor, either all of them or none.

use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, Ordering};

use crossterm::cursor::{Hide, Show};
use crossterm::event::{
    DisableBracketedPaste, DisableMouseCapture, EnableBracketedPaste, EnableMouseCapture,
};
#[cfg(unix)]
use crossterm::style::Print;
use crossterm::style::ResetColor;
use crossterm::terminal::{
    EndSynchronizedUpdate, EnterAlternateScreen, LeaveAlternateScreen, disable_raw_mode,
    enable_raw_mode,
};
use crossterm::{execute, queue};

#[cfg(unix)]
use super::version;

/// Whether carrom has set up the terminal. This is global because a process has one terminal, and
/// because the panic hook and the watchdog use it.
static HELD: AtomicBool = AtomicBool::new(false);

/// Keeps the terminal set up; restores it when dropped.
#[derive(Debug)]
pub(super) struct Guard(());

impl Guard {
    pub(super) fn take() -> io::Result<Self> {
        let guard = Self(());
        guard.enter()?;
        Ok(guard)
    }

    /// Whether the terminal is set up now.
    pub(super) fn holds(&self) -> bool {
        HELD.load(Ordering::SeqCst)
    }

    /// Restores the terminal until [`Guard::take_again`].
    #[cfg(unix)]
    pub(super) fn give_back(&self) {
        restore();
    }

    /// Sets the terminal up again, whatever its state: if another process stopped carrom, carrom
    /// could not restore the terminal first.
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
        )?;
        // Nobody waits for the reply. It arrives before any key that a player presses after
        // seeing the first frame. That frame clears the screen, so a terminal that does not know
        // the request and prints part of it does no harm.
        #[cfg(unix)]
        execute!(io::stdout(), Print(version::REQUEST))?;
        Ok(())
    }
}

impl Drop for Guard {
    fn drop(&mut self) {
        restore();
    }
}

/// Restores the terminal if it is set up. Any thread may call this any number of times. Errors are
/// not reported, because they mean that the terminal is closed.
pub(super) fn restore() {
    if !HELD.swap(false, Ordering::SeqCst) {
        return;
    }
    // Raw mode is left first because leaving it cannot block. A terminal that accepts no more
    // output would otherwise stay in raw mode.
    let _ = disable_raw_mode();
    if let Ok(mut out) = unlocked_stdout() {
        let _ = queue!(
            out,
            // A frame may have been in progress.
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

/// Standard output without its lock, because a thread that is stuck in a write never releases the
/// lock.
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
