//! What once held the keys for a minute: the way out is always open. How soon it is taken is
//! printed, not asserted: `cargo test --test program freeze -- --nocapture`.

use std::fmt::Write;
use std::process::{Command, Stdio};
use std::time::Instant;

use rustix::process::Signal;

use crate::folder::Folder;
use crate::pty::{Pty, carrom};

/// A pack of 36 discs that touch, of masses over eleven powers of ten, and a striker. To work
/// out whose push goes how far through it takes many thousand steps at each blow.
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

/// Waits until carrom is left in this way and the terminal is as it was.
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

/// The level that is heavy work, being aimed.
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
fn a_level_that_is_heavy_work_is_aimed_and_left() {
    let folder = heavy_work();
    let mut pty = aiming(&folder);
    // Each of these once took a second.
    pty.press(&"\x1b[C".repeat(50));
    leave(pty, "a heavy level, aimed 50 times", ctrl_c, 0);
    let mut pty = aiming(&folder);
    pty.press(&"\x1b[C".repeat(50));
    pty.press(" ");
    pty.wait_until("the shot, or why there is none", |screen| {
        screen.contains("shot 1") || screen.contains("cannot be played")
    });
    leave(pty, "a heavy level, shot", ctrl_c, 0);
}

#[test]
fn a_level_that_is_heavy_work_is_checked() {
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
fn a_flood_of_keys_is_drawn_and_left() {
    let mut pty = Pty::start(carrom(&["quiz", "--code", "hits-7"]));
    pty.wait_for("question 1 of 10");
    let pictures = |pty: &Pty| {
        let bytes = pty.bytes();
        bytes.windows(8).filter(|it| it == b"\x1b[?2026h").count()
    };
    let before = pictures(&pty);
    // Most of a megabyte is still to be read when the first pictures of it are drawn.
    for _ in 0..16 {
        pty.press(&"7\x7f".repeat(1 << 15));
    }
    assert!(pictures(&pty) > before, "nothing was drawn meanwhile");
    leave(pty, "a flood of keys, Ctrl+C behind it", ctrl_c, 0);
}

#[test]
fn a_signal_ends_a_flood_of_keys() {
    let mut pty = Pty::start(carrom(&["quiz", "--code", "hits-7"]));
    pty.wait_for("question 1 of 10");
    pty.press(&"7\x7f".repeat(1 << 19));
    leave(
        pty,
        "a flood of keys, a signal",
        |pty| pty.signal(Signal::TERM),
        128 + 15,
    );
}

/// A paste whose end is lost, or that is larger than anybody means, held all keys: Ctrl+C was
/// taken for a part of it.
#[test]
fn a_paste_without_an_end_is_left_by_ctrl_c() {
    let mut pty = Pty::start(carrom(&["quiz", "--code", "hits-7"]));
    pty.wait_for("question 1 of 10");
    pty.press("\x1b[200~");
    for _ in 0..64 {
        pty.press(&"y\r\n".repeat(1 << 15));
    }
    leave(pty, "a paste of 6 MB without an end", ctrl_c, 0);
}

#[test]
fn a_paste_beyond_the_limit_is_cut_at_once() {
    let mut pty = Pty::start(carrom(&["class"]));
    pty.wait_for("carrom : class");
    // Its end never comes, and nothing of it is shown until it is cut.
    pty.press("\x1b[200~Ants\nBees\n");
    pty.press(&"\n".repeat(1 << 17));
    pty.wait_for("Bees");
    leave(pty, "a paste that was cut", ctrl_c, 0);
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
