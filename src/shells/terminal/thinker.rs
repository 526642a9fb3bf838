//! Thinks beside the app, so that the screen never waits.

use std::sync::mpsc::Sender;
use std::thread;

use super::message::Message;
use crate::messages::{Input, Task};

/// Starts a thread that thinks about `task` and sends what it found. Where there can
/// be no more threads it is done on the spot.
pub(super) fn start(task: &Task, sender: &Sender<Message>) {
    let (own_task, own_sender) = (task.clone(), sender.clone());
    let thinker = thread::Builder::new().name("thinker".into());
    if thinker
        .spawn(move || think(&own_task, &own_sender))
        .is_err()
    {
        think(task, sender);
    }
}

fn think(task: &Task, sender: &Sender<Message>) {
    let thought = Input::Thought(Box::new(task.think()));
    // Nobody listens any more only when carrom is leaving anyway.
    let _ = sender.send(Message::Input(thought));
}
