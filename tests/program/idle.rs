//! An idle carrom uses no processor time.

use std::fs;
use std::thread;
use std::time::Duration;

use crate::folder::Folder;
use crate::pty::{Pty, carrom};

pub(crate) fn an_idle_program_uses_no_processor_time() {
    // The clock ticks a hundred times a second.
    let seconds = |pty: &Pty| {
        let stat = fs::read_to_string(format!("/proc/{}/stat", pty.pid())).unwrap();
        let (_, after) = stat.rsplit_once(')').unwrap();
        let fields: Vec<_> = after.split_whitespace().collect();
        let ticks = [11, 12].map(|i: usize| fields[i].parse::<u32>().unwrap());
        f64::from(ticks[0] + ticks[1]) / 100.0
    };
    let folder = Folder::new("idle");
    let data = folder.path().to_str().unwrap();
    let mut idle = [&[][..], &["lab"], &["levels"]].map(|screen| {
        let pty = Pty::start(carrom(&[screen, &["--data-dir", data]].concat()));
        pty.wait_for("carrom : ");
        pty.wait_for("? help");
        pty
    });
    // On a busy machine the start may last longer than the first picture.
    thread::sleep(Duration::from_secs(1));
    let before = idle.each_ref().map(seconds);
    thread::sleep(Duration::from_secs(5));
    for (pty, before) in idle.iter_mut().zip(before) {
        let used = seconds(pty) - before;
        assert!(used < 0.02, "{used} s of processor time in 5 idle seconds");
        pty.press("\x03");
        assert_eq!(pty.wait(), 0);
    }
}
