//! Keeps games beside the app, so that the screen never waits for the disk.

use std::io;
use std::sync::mpsc::{self, Sender};
use std::thread::{self, JoinHandle};

use super::message::Message;
use crate::messages::{Answer, Input, Request};
use crate::store::Store;

/// A thread that does what is asked, one thing after the other.
pub(super) struct Keeper {
    /// Gone once nothing will be asked any more.
    requests: Option<Sender<Request>>,
    thread: Option<JoinHandle<()>>,
}

impl Keeper {
    /// Starts the thread, which sends what came of each request.
    pub(super) fn start(mut store: Store, sender: Sender<Message>) -> io::Result<Self> {
        let (requests, asked) = mpsc::channel::<Request>();
        let keep = move || {
            for request in asked {
                tell(store.answer(&request), &sender);
            }
        };
        let thread = thread::Builder::new().name("keeper".into()).spawn(keep)?;
        Ok(Self {
            requests: Some(requests),
            thread: Some(thread),
        })
    }

    /// Asks for something to be done.
    pub(super) fn ask(&self, request: &Request, sender: &Sender<Message>) {
        let asked = self.requests.as_ref().map(|to| to.send(request.clone()));
        if !matches!(asked, Some(Ok(()))) {
            // A fault has ended the thread; its report is in crash.log.
            tell(request.refused("whoever keeps the games is gone"), sender);
        }
    }
}

/// What was asked for last is still done before carrom is left.
impl Drop for Keeper {
    fn drop(&mut self) {
        self.requests = None;
        if let Some(thread) = self.thread.take() {
            // Should it have been ended by a fault, that has been reported.
            let _ = thread.join();
        }
    }
}

fn tell(answer: Answer, sender: &Sender<Message>) {
    // Nobody listens any more only when carrom is leaving anyway.
    let _ = sender.send(Message::Input(Input::Kept(Box::new(answer))));
}
