//! Sends random input to carrom and checks that nothing fails.
//!
//! ```text
//! cargo run --release --example fuzz -- SECONDS [FOLDER]
//! cargo run --release --example fuzz -- --session NUMBER
//! cargo run --release --example fuzz -- --file NUMBER
//! ```
//!
//! It plays sessions. A session starts at a random stop of the tour in `tests/common/tour.rs`, with
//! random settings. It presses keys, uses the mouse, pastes, resizes and lets time pass, and it
//! draws after every hundredth input and at every new screen. Between the sessions, files of each
//! kind that carrom reads are damaged and read. Nothing may panic, take longer than a second, show
//! "NaN" or a control character, or put a character that is not ASCII on an ASCII screen.
//!
//! The numbers of sessions, inputs, files and faults are saved in FOLDER (`target/fuzz` by
//! default), so they add up over all runs. Each fault is recorded there with the number of the
//! session or file that reproduces it.

#[path = "../../tests/common/damage.rs"]
mod damage;
mod files;
mod sessions;
#[path = "../../tests/common/tour.rs"]
mod tour;

use std::any::Any;
use std::error::Error;
use std::fs::{self, OpenOptions};
use std::io::Write;
use std::panic::{self, AssertUnwindSafe};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use std::{env, process};

/// The longest time that one input or one file may take.
const LONGEST: Duration = Duration::from_secs(1);
/// The number of files damaged after each session.
const FILES_A_SESSION: u64 = 25;

/// The counts of all runs.
#[derive(Debug, Clone, Copy, Default)]
struct Count {
    sessions: u64,
    inputs: u64,
    files: u64,
    faults: u64,
}

impl Count {
    fn names(&mut self) -> [(&'static str, &mut u64); 4] {
        [
            ("sessions", &mut self.sessions),
            ("inputs", &mut self.inputs),
            ("files", &mut self.files),
            ("faults", &mut self.faults),
        ]
    }

    /// Reads the counts from a file; all are zero if there is none.
    fn read(path: &Path) -> Self {
        let mut count = Self::default();
        let text = fs::read_to_string(path).unwrap_or_default();
        for (name, number) in text.lines().filter_map(|line| line.split_once(" = ")) {
            let mut names = count.names().into_iter();
            if let Some((_, count)) = names.find(|(known, _)| *known == name) {
                *count = number.parse().unwrap_or_default();
            }
        }
        count
    }

    fn write(mut self, path: &Path) -> std::io::Result<()> {
        let lines = self
            .names()
            .map(|(name, count)| format!("{name} = {count}\n"));
        fs::write(path, lines.concat())
    }
}

/// What went wrong.
type Fault = String;

/// The processor time of this thread, which other programs do not affect.
#[cfg(unix)]
fn worked() -> Duration {
    use rustix::time::{ClockId, clock_gettime};
    let time = clock_gettime(ClockId::ThreadCPUTime);
    Duration::new(time.tv_sec.unsigned_abs(), time.tv_nsec as u32)
}

/// The time since the first call.
#[cfg(not(unix))]
fn worked() -> Duration {
    static START: std::sync::LazyLock<Instant> = std::sync::LazyLock::new(Instant::now);
    START.elapsed()
}

/// Runs `act`; it is a fault if this panics or takes too long.
fn watched<T>(act: impl FnOnce() -> Result<T, Fault>) -> Result<T, Fault> {
    let start = worked();
    let said = |cause: Box<dyn Any + Send>| {
        let text = cause.downcast_ref::<String>().cloned();
        let text = text.or_else(|| cause.downcast_ref::<&str>().map(ToString::to_string));
        format!("it panicked: {}", text.unwrap_or_default())
    };
    let done = panic::catch_unwind(AssertUnwindSafe(act)).map_err(said)??;
    match worked() - start {
        taken if taken > LONGEST => Err(format!("it took {:.1} s", taken.as_secs_f64())),
        _ => Ok(done),
    }
}

fn run(seconds: u64, folder: &Path) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    let state = folder.join("count.toml");
    let mut count = Count::read(&state);
    let models = files::models(Path::new(env!("CARGO_MANIFEST_DIR")))?;
    let mut faults = OpenOptions::new()
        .create(true)
        .append(true)
        .open(folder.join("faults.txt"))?;
    let (start, before) = (Instant::now(), count);
    while start.elapsed() < Duration::from_secs(seconds) {
        let (inputs, fault) = sessions::play(count.sessions, false);
        if let Some(fault) = fault {
            count.faults += 1;
            writeln!(faults, "--session {}: {fault}", count.sessions)?;
        }
        count.sessions += 1;
        count.inputs += inputs;
        for _ in 0..FILES_A_SESSION {
            if let Err(fault) = files::damage(count.files, &models, folder, false) {
                count.faults += 1;
                writeln!(faults, "--file {}: {fault}", count.files)?;
            }
            count.files += 1;
        }
        if count.sessions.is_multiple_of(100) {
            count.write(&state)?;
        }
    }
    count.write(&state)?;
    println!(
        "{} inputs and {} files in {seconds} s; {} inputs, {} files and {} faults in all runs",
        count.inputs - before.inputs,
        count.files - before.files,
        count.inputs,
        count.files,
        count.faults
    );
    match count.faults - before.faults {
        0 => Ok(()),
        new => Err(format!(
            "{new} new faults, see {}",
            folder.join("faults.txt").display()
        )
        .into()),
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<_> = env::args().skip(1).collect();
    let words: Vec<_> = arguments.iter().map(String::as_str).collect();
    let place = |given: Option<&&str>| PathBuf::from(given.copied().unwrap_or("target/fuzz"));
    match words.as_slice() {
        ["--session", number] => {
            let (inputs, fault) = sessions::play(number.parse()?, true);
            println!(
                "{inputs} inputs; {}",
                fault.as_deref().unwrap_or("no fault")
            );
        }
        ["--file", number] => {
            let models = files::models(Path::new(env!("CARGO_MANIFEST_DIR")))?;
            files::damage(number.parse()?, &models, &env::temp_dir(), true)?;
        }
        [seconds, rest @ ..] if rest.len() < 2 => {
            let seconds = seconds.parse()?;
            // A fault is reported once, by the code that catches it.
            panic::set_hook(Box::new(|_| {}));
            run(seconds, &place(rest.first()))?;
        }
        _ => {
            eprintln!("expected SECONDS [FOLDER], --session NUMBER or --file NUMBER");
            process::exit(2);
        }
    }
    Ok(())
}
