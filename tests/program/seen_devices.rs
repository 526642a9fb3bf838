//! Devices whose screens the test reads: carrom in a terminal, and the page in Chromium.

use std::time::{Duration, Instant};

use serde_json::Value;

use crate::browser::{Browser, SCREEN, wait_until_ready};
use crate::chromium::Chromium;
use crate::pty::Pty;

/// How long a screen may take to show something.
const PATIENCE: Duration = Duration::from_secs(20);
/// How long to wait for a vote to be saved before trying the next keys.
const SOON: Duration = Duration::from_millis(300);
/// The text that a device shows once its vote is on the disk.
const IN: &str = "Your vote is in.";

pub(crate) trait SeenDevice {
    fn screen(&mut self) -> String;

    /// Presses a key: a letter, or "\r".
    fn press(&mut self, key: &str);

    fn shows(&mut self, words: &str) -> bool {
        self.screen().contains(words)
    }

    fn wait_for(&mut self, words: &str) {
        let start = Instant::now();
        while !self.shows(words) {
            let screen = self.screen();
            assert!(start.elapsed() < PATIENCE, "no \"{words}\":\n{screen}");
        }
    }

    /// Votes on the current question; returns the time from the last key until the screen shows
    /// that the vote is saved.
    fn vote(&mut self) -> Duration {
        // These keys answer a choice, or one or two numbers, and then the confidence, so they fit
        // every question.
        let keys = [("a10\r", SOON), ("10\r", SOON), ("\r", PATIENCE)];
        for (keys, patience) in keys {
            keys.chars().for_each(|key| self.press(&key.to_string()));
            let start = Instant::now();
            while start.elapsed() < patience {
                if self.shows(IN) {
                    return start.elapsed();
                }
            }
        }
        panic!("no vote:\n{}", self.screen());
    }
}

impl SeenDevice for Pty {
    fn screen(&mut self) -> String {
        Self::screen(self)
    }

    fn press(&mut self, key: &str) {
        Self::press(self, key);
    }
}

impl SeenDevice for Chromium {
    fn screen(&mut self) -> String {
        self.run(SCREEN, &[]).as_str().unwrap().to_owned()
    }

    fn press(&mut self, key: &str) {
        let key = if key == "\r" { "Enter" } else { key };
        let script = "document.body.dispatchEvent(new KeyboardEvent('keydown',
            { key: arguments[0], bubbles: true, cancelable: true }))";
        self.run(script, &[Value::from(key)]);
    }
}

/// A host's page in Chromium, after a pupil with this name has joined.
pub(crate) fn browser(port: u16, code: &str, name: &str) -> Chromium {
    let mut chromium = Chromium::start((1000, 700), false);
    chromium.open(&format!("http://127.0.0.1:{port}/#code={code}"));
    wait_until_ready(&mut chromium);
    chromium.wait_for("Your class is playing a round");
    for letter in name.chars() {
        SeenDevice::press(&mut chromium, &letter.to_string());
    }
    SeenDevice::press(&mut chromium, "\r");
    SeenDevice::press(&mut chromium, "\r");
    chromium.wait_for(&format!("You are in, {name}."));
    chromium
}
