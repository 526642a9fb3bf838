//! The test program run again as a process of its own, which plays until it is killed.

use std::env;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdout, Command, Stdio};

use rand_pcg::Pcg64;

const FOLDER: &str = "CARROM_CHILD_FOLDER";
const WORDS: &str = "CARROM_CHILD_WORDS";
/// What stands before each number that is said.
const SAID: &str = "said ";

/// A process that does something again and again, and says a number each time as soon as
/// the screen shows that it is done.
pub(crate) struct Player {
    child: Child,
    said: BufReader<ChildStdout>,
}

impl Player {
    /// Runs the test of this name (with its module: `kill::child_plays`) alone, which finds
    /// `folder` and `words` by [`told`].
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

    /// The next number that is said; `None` once there will be no more.
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

    /// Kills it after so many numbers, a moment later, and gives the last one it said.
    pub(crate) fn kill(mut self, numbers: usize, chance: &mut Pcg64) -> Option<usize> {
        let mut last = None;
        for _ in 0..numbers {
            last = self.next();
            assert!(last.is_some(), "it ended by itself");
        }
        wait_a_moment(chance);
        self.child.kill().unwrap();
        self.child.wait().unwrap();
        self.rest().or(last)
    }

    /// Waits until it ends by itself, and gives the last number it said.
    pub(crate) fn end(mut self) -> Option<usize> {
        let last = self.rest();
        assert!(self.child.wait().unwrap().success());
        last
    }

    fn rest(&mut self) -> Option<usize> {
        std::iter::from_fn(|| self.next()).last()
    }
}

/// Up to 20 ms, in which anything may be going on.
fn wait_a_moment(chance: &mut Pcg64) {
    use rand::RngExt;
    let moment = std::time::Duration::from_micros(chance.random_range(0..20_000));
    std::thread::sleep(moment);
}

/// What a [`Player`] was started with; `None` when the test is run as a test, which has
/// nothing to do then.
pub(crate) fn told() -> Option<(PathBuf, Vec<String>)> {
    let folder = env::var_os(FOLDER)?;
    let words = env::var(WORDS).unwrap();
    Some((folder.into(), words.lines().map(str::to_owned).collect()))
}

/// Says a number to whoever started the [`Player`].
pub(crate) fn say(number: usize) {
    println!("{SAID}{number}");
    std::io::stdout().flush().unwrap();
}
