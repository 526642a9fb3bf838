//! carrom in a real terminal: it starts, plays, follows the window's size, and restores the
//! terminal however it ends.

use std::env;
use std::process;
use std::thread;
use std::time::{Duration, Instant};

use carrom::app::App;
use carrom::messages::Key;
use carrom::screens::{Context, Hosted, Next, Screen, Settings, SharedAction, View};
use carrom::shells::FRAME;
use carrom::shells::host::HostOptions;
use carrom::shells::terminal::{self, Ending};
use carrom::store::Store;
use carrom::widgets::input::KeyTable;
use portable_pty::CommandBuilder;
use rustix::process::{Pid, Signal, kill_process};

use crate::folder::Folder;
use crate::pty::{Pty, carrom, command};

fn started(command: CommandBuilder) -> Pty {
    let pty = Pty::start(command);
    pty.wait_for("carrom : ");
    pty.wait_for("? help");
    pty.assert_taken();
    pty
}

#[test]
fn carrom_starts_plays_and_quits() {
    let mut pty = started(carrom(&[]));
    pty.press("?");
    pty.wait_for("help: home");
    // A click outside everything, a turn of the wheel and a paste have no effect.
    pty.press("\x1b[<0;1;1M\x1b[<0;1;1m\x1b[<64;5;5M\x1b[200~pasted\x1b[201~");
    pty.press(" ");
    pty.wait_until("the help page to close", |screen| {
        !screen.contains("help: home")
    });
    pty.press("q");
    assert_eq!(pty.wait(), 0);
    pty.assert_restored();
}

#[test]
fn control_c_leaves() {
    let mut pty = started(carrom(&["lab"]));
    pty.press("\x03");
    assert_eq!(pty.wait(), 0);
    pty.assert_restored();
}

#[test]
fn the_screen_follows_the_size_of_the_window() {
    let mut pty = started(carrom(&[]));
    for (columns, rows) in [(100, 30), (60, 20), (120, 40)] {
        pty.resize(columns, rows);
        pty.wait_until("the keys in the last row", |screen| {
            let last = screen.lines().nth(usize::from(rows) - 1);
            last.is_some_and(|line| line.trim_end().ends_with("? help"))
        });
    }
    pty.resize(40, 10);
    pty.wait_for("carrom needs 60x20; this is 40x10");
    pty.resize(80, 24);
    pty.wait_for("carrom : home");
    pty.press("q");
    assert_eq!(pty.wait(), 0);
    pty.assert_restored();
}

pub(crate) fn a_key_pressed_while_the_window_changes_is_not_lost() {
    let mut pty = started(carrom(&[]));
    for i in 0..100 {
        pty.resize(80 + i % 2 * 20, 24);
        pty.press("?");
        pty.wait_for("help: home");
        pty.resize(90, 24);
        pty.press(" ");
        pty.wait_until("the help page to close", |screen| {
            !screen.contains("help: home") && screen.contains("carrom : home")
        });
    }
    pty.press("q");
    assert_eq!(pty.wait(), 0);
}

#[test]
fn a_signal_ends_carrom_and_the_terminal_is_restored() {
    for (signal, status) in [(Signal::TERM, 143), (Signal::INT, 130), (Signal::HUP, 129)] {
        for command in [carrom(&[]), child("animated")] {
            let mut pty = started(command);
            pty.signal(signal);
            assert_eq!(pty.wait(), status);
            pty.assert_restored();
        }
    }
}

#[test]
fn carrom_can_be_ended_in_the_middle_of_a_hit() {
    let mut pty = started(carrom(&["lab"]));
    let before = pictures(&pty);
    // Continue to the prediction, set both rays, and start the hit.
    pty.press("\r60\r30\r");
    pty.wait_until("the discs to move", |_| pictures(&pty) > before + 10);
    pty.signal(Signal::TERM);
    assert_eq!(pty.wait(), 143);
    pty.assert_restored();
}

/// The number of frames that were drawn.
fn pictures(pty: &Pty) -> usize {
    count(pty, "\x1b[?2026h")
}

/// How many times a code was written.
fn count(pty: &Pty, code: &str) -> usize {
    String::from_utf8_lossy(&pty.bytes()).matches(code).count()
}

#[test]
fn a_closed_window_ends_carrom() {
    for command in [carrom(&[]), child("animated")] {
        let mut pty = started(command);
        pty.hang_up("?");
        // carrom may notice the signal or, during a frame, the write error.
        let status = pty.wait();
        assert!(status == 129 || status == 1, "{status}");
    }
}

#[test]
fn a_panic_restores_the_terminal_and_is_reported() {
    let folder = Folder::new("fault");
    let mut command = child("moody");
    command.env("CARROM_PTY_FOLDER", folder.path());
    let mut pty = started(command);
    // A panic in a thread that does not draw is only written to the report.
    pty.press("w");
    let report = folder.path().join("crash.log");
    pty.wait_until("a report", |_| report.exists());
    pty.assert_taken();
    assert!(!pty.screen().contains("stopped by an internal error"));
    pty.press("p");
    assert_ne!(pty.wait(), 0);
    pty.assert_restored();
    let screen = pty.screen().replace('\n', "");
    assert!(
        screen.contains("carrom: stopped by an internal error: a bad mood"),
        "{screen}"
    );
    let report = std::fs::read_to_string(report).unwrap();
    assert!(
        report.contains("a bad mood (at tests/program/terminal.rs:"),
        "{report}"
    );
}

#[test]
fn a_stuck_app_is_terminated() {
    let mut pty = started(child("moody"));
    pty.press("s");
    pty.signal(Signal::TERM);
    assert_eq!(pty.wait(), 143);
    pty.assert_restored();
}

#[test]
fn carrom_can_be_stopped_and_continued() {
    let carrom = env!("CARGO_BIN_EXE_carrom");
    let stopped = "echo stopped $?; read -r answer; fg %1 >/dev/null";
    let script = format!(
        "sh -c 'echo process $$; exec \"$0\"' {carrom}; {stopped}; {stopped}; {stopped}; echo done $?"
    );
    let mut pty = Pty::start(command("bash", &["--norc", "-mc", &script]));
    pty.wait_for("carrom : home");
    pty.assert_taken();
    let process = process_in(&pty.bytes());
    let stops: [&dyn Fn(&mut Pty); 2] = [&|pty| pty.press("\x1a"), &|_| {
        kill_process(process, Signal::TSTP).unwrap();
    }];
    for (i, stop) in stops.iter().enumerate() {
        stop(&mut pty);
        pty.wait_until("the shell", |screen| {
            screen.matches("stopped ").count() == i + 1
        });
        pty.assert_restored();
        pty.press("\n");
        pty.wait_for("carrom : home");
        pty.assert_taken();
    }
    // A process cannot handle this signal, so carrom cannot restore the terminal before it stops;
    // it only takes control of the terminal again afterwards.
    kill_process(process, Signal::STOP).unwrap();
    let before = pictures(&pty);
    pty.wait_for("stopped ");
    pty.press("\n");
    pty.wait_until("another frame", |_| pictures(&pty) > before);
    pty.wait_for("carrom : home");
    pty.assert_taken();
    pty.press("q");
    pty.wait_for("done 0");
    pty.assert_restored();
}

/// The id of the process, from the line `process N`.
fn process_in(bytes: &[u8]) -> Pid {
    let text = String::from_utf8_lossy(bytes);
    let (_, after) = text.split_once("process ").unwrap();
    let digits: String = after.chars().take_while(char::is_ascii_digit).collect();
    Pid::from_raw(digits.parse().unwrap()).unwrap()
}

#[test]
fn ctrl_z_is_ignored_if_no_shell_could_continue_carrom() {
    let mut pty = started(carrom(&[]));
    pty.press("\x1a?");
    pty.wait_for("help: home");
    pty.assert_taken();
    pty.press(" q");
    assert_eq!(pty.wait(), 0);
}

#[test]
fn frames_are_synchronized_and_at_most_sixty_per_second() {
    let mut pty = started(child("animated"));
    let (start, before) = (Instant::now(), pictures(&pty));
    thread::sleep(Duration::from_secs(1));
    // Key presses must not make the app draw more often.
    (0..200).for_each(|_| pty.press("x"));
    pty.press("q");
    assert_eq!(pty.wait(), 0);
    pty.assert_restored();
    let drawn = pictures(&pty) - before;
    let most = start.elapsed().as_secs_f64() / FRAME.as_secs_f64() + 2.0;
    assert!(
        (1.0..most).contains(&(drawn as f64)),
        "{drawn} frames, at most {most}"
    );
    // The guard writes the code that ends a frame once more, in case a frame was in progress.
    assert_eq!(pictures(&pty) + 1, count(&pty, "\x1b[?2026l"));
}

#[test]
fn without_colour_bold_and_reverse_survive() {
    let mut command = child("animated");
    command.env("NO_COLOR", "1");
    let mut pty = started(command);
    pty.press("q");
    assert_eq!(pty.wait(), 0);
    let bytes = pty.bytes();
    let text = String::from_utf8_lossy(&bytes);
    assert!(text.contains("\x1b[1m") && text.contains("\x1b[7m"));
}

#[test]
fn the_version_that_the_terminal_reports_decides_the_blocks() {
    let with = |blocks| {
        let mut pty = started(carrom(&[
            "lab",
            "--charset",
            "unicode",
            "--color",
            "truecolor",
            "--blocks",
            blocks,
        ]));
        assert_eq!(count(&pty, "\x1b[>q"), 1);
        pty.press("\x1bP>|kitty(0.40.0)\x1b\\");
        pty
    };
    let has_octants =
        |screen: &str| screen.contains(|it| ('\u{1cd00}'..='\u{1cde5}').contains(&it));
    let mut pty = with("auto");
    pty.wait_until("octants", has_octants);
    pty.press("\x1bP>|tmux 3.5a\x1b\\");
    pty.wait_until("quadrants", |screen| !has_octants(screen));
    // A set of blocks chosen on the command line stays, and no part of the terminal's reply is read
    // as a key.
    let mut chosen = with("quadrants");
    chosen.press("?");
    chosen.wait_for("help: lab");
    chosen.press("\x1b");
    chosen.wait_until("the help to close", |screen| !screen.contains("help: lab"));
    assert!(!has_octants(&chosen.screen()));
    for pty in [&mut pty, &mut chosen] {
        pty.press("\x03");
        assert_eq!(pty.wait(), 0);
        pty.assert_restored();
    }
}

#[test]
fn a_terminal_that_cannot_position_text_is_refused() {
    let mut command = carrom(&[]);
    command.env("TERM", "dumb");
    let mut pty = Pty::start(command);
    assert_eq!(pty.wait(), 2);
    pty.wait_for("TERM is dumb");
    pty.assert_restored();
}

/// A command that runs this test program again, to play its own app in a terminal.
fn child(role: &str) -> CommandBuilder {
    let this = env::current_exe().unwrap();
    let arguments = ["terminal::child_plays", "--exact", "--nocapture"];
    let mut command = command(this.to_str().unwrap(), &arguments);
    command.env("CARROM_PTY_CHILD", role);
    command
}

/// The test that [`child`] runs; it does nothing in an ordinary test run.
#[test]
fn child_plays() {
    let Some(role) = env::var_os("CARROM_PTY_CHILD") else {
        return;
    };
    terminal::report_crashes(env::var_os("CARROM_PTY_FOLDER").map(Into::into));
    let screen = Restless {
        moves: role == "animated",
        ..Restless::default()
    };
    let app = App::on(Box::new(Hosted::new(screen)), Settings::default(), 1);
    match terminal::run(app, Store::in_memory(), HostOptions::default()) {
        Ok(Ending::Quit) => process::exit(0),
        Ok(Ending::Signal(signal)) => process::exit(128 + signal),
        Err(_) => process::exit(1),
    }
}

/// An app that is always moving, or that misbehaves: `w` makes another thread panic, `p` panics,
/// `s` never returns.
#[derive(Default)]
struct Restless {
    moves: bool,
    steps: u32,
}

/// The action of `q`.
#[derive(Clone, Copy, PartialEq, strum::IntoStaticStr, strum::EnumMessage)]
enum RestlessAction {
    /// quit
    Quit,
}

impl Screen for Restless {
    type Action = RestlessAction;
    const HELP: &'static str = "Restless.";

    fn title(&self) -> String {
        format!("restless {}", self.steps)
    }

    fn keys(&self, _: &Context) -> KeyTable<RestlessAction> {
        KeyTable::new("restless").on(Key::Char('q'), RestlessAction::Quit, "quit")
    }

    fn act(&mut self, _: RestlessAction, _: &mut Context) -> Next {
        Next::Shared(SharedAction::Quit)
    }

    fn typed(&mut self, key: Key, _: &mut Context) -> bool {
        match key {
            Key::Char('w') => {
                let _ = thread::spawn(|| panic!("a worker's bad mood")).join();
            }
            Key::Char('p') => panic!("a bad mood"),
            Key::Char('s') => loop {
                thread::park();
            },
            _ => return false,
        }
        true
    }

    fn advance(&mut self, _: Duration, _: &mut Context) {
        self.steps += 1;
    }

    fn wake(&self, _: &Context) -> Option<Duration> {
        self.moves.then_some(Duration::ZERO)
    }

    fn view<'s>(&'s self, _: &'s Context) -> View<'s, RestlessAction> {
        use ratatui::style::Stylize;
        View::picture_alone(|area, buf, _| {
            let line = format!("step {}", self.steps).bold().reversed();
            buf.set_span(area.x, area.y, &line, area.width);
        })
    }
}

#[test]
fn the_screen_stays_responsive_while_the_computer_thinks() {
    let mut pty = started(carrom(&["table", "--seed", "11"]));
    pty.press("\r");
    pty.wait_for("You break, white");
    // A break that is too soft to pocket anything; the animation is skipped to its end.
    pty.press(&format!("M{} ", "-".repeat(30)));
    pty.wait_for("(law 21)");
    pty.press("\r");
    pty.wait_for("Computer:");
    pty.press("\x03");
    assert_eq!(pty.wait(), 0);
    pty.assert_restored();
}
