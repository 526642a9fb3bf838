//! The app in plain lines over standard input and output.

use std::io::{self, BufRead, Write};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::time::{Duration, Instant};

use super::reader::PlainReader;
use super::talk::hear;
use crate::app::App;
use crate::messages::{Effect, Input};
use crate::shells::client::Client;
use crate::shells::host::{Host, HostOptions};
use crate::shells::{AppHolder, FRAME, terminal};
use crate::store::Store;

/// An event for the main loop.
enum Heard {
    Line(String),
    Input(Input),
    /// There is news from the class that this program serves.
    Hosted,
    Ended,
}

/// Runs the app on `input` and `output` until the player quits or the input ends. `host` contains
/// the options for serving a class.
///
/// # Errors
/// If a line cannot be written, or the last changes cannot be saved.
pub fn run(
    mut app: App,
    store: Store,
    host: HostOptions,
    input: impl BufRead + Send + 'static,
    output: &mut dyn Write,
) -> io::Result<()> {
    let (sender, news) = mpsc::channel();
    let [to_host, to_client] = [sender.clone(), sender.clone()];
    let mut reader = PlainReader::new(&mut app);
    let mut held = PlainApp {
        app,
        store,
        host: Host::new(host, move || drop(to_host.send(Heard::Hosted))),
        client: Client::new(move |news| {
            drop(to_client.send(Heard::Input(Input::Joined(news))));
        }),
        sender: sender.clone(),
    };
    let (more, wanted) = mpsc::channel();
    let listen = move || listen(input, &wanted, &sender);
    terminal::spawn("listener", listen)?;
    let talked = talk(&mut reader, &mut held, &news, &more, output);
    let kept = held.store.flush_at_end().map_err(io::Error::other);
    talked.and(kept)
}

/// Reads each line only on demand, so that a program that sends lines too fast has to wait.
fn listen(mut input: impl BufRead, wanted: &Receiver<()>, sender: &Sender<Heard>) {
    while wanted.recv().is_ok() {
        let heard = hear(&mut input).ok().flatten();
        let heard = heard.map_or(Heard::Ended, Heard::Line);
        if sender.send(heard).is_err() {
            return;
        }
    }
}

fn talk(
    reader: &mut PlainReader,
    held: &mut PlainApp,
    news: &Receiver<Heard>,
    more: &Sender<()>,
    output: &mut dyn Write,
) -> io::Result<()> {
    say(output, &reader.begin(held))?;
    let mut last = Instant::now();
    let want = || {
        let _ = more.send(());
    };
    want();
    while !held.app.has_quit() {
        let next = wait(news, held.app.wake());
        held.pass(last.elapsed());
        last = Instant::now();
        let lines = match next {
            Some(Heard::Line(line)) => {
                let lines = reader.hear(&line, held);
                want();
                lines
            }
            Some(Heard::Input(input)) => {
                held.input(&input);
                reader.news(held)
            }
            Some(Heard::Hosted) => {
                let news = held.host.take_news();
                held.input(&Input::Hosted(news));
                reader.news(held)
            }
            Some(Heard::Ended) => return say(output, &reader.end(held)),
            None => reader.say_moving(held),
        };
        if !held.app.has_quit() {
            say(output, &lines)?;
        }
    }
    Ok(())
}

/// Blocks until something happens, or until the app needs time.
fn wait(news: &Receiver<Heard>, wake: Option<Duration>) -> Option<Heard> {
    let Some(wake) = wake else {
        return news.recv().ok().or(Some(Heard::Ended));
    };
    match news.recv_timeout(wake.max(FRAME)) {
        Ok(news) => Some(news),
        Err(RecvTimeoutError::Timeout) => None,
        Err(RecvTimeoutError::Disconnected) => Some(Heard::Ended),
    }
}

fn say(out: &mut dyn Write, lines: &[String]) -> io::Result<()> {
    let text: String = lines.iter().map(|line| format!("{line}\n")).collect();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        // The program that reads the output has stopped.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        said => said,
    }
}

/// An app whose effects are carried out immediately.
struct PlainApp {
    app: App,
    store: Store,
    host: Host,
    client: Client,
    sender: Sender<Heard>,
}

impl PlainApp {
    /// Passes on the result of an export.
    fn exported(&self, result: Result<String, String>) {
        let exported = Input::Exported(result);
        drop(self.sender.send(Heard::Input(exported)));
    }
}

impl AppHolder for PlainApp {
    fn app(&mut self) -> &mut App {
        &mut self.app
    }

    fn carry_out(&mut self, effect: Effect) -> Option<Input> {
        match effect {
            Effect::Keep(call) => {
                let answer = self.store.answer(&call);
                return Some(Input::Kept(Box::new(answer)));
            }
            Effect::Host(call) => self.host.call(&call),
            Effect::Join(call) => self.client.call(&call),
            Effect::Export { name, content } => self.exported(terminal::export(&name, &content)),
            Effect::ExportPage { name, round } => {
                let document = self.host.page_document(round.as_ref());
                self.exported(document.and_then(|document| terminal::export(&name, document)));
            }
        }
        None
    }
}
