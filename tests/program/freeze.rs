//! Cases in which the keys were once blocked for a minute. The player must always be able to quit.
//! The tests print how long quitting takes and assert nothing about it: `cargo test --test program
//! freeze -- --nocapture`.

use std::fmt::Write;
use std::process::{Command, Stdio};
use std::time::Instant;

use rustix::process::Signal;

use crate::folder::Folder;
use crate::pty::{Pty, carrom};

/// A level with a striker and 36 discs that almost touch, whose masses range over many powers of
/// ten. Calculating how an impact spreads through them requires many thousands of steps.
fn heavy_work() -> Folder {
    let mut level = String::from(
        "format = 1\n[level]\nid = \"heavy\"\ntitle = \"Heavy work\"\nhints = [\"a\", \"b\", \"c\"]\n\
         explanation = \"None.\"\n[board]\npocket_diameter_mm = 0\nfriction = 0.01\n\
         [[disc]]\nkind = \"striker\"\nat_mm = [0, -300]\n",
    );
    for place in 0..36 {
        let (column, row) = (f64::from(place % 6), f64::from(place / 6));
        let x = 31.82 * (column + 0.5 * (row % 2.0) - 2.75);
        let y = 31.82 * row * 0.75_f64.sqrt() - 60.0;
        let mass = ["0.001", "100000", "1"][(place * place % 7 % 3) as usize];
        writeln!(
            level,
            "[[disc]]\nkind = \"white\"\nat_mm = [{x}, {y}]\nmass_g = {mass}"
        )
        .unwrap();
    }
    level += "[shot]\ndisc = 0\ndirection_deg = 90\nspeed = 6\n[adjust]\ndirection_deg = [60, 120]\n\
              [[goal]]\nkind = \"cushions\"\ndisc = 0\nleast = 1\n[solution]\ndirection_deg = 90\n";
    let folder = Folder::new("freeze");
    folder.file("heavy.toml", level);
    folder
}

/// Quits carrom in this `way`, and waits until it has ended and restored the terminal.
fn leave(mut pty: Pty, when: &str, way: impl FnOnce(&mut Pty), status: u32) {
    let start = Instant::now();
    way(&mut pty);
    assert_eq!(pty.wait(), status);
    println!(
        "{when}: left after {:.0} ms",
        start.elapsed().as_secs_f64() * 1e3
    );
    pty.assert_restored();
}

fn ctrl_c(pty: &mut Pty) {
    pty.press("\x03");
}

/// carrom with the heavy level open, so that the player can aim.
fn aiming(folder: &Folder) -> Pty {
    let levels = folder.path().to_str().unwrap();
    let mut pty = Pty::start(carrom(&["levels", "--levels", levels]));
    pty.wait_for("carrom : levels");
    pty.press("\x1b[F\r");
    pty.wait_for("Heavy work");
    pty.wait_for("direction");
    pty
}

#[test]
fn a_player_can_aim_in_a_heavy_level_and_quit() {
    let folder = heavy_work();
    let mut pty = aiming(&folder);
    // Each of these key presses once took a second.
    pty.press(&"\x1b[C".repeat(50));
    leave(pty, "a heavy level, aimed 50 times", ctrl_c, 0);
    let mut pty = aiming(&folder);
    pty.press(&"\x1b[C".repeat(50));
    pty.press(" ");
    pty.wait_until("the shot, or an error", |screen| {
        screen.contains("shot 1") || screen.contains("cannot be played")
    });
    leave(pty, "a heavy level, shot", ctrl_c, 0);
}

#[test]
fn a_heavy_level_can_be_checked() {
    let folder = heavy_work();
    let start = Instant::now();
    let checked = Command::new(env!("CARGO_BIN_EXE_carrom"))
        .args(["level", "check", "--verbose"])
        .arg(folder.path())
        .stdin(Stdio::null())
        .output()
        .unwrap();
    println!(
        "a heavy level, checked: {:.0} ms",
        start.elapsed().as_secs_f64() * 1e3
    );
    let report = String::from_utf8_lossy(&checked.stdout).into_owned();
    assert!(report.contains("heavy: "), "{report} {checked:?}");
}

#[test]
fn the_screen_is_drawn_during_a_burst_of_keys_and_carrom_can_quit() {
    let mut pty = Pty::start(carrom(&["quiz", "--code", "hits-7"]));
    pty.wait_for("question 1 of 10");
    let pictures = |pty: &Pty| {
        let bytes = pty.bytes();
        bytes.windows(8).filter(|it| it == b"\x1b[?2026h").count()
    };
    let before = pictures(&pty);
    // The first frames are drawn while most of the three megabytes of keys is still unread.
    for _ in 0..48 {
        pty.press(&"7\x7f".repeat(1 << 15));
    }
    assert!(
        pictures(&pty) > before,
        "nothing was drawn during the burst"
    );
    leave(pty, "a burst of keys, then Ctrl+C", ctrl_c, 0);
}

#[test]
fn a_signal_ends_carrom_during_a_burst_of_keys() {
    let mut pty = Pty::start(carrom(&["quiz", "--code", "hits-7"]));
    pty.wait_for("question 1 of 10");
    pty.press(&"7\x7f".repeat(1 << 19));
    leave(
        pty,
        "a burst of keys, then a signal",
        |pty| pty.signal(Signal::TERM),
        128 + 15,
    );
}

/// A paste whose end was lost, or that was very large, once blocked all keys: Ctrl+C was read as
/// part of the paste.
#[test]
fn ctrl_c_quits_during_an_endless_paste() {
    let mut pty = Pty::start(carrom(&["quiz", "--code", "hits-7"]));
    pty.wait_for("question 1 of 10");
    pty.press("\x1b[200~");
    for _ in 0..64 {
        pty.press(&"y\r\n".repeat(1 << 15));
    }
    leave(pty, "a paste of 6 MB without an end", ctrl_c, 0);
}

#[test]
fn a_paste_beyond_the_limit_is_truncated_at_once() {
    let mut pty = Pty::start(carrom(&["class"]));
    pty.wait_for("carrom : class");
    // The paste never ends, but its text is shown as soon as the paste is truncated.
    pty.press("\x1b[200~Ants\nBees\n");
    pty.press(&"\n".repeat(1 << 17));
    pty.wait_for("Bees");
    leave(pty, "a truncated paste", ctrl_c, 0);
}

#[test]
fn keys_work_again_after_a_paste_whose_end_is_lost() {
    let mut pty = Pty::start(carrom(&["class"]));
    pty.wait_for("carrom : class");
    pty.press("\x1b[200~Ants\nBees");
    pty.wait_for("Bees");
    pty.press("\x1bOP");
    pty.wait_for("help: class");
    leave(pty, "a paste whose end is lost", ctrl_c, 0);
}
