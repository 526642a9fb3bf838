//! Runs the test program again as a separate process, which plays until it ends or is killed.

use std::env;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdout, Command, Stdio};

use rand_pcg::Pcg64;

const FOLDER: &str = "CARROM_CHILD_FOLDER";
const WORDS: &str = "CARROM_CHILD_WORDS";
/// The prefix of each number that the process reports.
const SAID: &str = "said ";

/// A process that repeats an action, and reports a number each time as soon as the screen shows the
/// result.
pub(crate) struct Player {
    child: Child,
    said: BufReader<ChildStdout>,
}

impl Player {
    /// Runs only the test with this name (including its module: `kill::child_plays`), which gets
    /// `folder` and `words` from [`told`].
    pub(crate) fn start(test: &str, folder: &Path, words: &[&str]) -> Self {
        let mut child = Command::new(env::current_exe().unwrap())
            .args([test, "--exact", "--nocapture"])
            .env(FOLDER, folder)
            .env(WORDS, words.join("\n"))
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let said = BufReader::new(child.stdout.take().unwrap());
        Self { child, said }
    }

    /// The next number that the process reports; `None` at the end of its output.
    pub(crate) fn next(&mut self) -> Option<usize> {
        loop {
            let mut line = String::new();
            if self.said.read_line(&mut line).unwrap() == 0 {
                return None;
            }
            if let Some(number) = line.trim().strip_prefix(SAID) {
                return Some(number.parse().unwrap());
            }
        }
    }

    /// Kills the process shortly after it has reported `numbers` numbers, and returns the last
    /// number that it reported.
    pub(crate) fn kill(mut self, numbers: usize, chance: &mut Pcg64) -> Option<usize> {
        let mut last = None;
        for _ in 0..numbers {
            last = self.next();
            assert!(last.is_some(), "the process ended too early");
        }
        wait_a_moment(chance);
        self.child.kill().unwrap();
        self.child.wait().unwrap();
        self.rest().or(last)
    }

    /// Waits until the process ends, and returns the last number that it reported.
    pub(crate) fn end(mut self) -> Option<usize> {
        let last = self.rest();
        assert!(self.child.wait().unwrap().success());
        last
    }

    fn rest(&mut self) -> Option<usize> {
        std::iter::from_fn(|| self.next()).last()
    }
}

/// Waits up to 20 ms, so that the process is killed at a random moment.
fn wait_a_moment(chance: &mut Pcg64) {
    use rand::RngExt;
    let moment = std::time::Duration::from_micros(chance.random_range(0..20_000));
    std::thread::sleep(moment);
}

/// The folder and the words that a [`Player`] was started with; `None` in an ordinary test run, in
/// which the test does nothing.
pub(crate) fn told() -> Option<(PathBuf, Vec<String>)> {
    let folder = env::var_os(FOLDER)?;
    let words = env::var(WORDS).unwrap();
    Some((folder.into(), words.lines().map(str::to_owned).collect()))
}

/// Reports a number to the process that started the [`Player`].
pub(crate) fn say(number: usize) {
    println!("{SAID}{number}");
    std::io::stdout().flush().unwrap();
}
