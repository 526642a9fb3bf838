//! A program in its own terminal, whose screen is read as a person would see it.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::io::{Read, Write};
use std::num::NonZeroU16;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use portable_pty::{Child, CommandBuilder, MasterPty, PtySize, SlavePty, native_pty_system};
use rustix::process::{Pid, Signal, kill_process};
use vt100::MouseProtocolMode;

/// How long a test waits for anything before it fails; this is far longer than necessary.
const PATIENCE: Duration = Duration::from_secs(20);

pub(crate) struct Pty {
    child: Box<dyn Child + Send + Sync>,
    seen: Arc<Mutex<Seen>>,
    closing: Arc<AtomicBool>,
    reader: Option<JoinHandle<()>>,
    writer: Option<Box<dyn Write + Send>>,
    master: Option<Box<dyn MasterPty + Send>>,
    /// Kept open, so that the settings can still be read after the program has ended.
    slave: Option<Box<dyn SlavePty + Send>>,
    before: String,
}

/// All the output of the program.
struct Seen {
    screen: vt100::Parser,
    bytes: Vec<u8>,
}

fn cells(number: u16) -> NonZeroU16 {
    NonZeroU16::new(number).unwrap()
}

fn size(columns: u16, rows: u16) -> PtySize {
    PtySize {
        rows,
        cols: columns,
        ..PtySize::default()
    }
}

/// `carrom` with these arguments, as in [`command`].
pub(crate) fn carrom(arguments: &[&str]) -> CommandBuilder {
    command(env!("CARGO_BIN_EXE_carrom"), arguments)
}

/// A program with these arguments, in an environment that is the same on every machine except for
/// its paths.
pub(crate) fn command(program: &str, arguments: &[&str]) -> CommandBuilder {
    let mut command = CommandBuilder::new(program);
    command.args(arguments);
    command.env_clear();
    command.env("PATH", std::env::var_os("PATH").unwrap_or_default());
    command.env("TERM", "xterm-256color");
    command.env("LANG", "C");
    // Nothing is saved in the player's own data folder.
    let data = format!("carrom-pty-data-{}", std::process::id());
    command.env("XDG_DATA_HOME", std::env::temp_dir().join(data));
    command
}

impl Pty {
    /// Starts a program in a terminal of 80 by 24.
    pub(crate) fn start(command: CommandBuilder) -> Self {
        let pair = native_pty_system().openpty(size(80, 24)).unwrap();
        let before = settings(pair.master.as_ref());
        let seen = Arc::new(Mutex::new(Seen {
            screen: vt100::Parser::new(cells(24), cells(80), 0),
            bytes: Vec::new(),
        }));
        let closing = Arc::new(AtomicBool::new(false));
        let mut out = pair.master.try_clone_reader().unwrap();
        let reader = thread::spawn({
            let (seen, closing) = (Arc::clone(&seen), Arc::clone(&closing));
            move || {
                let mut buffer = [0; 1 << 16];
                while let Ok(count @ 1..) = out.read(&mut buffer) {
                    let mut seen = seen.lock().unwrap();
                    seen.screen.process(&buffer[..count]);
                    seen.bytes.extend_from_slice(&buffer[..count]);
                    if closing.load(Ordering::SeqCst) {
                        return;
                    }
                }
            }
        });
        let child = pair.slave.spawn_command(command).unwrap();
        Self {
            child,
            seen,
            closing,
            reader: Some(reader),
            writer: Some(pair.master.take_writer().unwrap()),
            master: Some(pair.master),
            slave: Some(pair.slave),
            before,
        }
    }

    /// Sends `keys` to the program unchanged, including any escape sequences.
    pub(crate) fn press(&mut self, keys: &str) {
        let writer = self.writer.as_mut().unwrap();
        writer.write_all(keys.as_bytes()).unwrap();
        writer.flush().unwrap();
    }

    pub(crate) fn resize(&self, columns: u16, rows: u16) {
        let mut seen = self.seen.lock().unwrap();
        seen.screen.set_size(cells(rows), cells(columns));
        drop(seen);
        let master = self.master.as_ref().unwrap();
        master.resize(size(columns, rows)).unwrap();
    }

    pub(crate) fn pid(&self) -> i32 {
        self.child.process_id().unwrap().try_into().unwrap()
    }

    pub(crate) fn signal(&self, signal: Signal) {
        kill_process(Pid::from_raw(self.pid()).unwrap(), signal).unwrap();
    }

    /// The text that the screen shows now.
    pub(crate) fn screen(&self) -> String {
        self.seen.lock().unwrap().screen.screen().contents()
    }

    /// Every byte that the program has written.
    pub(crate) fn bytes(&self) -> Vec<u8> {
        self.seen.lock().unwrap().bytes.clone()
    }

    /// Waits until the screen shows `text`.
    pub(crate) fn wait_for(&self, text: &str) {
        self.wait_until(text, |screen| screen.contains(text));
    }

    /// Waits until the screen satisfies `wanted`; `what` describes this in the error message.
    pub(crate) fn wait_until(&self, what: &str, wanted: impl Fn(&str) -> bool) {
        let start = Instant::now();
        let (mut read, mut screen) = (0, self.screen());
        while !wanted(&screen) {
            assert!(
                start.elapsed() < PATIENCE,
                "timed out waiting for {what}; the screen shows\n{screen}"
            );
            thread::sleep(Duration::from_millis(2));
            // The text is read again only after output, because reading it takes time.
            let written = self.seen.lock().unwrap().bytes.len();
            if written != read {
                (read, screen) = (written, self.screen());
            }
        }
    }

    /// Waits until the program ends and returns its exit status.
    pub(crate) fn wait(&mut self) -> u32 {
        let start = Instant::now();
        loop {
            if let Some(status) = self.child.try_wait().unwrap() {
                return status.exit_code();
            }
            if start.elapsed() > PATIENCE {
                panic!("still running; the screen shows\n{}", self.screen());
            }
            thread::sleep(Duration::from_millis(2));
        }
    }

    /// Closes the window. The program is made to write once more (`key` must cause this), so that
    /// the reading thread does not block.
    pub(crate) fn hang_up(&mut self, key: &str) {
        self.closing.store(true, Ordering::SeqCst);
        self.press(key);
        self.reader.take().unwrap().join().unwrap();
        self.slave = None;
        self.writer = None;
        self.master = None;
    }

    /// Asserts that the game controls the terminal: raw mode, alternate screen, mouse on, cursor
    /// hidden.
    pub(crate) fn assert_taken(&self) {
        let seen = self.seen.lock().unwrap();
        let screen = seen.screen.screen();
        assert!(screen.alternate_screen());
        assert!(screen.hide_cursor());
        assert!(screen.bracketed_paste());
        assert_ne!(screen.mouse_protocol_mode(), MouseProtocolMode::None);
        drop(seen);
        assert_ne!(self.settings(), self.before, "raw mode");
    }

    /// Waits until the terminal is restored, and asserts that every setting is the same as before
    /// the program started.
    pub(crate) fn assert_restored(&self) {
        self.wait_until("the terminal to be restored", |_| {
            let seen = self.seen.lock().unwrap();
            seen.bytes.ends_with(b"\x1b[?25h")
                || (!seen.screen.screen().alternate_screen() && !seen.screen.screen().hide_cursor())
        });
        let seen = self.seen.lock().unwrap();
        let screen = seen.screen.screen();
        assert!(!screen.alternate_screen());
        assert!(!screen.hide_cursor());
        assert!(!screen.bracketed_paste());
        assert_eq!(screen.mouse_protocol_mode(), MouseProtocolMode::None);
        let text = String::from_utf8_lossy(&seen.bytes);
        for mode in ["1000", "1002", "1003", "1006", "1049", "2004", "2026"] {
            let (on, off) = (format!("\x1b[?{mode}h"), format!("\x1b[?{mode}l"));
            assert!(
                text.rfind(&on) <= text.rfind(&off),
                "mode {mode} is still on"
            );
        }
        drop(seen);
        assert_eq!(self.settings(), self.before);
    }

    fn settings(&self) -> String {
        settings(self.master.as_deref().unwrap())
    }
}

impl Drop for Pty {
    fn drop(&mut self) {
        // A failed test must not leave its program running.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// All settings of a terminal, as text.
fn settings(master: &(impl MasterPty + ?Sized)) -> String {
    format!("{:?}", master.get_termios().unwrap())
}
