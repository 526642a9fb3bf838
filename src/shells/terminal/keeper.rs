//! Keeps games and answers beside the app, so that the screen never waits long for the
//! disk; for an answer it waits until that is safe.

use std::io;
use std::sync::mpsc::{self, Sender};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use super::message::Message;
use crate::messages::{Answer, Input, Request, Wish};
use crate::store::Store;

/// How long the screen waits for a stroke or a vote to be saved before it shows it. Nearly all
/// disks need a small part of this, and then none that was seen can be lost.
const PATIENCE: Duration = Duration::from_millis(500);

/// A thread that does what is asked, one thing after the other.
pub(super) struct Keeper {
    /// Gone once nothing will be asked any more.
    jobs: Option<Sender<Job>>,
    thread: Option<JoinHandle<()>>,
}

/// Something to do, and whom to tell that it is done.
struct Job {
    request: Request,
    done: Sender<()>,
}

impl Keeper {
    /// Starts the thread, which sends what came of each request.
    pub(super) fn start(mut store: Store, sender: Sender<Message>) -> io::Result<Self> {
        let (jobs, asked) = mpsc::channel::<Job>();
        let keep = move || {
            for job in asked {
                tell(store.answer(&job.request), &sender);
                // It may have become too late for whoever waited.
                let _ = job.done.send(());
            }
        };
        let thread = thread::Builder::new().name("keeper".into()).spawn(keep)?;
        Ok(Self {
            jobs: Some(jobs),
            thread: Some(thread),
        })
    }

    /// Asks for something to be done.
    pub(super) fn ask(&self, request: &Request, sender: &Sender<Message>) {
        let (done, wait) = mpsc::channel();
        let job = Job {
            request: request.clone(),
            done,
        };
        let asked = self.jobs.as_ref().map(|jobs| jobs.send(job));
        if !matches!(asked, Some(Ok(()))) {
            // A fault has ended the thread; its report is in crash.log.
            tell(request.refused("whoever keeps the games is gone"), sender);
            return;
        }
        // In time or not, what came of it comes as an input.
        match request.wish {
            Wish::Save(_) | Wish::SaveClass(_) => {
                let _ = wait.recv_timeout(PATIENCE);
            }
            // Nothing answered is ever lost: no explanation is drawn before this, and
            // the database has a limit to its own patience.
            Wish::Record(_) => {
                let _ = wait.recv();
            }
            _ => {}
        }
    }
}

/// What was asked for last is still done before carrom is left.
impl Drop for Keeper {
    fn drop(&mut self) {
        self.jobs = None;
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
