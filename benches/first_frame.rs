//! Measures the time from the start of carrom to its first complete frame, in a terminal of 80 by
//! 24: `cargo bench --bench first_frame`.

#[cfg(unix)]
#[allow(dead_code, reason = "only the start is timed")]
#[path = "../tests/common/pty.rs"]
mod pty;

#[cfg(unix)]
fn main() {
    use pty::{Pty, carrom};
    use std::time::{Duration, Instant};

    const RUNS: usize = 50;
    let mut times: Vec<Duration> = (0..RUNS)
        .map(|_| {
            let start = Instant::now();
            let mut pty = Pty::start(carrom(&[]));
            pty.wait_for("? help");
            let time = start.elapsed();
            pty.press("\x03");
            pty.wait();
            time
        })
        .collect();
    times.sort();
    println!(
        "first frame of {RUNS} starts: median {:.1} ms, slowest {:.1} ms",
        times[RUNS / 2].as_secs_f64() * 1e3,
        times[RUNS - 1].as_secs_f64() * 1e3,
    );
}

#[cfg(not(unix))]
fn main() {
    println!("the first frame is timed in a pseudo-terminal, which this system does not have");
}
