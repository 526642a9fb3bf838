//! The app in a terminal, through crossterm.
//!
//! The thread that called [`run`] owns the app and draws. One thread reads the keyboard and the
//! mouse (on Unix two: one reads bytes, the other decodes them), one waits for signals (on Unix),
//! and one carries out requests to the store. The host of a class has a thread that accepts
//! connections, and each connection has threads of its own. These threads change the app only
//! through messages; while nothing moves, all of them are blocked.

mod crash;
#[cfg(unix)]
mod decoder;
mod guard;
mod message;
mod pace;
mod reader;
#[cfg(unix)]
mod signals;
mod store_worker;
mod surroundings;
#[cfg(unix)]
mod tty;
#[cfg(unix)]
mod version;

use std::io::{self, BufWriter, ErrorKind, Stdout, Write};
use std::mem::ManuallyDrop;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use anyhow::Context;
use crossterm::queue;
use crossterm::terminal::{BeginSynchronizedUpdate, EndSynchronizedUpdate};
use ratatui::backend::CrosstermBackend;
use ratatui::layout::Rect;
use ratatui::{Terminal, TerminalOptions, Viewport};

pub use crash::report_crashes;
pub use surroundings::{charset, check, depth};

use crate::app::App;
use crate::messages::{Effect, Input};
use crate::shells::host::HostOptions;
use crate::shells::outside::Outside;
use crate::shells::{AppHolder, receive};
use crate::store::Store;
use guard::Guard;
use message::{Inbox, Message};
use pace::Pace;
use store_worker::StoreWorker;

// What failed, for error messages.
const SET_UP: &str = "cannot set up the terminal";
const WRITE: &str = "cannot write to the terminal";
const READ: &str = "cannot read from the terminal";

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// The player has quit.
    Quit,
    /// The signal with this number ended carrom.
    Signal(i32),
}

/// A terminal that collects each frame in memory and writes it in one go.
///
/// The terminal is never dropped. Dropping it would show the cursor, which the guard already does.
/// If its window is closed, ratatui would then print an error to standard error, which is closed
/// too, and panic.
type FixedTerminal = ManuallyDrop<Terminal<CrosstermBackend<BufWriter<Stdout>>>>;

/// The largest screen that is drawn, in columns and rows. This limits the memory used: a
/// terminal may report any size. The rest of a larger terminal stays empty.
const LARGEST: (u16, u16) = (1000, 500);

/// The longest time for which messages are processed without a new frame.
const UNSEEN: Duration = Duration::from_millis(50);

/// The area that is drawn in a terminal of this size.
fn drawn(columns: u16, rows: u16) -> Rect {
    Rect::new(0, 0, columns.min(LARGEST.0), rows.min(LARGEST.1))
}

pub(super) fn spawn(
    name: &str,
    work: impl FnOnce() + Send + 'static,
) -> io::Result<JoinHandle<()>> {
    thread::Builder::new().name(name.into()).spawn(work)
}

/// Runs `app` in the terminal until the player quits or a signal ends it. The app's data is kept
/// in `store`, and `host` contains the options for serving a class. The terminal is restored
/// however the run ends.
///
/// # Errors
/// If the terminal cannot be used, or can no longer be used.
pub fn run(app: App, store: Store, host: HostOptions) -> anyhow::Result<Ending> {
    TerminalRun::set_up(app, store, host)
        .context(SET_UP)?
        .play()
}

/// The app, with everything that it needs to run in the terminal.
struct TerminalRun {
    app: App,
    screen: FixedTerminal,
    guard: Guard,
    messages: Receiver<Message>,
    inbox: Inbox,
    store_worker: StoreWorker,
    outside: Outside,
    pace: Pace,
}

impl TerminalRun {
    fn set_up(app: App, store: Store, host: HostOptions) -> io::Result<Self> {
        let (sender, messages) = mpsc::channel();
        let [hosted, to_app] = [sender.clone(), sender.clone()];
        // If nobody receives the message, carrom is quitting.
        let outside = Outside::new(
            host,
            move || drop(hosted.send(Message::Hosted)),
            move |input| drop(to_app.send(Message::Input(input))),
        );
        let inbox = Inbox::new(sender.clone());
        #[cfg(unix)]
        signals::watch(inbox.clone())?;
        let store_worker = StoreWorker::start(store, sender)?;
        let guard = Guard::take()?;
        reader::start(inbox.clone())?;
        // The theme handles NO_COLOR. By default, crossterm would remove bold and reverse video
        // too.
        crossterm::style::force_color_output(true);
        let backend = CrosstermBackend::new(BufWriter::with_capacity(1 << 16, io::stdout()));
        let (columns, rows) = crossterm::terminal::size()?;
        let viewport = Viewport::Fixed(drawn(columns, rows));
        let screen = Terminal::with_options(backend, TerminalOptions { viewport })?;
        Ok(Self {
            app,
            screen: ManuallyDrop::new(screen),
            guard,
            messages,
            inbox,
            store_worker,
            outside,
            pace: Pace::new(Instant::now()),
        })
    }

    fn play(mut self) -> anyhow::Result<Ending> {
        self.fit_again()?;
        loop {
            if self.guard.holds() && self.pace.is_due(Instant::now()) {
                self.pace.drawn(Instant::now());
                self.draw().context(WRITE)?;
            }
            let mut first = self.wait()?;
            let effects = self.pace.live(&mut self.app, Instant::now());
            self.carry_out_all(effects);
            // Handles all waiting messages before one frame; if they keep coming, a frame is drawn
            // now and then.
            let start = Instant::now();
            while !self.app.has_quit()
                && start.elapsed() < UNSEEN
                && let Some(message) = first.take().or_else(|| self.messages.try_recv().ok())
            {
                if self.inbox.take(&message)
                    && let Some(ending) = self.take(message)?
                {
                    return Ok(ending);
                }
            }
            if self.app.has_quit() {
                return Ok(Ending::Quit);
            }
        }
    }

    /// Blocks until there is something to do: a message, time to advance the app, or time for the
    /// next frame.
    fn wait(&self) -> anyhow::Result<Option<Message>> {
        // While the terminal is released, nobody sees the game, so nothing moves.
        let until = (self.guard.holds())
            .then(|| self.pace.next(self.app.wake()))
            .flatten();
        let left = until.map(|until| until.saturating_duration_since(Instant::now()));
        match receive(&self.messages, left) {
            Ok(message) => Ok(Some(message)),
            Err(RecvTimeoutError::Timeout) => Ok(None),
            Err(RecvTimeoutError::Disconnected) => {
                Err(io::Error::from(ErrorKind::BrokenPipe)).context(READ)
            }
        }
    }

    /// Handles a message; returns how the run ends if a signal ends it.
    fn take(&mut self, message: Message) -> anyhow::Result<Option<Ending>> {
        self.pace.outdated();
        match message {
            Message::Input(Input::Resize(columns, rows)) => self.fit(columns, rows)?,
            Message::Input(input) => self.input(&input),
            Message::Hosted => {
                let news = self.outside.news();
                self.input(&news);
            }
            Message::Lost(error) => return Err(error).context(READ),
            #[cfg(unix)]
            Message::Blocks(blocks) => self.app.settings_mut().known_blocks = blocks,
            #[cfg(unix)]
            Message::Leave(signal) => return Ok(Some(Ending::Signal(signal))),
            #[cfg(unix)]
            Message::Stop => {
                if signals::can_stop() {
                    self.guard.give_back();
                    signals::stop();
                }
            }
            #[cfg(unix)]
            Message::Continue => {
                self.guard.take_again().context(SET_UP)?;
                self.pace = Pace::new(Instant::now());
                self.fit_again()?;
            }
        }
        Ok(None)
    }

    /// Fits the picture to the terminal's current size.
    fn fit_again(&mut self) -> anyhow::Result<()> {
        let size = self.screen.size().context(SET_UP)?;
        self.fit(size.width, size.height)
    }

    /// Fits the picture to a terminal of this size, so that all of it is drawn again.
    fn fit(&mut self, columns: u16, rows: u16) -> anyhow::Result<()> {
        let area = drawn(columns, rows);
        // `clear` cannot be used: it requests the cursor's position, and the reply goes to the
        // reader.
        self.screen.resize(area).context(WRITE)?;
        self.input(&Input::Resize(area.width, area.height));
        Ok(())
    }

    fn draw(&mut self) -> io::Result<()> {
        queue!(self.screen.backend_mut(), BeginSynchronizedUpdate)?;
        let app = &self.app;
        self.screen.draw(|frame| app.draw(frame))?;
        queue!(self.screen.backend_mut(), EndSynchronizedUpdate)?;
        Write::flush(self.screen.backend_mut())
    }
}

impl AppHolder for TerminalRun {
    fn app(&mut self) -> &mut App {
        &mut self.app
    }

    fn carry_out(&mut self, effect: Effect) -> Option<Input> {
        let call = self.outside.carry_out(effect)?;
        let ticket = call.ticket;
        let is_late = self.store_worker.ask(call);
        is_late.then_some(Input::Saving(ticket))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_part_of_a_huge_screen_is_drawn() {
        assert_eq!(drawn(80, 24), Rect::new(0, 0, 80, 24));
        assert_eq!(drawn(300, 100), Rect::new(0, 0, 300, 100));
        let most = drawn(u16::MAX, u16::MAX);
        // ratatui keeps two buffers of this size.
        assert!(most.area() < 1_000_000, "{most}");
    }
}
