//! Saves games and answers on a separate thread, so that the screen never waits long for the disk.

use std::io::{self, Write};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender, TryRecvError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use super::{message::Message, spawn};
use crate::files::escape_control;
use crate::messages::{Input, PlayerAction, StoreAnswer, StoreCall, StoreReply, StoreRequest};
use crate::store::Store;

/// How long the screen waits for a stroke or a team's vote to be saved before showing it. Nearly
/// all disks are much faster, so a stroke or vote that was shown is hardly ever lost. (The screen
/// does not wait for votes from devices; a pupil's device confirms a vote once it is saved.)
const PATIENCE: Duration = Duration::from_millis(500);
/// How long the screen waits for an answer to be saved before it shows the explanation, so that no
/// answer is lost once it has been explained. If the disk is faulty or another program has locked
/// the database, the screen shows that the answer is being saved, and the player can continue.
const ANSWER_PATIENCE: Duration = Duration::from_secs(1);

/// A thread that carries out requests to the store, one after the other.
pub(super) struct StoreWorker {
    /// Receives the results.
    sender: Sender<Message>,
    /// `None` once there will be no more requests.
    jobs: Option<Sender<Job>>,
    thread: Option<JoinHandle<()>>,
    /// Reports when an overdue save is done.
    late: Option<Receiver<()>>,
}

/// A request, and the channel for its result.
struct Job {
    request: StoreCall,
    done: Sender<()>,
}

impl StoreWorker {
    /// Starts the thread, which sends the result of each request.
    pub(super) fn start(mut store: Store, sender: Sender<Message>) -> io::Result<Self> {
        let (jobs, asked) = mpsc::channel::<Job>();
        let to_app = sender.clone();
        let keep = move || {
            for job in asked {
                send(store.answer(&job.request), &to_app);
                // The caller may have stopped waiting.
                let _ = job.done.send(());
            }
            if let Err(lost) = store.flush_at_end() {
                say(&lost);
            }
        };
        Ok(Self {
            sender,
            jobs: Some(jobs),
            thread: Some(spawn("store", keep)?),
            late: None,
        })
    }

    /// Passes a request to the thread. Returns `true` if the request takes so long that the screen
    /// should report the delay. The result always arrives as an input.
    pub(super) fn ask(&mut self, request: StoreCall) -> bool {
        let patience = match request.request {
            StoreRequest::Save(_) => PATIENCE,
            StoreRequest::Note(PlayerAction::Record(_)) => ANSWER_PATIENCE,
            _ => Duration::ZERO,
        };
        let Some(jobs) = &self.jobs else {
            return false;
        };
        let (done, wait) = mpsc::channel();
        if let Err(mpsc::SendError(job)) = jobs.send(Job { request, done }) {
            // The thread has panicked; its report is in crash.log.
            let refused = Store::refused(&job.request, "the store has stopped");
            send(refused, &self.sender);
            return false;
        }
        if patience.is_zero() {
            return false;
        }
        // A save is overdue; do not block again.
        if let Some(late) = &self.late
            && late.try_recv() == Err(TryRecvError::Empty)
        {
            return true;
        }
        let in_time = wait.recv_timeout(patience) != Err(RecvTimeoutError::Timeout);
        self.late = (!in_time).then_some(wait);
        !in_time
    }
}

/// The last requests are completed before carrom quits.
impl Drop for StoreWorker {
    fn drop(&mut self) {
        self.jobs = None;
        let Some(thread) = self.thread.take() else {
            return;
        };
        let start = Instant::now();
        while !thread.is_finished() && start.elapsed() < ANSWER_PATIENCE {
            thread::sleep(Duration::from_millis(1));
        }
        if !thread.is_finished() {
            say("saving the last changes ...");
        }
        // If the thread has panicked, the panic has already been reported.
        let _ = thread.join();
    }
}

fn send(answer: StoreAnswer, sender: &Sender<Message>) {
    let shown = sender.send(Message::Input(Input::Kept(Box::new(answer))));
    // A send fails only when carrom is quitting anyway.
    if let Err(mpsc::SendError(Message::Input(Input::Kept(answer)))) = shown
        && let StoreReply::Saved(Err(reason)) = answer.done
    {
        say(&format!("the last changes could not be saved: {reason}"));
    }
}

/// Prints a message after the screen has been restored.
fn say(words: &str) {
    // If the terminal's window has been closed, the message cannot be shown.
    let _ = writeln!(io::stderr(), "carrom: {}", escape_control(words, 400));
}

#[cfg(test)]
mod tests {
    use std::{env, fs, process};

    use super::*;
    use crate::levels::Starred;
    use crate::progress::Attempt;
    use crate::quiz::Figures;

    #[test]
    fn a_locked_database_delays_the_screen_only_briefly() {
        let folder = env::temp_dir().join(format!("carrom-store-worker-{}", process::id()));
        let _ = fs::remove_dir_all(&folder);
        let (sender, messages) = mpsc::channel();
        let mut store_worker = StoreWorker::start(Store::in_folder(&folder), sender).unwrap();
        let starred = Starred {
            pack: "first".into(),
            level: "one".into(),
            stars: 1,
        };
        let attempt = Attempt {
            time_s: None,
            player: "Ada".into(),
            family: "speeds".into(),
            topic: "speeds".into(),
            seed: 7,
            number: 1,
            question: Figures::new(),
            answer: Figures::new(),
            truth: Figures::new(),
            error_deg: None,
            credit: 0.0,
            right: false,
            confidence: None,
            misconception: None,
        };
        let star = |ticket| StoreCall {
            ticket,
            request: StoreRequest::Note(PlayerAction::Star("Ada".into(), starred.clone())),
        };
        assert!(
            !store_worker.ask(star(1)),
            "a star does not keep the screen waiting"
        );
        messages.recv().unwrap();
        let other = rusqlite::Connection::open(folder.join("progress.db")).unwrap();
        other.execute_batch("BEGIN IMMEDIATE").unwrap();
        let record = |ticket| StoreCall {
            ticket,
            request: StoreRequest::Note(PlayerAction::Record(Box::new(attempt.clone()))),
        };
        assert!(store_worker.ask(record(2)), "it is being saved");
        let start = Instant::now();
        assert!(store_worker.ask(record(3)));
        assert!(
            start.elapsed() < ANSWER_PATIENCE,
            "the second save waited too"
        );
        other.execute_batch("COMMIT").unwrap();
        for expected in [2, 3] {
            match messages.recv().unwrap() {
                Message::Input(Input::Kept(answer)) => {
                    assert_eq!(
                        (answer.ticket, &answer.done),
                        (expected, &StoreReply::Noted(Ok(())))
                    );
                }
                other => panic!("{other:?}"),
            }
        }
        drop(store_worker);
        let _ = fs::remove_dir_all(&folder);
    }
}
