//! Thinks beside the app, so that the screen never waits.

use std::panic::{self, AssertUnwindSafe};
use std::sync::mpsc::Sender;
use std::thread;

use super::message::Message;
use crate::messages::{Input, Task, Thought};

/// Starts a thread that thinks about `task` and sends what it found. Where there can
/// be no more threads it is done on the spot.
pub(super) fn start(task: &Task, sender: &Sender<Message>) {
    let (own_task, own_sender) = (task.clone(), sender.clone());
    let thinker = thread::Builder::new().name("thinker".into());
    let think = move || send(or_failed(&own_task, Task::think), &own_sender);
    if thinker.spawn(think).is_err() {
        send(task.think(), sender);
    }
}

/// What comes of a task; a fault, of which there is a report in crash.log, must not leave
/// the screen waiting for ever.
fn or_failed(task: &Task, think: impl FnOnce(&Task) -> Thought) -> Thought {
    // Nothing that a fault may have left half done is seen again.
    let thought = panic::catch_unwind(AssertUnwindSafe(|| think(task)));
    thought.unwrap_or_else(|_| task.failed())
}

fn send(thought: Thought, sender: &Sender<Message>) {
    // Nobody listens any more only when carrom is leaving anyway.
    let _ = sender.send(Message::Input(Input::Thought(Box::new(thought))));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::{Game, Setup};
    use crate::messages::{Found, Wanted};

    #[test]
    fn a_fault_is_a_thought_that_failed() {
        let task = Task {
            ticket: 7,
            game: Game::new(Setup::default()),
            seed: 1,
            wanted: Wanted::Hint,
        };
        let thought = or_failed(&task, |_| panic!("a fault"));
        assert_eq!((thought.ticket, thought.found), (7, Found::Failed));
        assert_eq!(or_failed(&task, Task::failed), task.failed());
    }
}
