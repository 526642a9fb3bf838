//! Firefox, controlled through its Marionette protocol, which sends JSON preceded by its length.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::time::Duration;
use std::{env, fs, process, thread};

use serde_json::{Value, json};

use crate::browser::Browser;

pub(crate) struct Firefox {
    process: Child,
    stream: TcpStream,
    profile: PathBuf,
}

impl Firefox {
    pub(crate) fn start() -> Self {
        let profile = env::temp_dir().join(format!("carrom-firefox-{}", process::id()));
        fs::create_dir_all(&profile).unwrap();
        // With port 0, Firefox chooses a port and writes it into the profile.
        fs::write(
            profile.join("user.js"),
            "user_pref(\"marionette.port\", 0);\n",
        )
        .unwrap();
        let firefox = Command::new("firefox-esr")
            .args(["--headless", "--marionette", "--no-remote", "--profile"])
            .arg(&profile)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn();
        let process = firefox.unwrap_or_else(|error| panic!("firefox-esr does not start: {error}"));
        let port = (0..600).find_map(|_| {
            thread::sleep(Duration::from_millis(100));
            let port = fs::read_to_string(profile.join("MarionetteActivePort")).ok()?;
            port.trim().parse::<u16>().ok()
        });
        let stream = TcpStream::connect(("127.0.0.1", port.expect("a port"))).unwrap();
        let mut firefox = Self {
            process,
            stream,
            profile,
        };
        firefox.hear();
        firefox.ask("WebDriver:NewSession", &json!({}));
        firefox
    }

    fn ask(&mut self, command: &str, parameters: &Value) -> Value {
        let message = json!([0, 1, command, parameters]).to_string();
        write!(self.stream, "{}:{message}", message.len()).unwrap();
        let answer = self.hear();
        assert!(answer[2].is_null(), "{command}: {}", answer[2]);
        answer[3].clone()
    }

    fn hear(&mut self) -> Value {
        let mut length = 0;
        loop {
            let mut byte = [0];
            self.stream.read_exact(&mut byte).unwrap();
            match byte[0] {
                b':' => break,
                digit => length = 10 * length + usize::from(digit - b'0'),
            }
        }
        let mut message = vec![0; length];
        self.stream.read_exact(&mut message).unwrap();
        serde_json::from_slice(&message).unwrap()
    }
}

impl Browser for Firefox {
    fn open(&mut self, address: &str) {
        self.ask("WebDriver:Navigate", &json!({ "url": address }));
    }

    fn run(&mut self, script: &str, arguments: &[Value]) -> Value {
        // The script runs without a sandbox, because a sandbox hides the page's own variables.
        let parameters = json!({ "script": script, "args": arguments, "sandbox": null });
        self.ask("WebDriver:ExecuteScript", &parameters)["value"].clone()
    }
}

impl Drop for Firefox {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
        let _ = fs::remove_dir_all(&self.profile);
    }
}
