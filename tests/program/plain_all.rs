//! Screens in plain lines, as a blind pupil uses them: from the first screen to a shot in the lab,
//! a level that is won, a stroke at the table and a vote in a class.

use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::net::SocketAddr;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{self, Receiver};
use std::thread;
use std::time::Duration;

use carrom::class::JoinCode;

use crate::folder::Folder;

/// How long a reply may take on a busy machine.
const PATIENCE: Duration = Duration::from_secs(60);

/// The program, controlled line by line.
struct Talk {
    child: Child,
    input: ChildStdin,
    lines: Receiver<String>,
    said: Vec<String>,
}

impl Talk {
    fn begin(arguments: &[&str], folder: &Folder) -> Self {
        let mut child = Command::new(env!("CARGO_BIN_EXE_carrom"))
            .args(arguments)
            .args(["--plain", "--data-dir"])
            .arg(folder.path())
            .current_dir(folder.path())
            .env("TERM", "dumb")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let input = child.stdin.take().unwrap();
        let output = BufReader::new(child.stdout.take().unwrap());
        let (sender, lines) = mpsc::channel();
        thread::spawn(move || {
            for line in output.lines().map_while(Result::ok) {
                let _ = sender.send(line);
            }
        });
        Self {
            child,
            input,
            lines,
            said: Vec::new(),
        }
    }

    /// Waits for a line that contains these words.
    fn hears(&mut self, words: &str) {
        loop {
            let line = self.lines.recv_timeout(PATIENCE);
            let line = line.unwrap_or_else(|_| panic!("{words}: {:#?}", self.said));
            assert_read(&line);
            self.said.push(line);
            if self.said.last().is_some_and(|line| line.contains(words)) {
                return;
            }
        }
    }

    fn says(&mut self, line: &str) {
        self.said.push(format!("> {line}"));
        writeln!(self.input, "{line}").unwrap();
    }

    /// Sends each line once the words before it have been received.
    fn goes(&mut self, steps: &[(&str, &str)]) {
        for (heard, said) in steps {
            self.hears(heard);
            self.says(said);
        }
    }

    fn leaves(mut self) {
        self.says("quit");
        let left = self.child.wait().unwrap();
        assert!(left.success(), "{:#?}", self.said);
    }
}

/// Asserts that a line can be read aloud: it has no drawing characters and no columns, and names no
/// key.
fn assert_read(line: &str) {
    let is_read = |c: char| c.is_ascii() && !c.is_control() || c.is_alphanumeric();
    assert!(line.chars().all(is_read), "{line}");
    assert!(!line.contains("  ") && line.trim() == line, "{line}");
    for never in [
        "Esc", "PageUp", "arrows", "mouse", "click", "| ", "Press ", "Drag ",
    ] {
        assert!(!line.contains(never), "{never}: {line}");
    }
}

#[test]
fn a_shot_in_the_lab_is_reached_from_home() {
    let folder = Folder::new("plain-lab");
    let mut talk = Talk::begin(&[], &folder);
    talk.goes(&[
        ("3: Lab", "lab"),
        ("Offset b in millimetres?", "coin mass = 30"),
        ("coin mass: 30.0 grams", "contact = stick"),
        ("contact: stick", "contact = slip"),
        ("contact: slip", "offset = 15"),
        ("Offset b in millimetres?", ""),
        ("Striker, in degrees?", "94"),
        ("Coin, in degrees?", "30"),
    ]);
    talk.hears("striker, degrees: you said 94.0, truth");
    talk.hears("separation");
    talk.says("set up");
    talk.hears("Set up the hit.");
    talk.says("back");
    talk.hears("Which one?");
    talk.leaves();
}

#[test]
fn a_level_is_won() {
    let folder = Folder::new("plain-level");
    let mut talk = Talk::begin(&["levels"], &folder);
    talk.goes(&[
        ("1: Dead stop", "1"),
        ("The white coin: 0 millimetres right", "a hint"),
        ("Hint 1 of 2", "direction = 53.1"),
        ("direction: 53.1 degrees", ""),
        ("Coin, in degrees?", "0"),
        ("Won", "help"),
    ]);
    talk.leaves();
    let mut talk = Talk::begin(&["levels"], &folder);
    talk.hears("1 of 65 won");
    talk.leaves();
}

#[test]
fn choosing_the_chosen_line_again_opens_it_once() {
    let folder = Folder::new("plain-teacher");
    let mut talk = Talk::begin(&["teacher"], &folder);
    talk.goes(&[("Which one?", "3"), ("cards.html", "3")]);
    talk.hears("cards-2.html");
    talk.leaves();
    let written = fs::read_dir(folder.path()).unwrap();
    let names = written.map(|it| it.unwrap().file_name().into_string().unwrap());
    assert_eq!(names.filter(|it| it.ends_with(".html")).count(), 2);
}

#[test]
fn the_computer_strikes_after_a_stroke_at_the_table() {
    let folder = Folder::new("plain-table");
    let mut talk = Talk::begin(&["table", "--seed", "3"], &folder);
    talk.goes(&[
        ("play", "play"),
        ("Queen: 0 millimetres right, 0 millimetres up.", "80"),
        ("80.0 degrees", "strike"),
        ("the turn passes", ""),
    ]);
    talk.hears("I wanted to");
    talk.hears("What next?");
    talk.leaves();
}

/// The teacher and the pupil both use plain lines; the class has the same steps as on screens.
#[test]
fn a_class_is_hosted_and_votes_in_plain_lines() {
    let (host_folder, folder) = (Folder::new("plain-host"), Folder::new("plain-join"));
    let class = ["class", "--host", "--code", "from-angle2-7"];
    let mut host = Talk::begin(&class, &host_folder);
    host.hears("Nobody has joined yet.");
    let mut addresses = host
        .said
        .iter()
        .filter_map(|it| it.parse::<SocketAddr>().ok());
    let port = addresses.next().unwrap().port();
    let code = host.said.iter().rfind(|it| it.parse::<JoinCode>().is_ok());
    let code = code.unwrap().clone();
    let mut pupil = Talk::begin(&["join"], &folder);
    pupil.goes(&[
        ("Address?", &format!("127.0.0.1:{port}")),
        ("Code?", &code),
        ("Name?", "Ada"),
        ("Which one?", ""),
    ]);
    pupil.hears("You are in, Ada.");
    host.goes(&[("One is in.", "back to the round"), ("the vote", "")]);
    pupil.goes(&[
        ("Striker, in degrees?", "75"),
        ("Coin, in degrees?", "15"),
        ("3: sure", "sure"),
    ]);
    pupil.hears("Your vote is in.");
    host.hears("1 of 1 have voted");
    for next in ["talk", "second vote", "the shot"] {
        host.says(next);
    }
    host.hears("Right at first: 1 of 1");
    pupil.hears("10.0 of 10 points");
    pupil.leaves();
    host.leaves();
}
