//! Chromium, controlled by chromedriver over HTTP (WebDriver).

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};

use serde_json::{Value, json};

use crate::browser::Browser;

pub(crate) struct Chromium {
    driver: Child,
    port: u16,
    session: String,
}

/// Starts chromedriver on a free port. chromedriver opens the port for IPv4 and for IPv6, and exits
/// if another program takes the port in between, so several attempts may be needed.
fn start_driver() -> (Child, u16) {
    for _ in 0..5 {
        let driver = Command::new("chromedriver")
            .arg("--port=0")
            .stdout(Stdio::piped())
            .spawn();
        let mut driver = driver.unwrap_or_else(|error| {
            panic!("chromedriver, which controls Chromium, does not start: {error}")
        });
        let output = BufReader::new(driver.stdout.take().unwrap());
        let started = |line: std::io::Result<String>| {
            let line = line.unwrap();
            let (_, port) = line.split_once("started successfully on port ")?;
            port.trim_end_matches('.').parse().ok()
        };
        if let Some(port) = output.lines().find_map(started) {
            return (driver, port);
        }
        driver.wait().unwrap();
    }
    panic!("chromedriver finds no free port");
}

impl Chromium {
    /// Opens a window of this size in CSS pixels; if `finger` is set, the window is a phone's.
    pub(crate) fn start(size: (u32, u32), finger: bool) -> Self {
        Self::start_as(size, finger, &json!({}))
    }

    /// Opens a window with these browser settings (`prefs`).
    pub(crate) fn start_as((width, height): (u32, u32), finger: bool, prefs: &Value) -> Self {
        let (driver, port) = start_driver();
        let mut options = json!({
            "args": ["--headless=new", "--no-sandbox", format!("--window-size={width},{height}")],
            "prefs": prefs,
        });
        if finger {
            options["mobileEmulation"] = json!({ "deviceMetrics": {
                "width": width, "height": height, "pixelRatio": 2, "touch": true, "mobile": true,
            }});
        }
        let mut chromium = Self {
            driver,
            port,
            session: String::new(),
        };
        // chromedriver sometimes hangs if a page changes its address while the driver waits for it
        // to load. So the driver does not wait; `open` does.
        let wanted = json!({
            "pageLoadStrategy": "none",
            "goog:chromeOptions": options, "goog:loggingPrefs": { "performance": "ALL" },
        });
        let body = json!({ "capabilities": { "alwaysMatch": wanted } });
        let session = chromium.ask("POST", "/session", Some(&body));
        session["sessionId"]
            .as_str()
            .unwrap()
            .clone_into(&mut chromium.session);
        chromium
    }

    /// Sends a command of the debugging protocol.
    pub(crate) fn debug(&mut self, command: &str, parameters: &Value) -> Value {
        let body = json!({ "cmd": command, "params": parameters });
        self.in_session("goog/cdp/execute", &body)
    }

    /// The addresses of all requests since the last call, as logged by the debugging protocol.
    pub(crate) fn requests(&mut self) -> Vec<String> {
        let events = self.in_session("se/log", &json!({ "type": "performance" }));
        let events = events.as_array().unwrap().iter();
        let messages = events.map(|event| event["message"].as_str().unwrap());
        let messages = messages.map(|text| serde_json::from_str::<Value>(text).unwrap());
        let sent = messages.filter(|it| it["message"]["method"] == "Network.requestWillBeSent");
        let address = |it: Value| {
            let url = &it["message"]["params"]["request"]["url"];
            url.as_str().unwrap().to_owned()
        };
        sent.map(address).collect()
    }

    /// Closes the current window, even if its page is busy.
    pub(crate) fn close_window(&mut self) {
        let path = format!("/session/{}/window", self.session);
        self.ask("DELETE", &path, None);
    }

    /// The current window, which receives the commands.
    pub(crate) fn window(&mut self) -> String {
        let path = format!("/session/{}/window", self.session);
        self.ask("GET", &path, None).as_str().unwrap().to_owned()
    }

    /// Opens another tab and switches to it.
    pub(crate) fn another_window(&mut self) -> String {
        let opened = self.in_session("window/new", &json!({ "type": "tab" }));
        let window = opened["handle"].as_str().unwrap().to_owned();
        self.go_to(&window);
        window
    }

    /// Switches to the window with this handle.
    pub(crate) fn go_to(&mut self, window: &str) {
        self.in_session("window", &json!({ "handle": window }));
    }

    /// From now on, runs scripts in the first frame of the page if `is_frame`, otherwise in the
    /// page itself.
    pub(crate) fn go_to_frame(&mut self, is_frame: bool) {
        let frame = if is_frame { json!(0) } else { Value::Null };
        self.in_session("frame", &json!({ "id": frame }));
    }

    fn in_session(&mut self, path: &str, body: &Value) -> Value {
        let path = format!("/session/{}/{path}", self.session);
        self.ask("POST", &path, Some(body))
    }

    fn ask(&mut self, method: &str, path: &str, body: Option<&Value>) -> Value {
        let value = self.answer(method, path, body);
        assert!(value.get("error").is_none(), "{path}: {value}");
        value
    }

    /// The driver's reply, which may be an error.
    fn answer(&mut self, method: &str, path: &str, body: Option<&Value>) -> Value {
        let body = body.map(Value::to_string).unwrap_or_default();
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        write!(
            stream,
            "{method} {path} HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\
             Content-Type: application/json\r\nContent-Length: {}\r\n\r\n{body}",
            body.len()
        )
        .unwrap();
        let mut reader = BufReader::new(stream);
        let mut length = 0;
        loop {
            let mut line = String::new();
            reader.read_line(&mut line).unwrap();
            let line = line.trim_end().to_ascii_lowercase();
            if let Some(value) = line.strip_prefix("content-length:") {
                length = value.trim().parse().unwrap();
            }
            if line.is_empty() {
                break;
            }
        }
        let mut answer = vec![0; length];
        reader.read_exact(&mut answer).unwrap();
        let mut answer: Value = serde_json::from_slice(&answer).unwrap();
        answer["value"].take()
    }
}

impl Browser for Chromium {
    fn open(&mut self, address: &str) {
        let before = self.run("window.isLeft = true; return location.href", &[]);
        let path = format!("/session/{}/execute/sync", self.session);
        self.in_session("url", &json!({ "url": address }));
        // A link to another part of the same page does not load a new page.
        let opened = "return document.readyState === 'complete'
            && (!window.isLeft || arguments[0].split('#')[0] === arguments[1].split('#')[0])";
        let body = json!({ "script": opened, "args": [before, address] });
        for _ in 0..400 {
            // While a page is loading, there may be no page that can reply.
            if self.answer("POST", &path, Some(&body)) == Value::Bool(true) {
                return;
            }
            std::thread::sleep(std::time::Duration::from_millis(25));
        }
        panic!("{address} was not opened");
    }

    fn run(&mut self, script: &str, arguments: &[Value]) -> Value {
        self.in_session(
            "execute/sync",
            &json!({ "script": script, "args": arguments }),
        )
    }
}

impl Drop for Chromium {
    fn drop(&mut self) {
        if !self.session.is_empty() && !std::thread::panicking() {
            let path = format!("/session/{}", self.session);
            self.ask("DELETE", &path, None);
        }
        let _ = self.driver.kill();
        let _ = self.driver.wait();
    }
}
