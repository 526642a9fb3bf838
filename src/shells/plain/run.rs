//! The app in plain lines over standard input and output.

use std::io::{self, BufRead, Write};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::time::Instant;

use super::reader::PlainReader;
use super::talk::hear;
use crate::app::App;
use crate::messages::{Effect, Input};
use crate::shells::host::HostOptions;
use crate::shells::outside::Outside;
use crate::shells::{AppHolder, FRAME, receive, terminal};
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
    let [hosted, to_app] = [sender.clone(), sender.clone()];
    let mut reader = PlainReader::new(&mut app);
    let outside = Outside::new(
        host,
        move || drop(hosted.send(Heard::Hosted)),
        move |input| drop(to_app.send(Heard::Input(input))),
    );
    let mut held = PlainApp {
        app,
        store,
        outside,
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
        let next = receive(news, held.app.wake().map(|wake| wake.max(FRAME)));
        held.pass(last.elapsed());
        last = Instant::now();
        let lines = match next {
            Ok(Heard::Line(line)) => {
                let lines = reader.hear(&line, held);
                want();
                lines
            }
            Ok(Heard::Input(input)) => {
                held.input(&input);
                reader.news(held)
            }
            Ok(Heard::Hosted) => {
                let news = held.outside.news();
                held.input(&news);
                reader.news(held)
            }
            Ok(Heard::Ended) | Err(RecvTimeoutError::Disconnected) => {
                return say(output, &reader.end(held));
            }
            Err(RecvTimeoutError::Timeout) => reader.say_moving(held),
        };
        if !held.app.has_quit() {
            say(output, &lines)?;
        }
    }
    Ok(())
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
    outside: Outside,
}

impl AppHolder for PlainApp {
    fn app(&mut self) -> &mut App {
        &mut self.app
    }

    fn carry_out(&mut self, effect: Effect) -> Option<Input> {
        let call = self.outside.carry_out(effect)?;
        Some(Input::Kept(Box::new(self.store.answer(&call))))
    }
}
