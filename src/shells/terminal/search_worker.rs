//! Searches beside the app, so that the screen never waits.

use std::panic::{self, AssertUnwindSafe};
use std::sync::mpsc::Sender;

use super::{message::Message, spawn};
use crate::messages::{Input, SearchResult, SearchTask};
use crate::shells::search::search;

/// Starts a thread that does this search and sends its result. Where there can be no more
/// threads it is done on the spot.
pub(super) fn start(task: &SearchTask, sender: &Sender<Message>) {
    let (own_task, own_sender) = (task.clone(), sender.clone());
    let run = move || send(or_failed(&own_task, search), &own_sender);
    if spawn("search", run).is_err() {
        send(search(task), sender);
    }
}

/// The result of a search. A panic in it, of which there is a report in crash.log, is a
/// failed search: the screen must not wait for ever.
fn or_failed(task: &SearchTask, search: impl FnOnce(&SearchTask) -> SearchResult) -> SearchResult {
    // Nothing that a panic may have left half done is seen again.
    let result = panic::catch_unwind(AssertUnwindSafe(|| search(task)));
    result.unwrap_or_else(|_| task.failed())
}

fn send(result: SearchResult, sender: &Sender<Message>) {
    // Nobody listens any more only when carrom is leaving anyway.
    let _ = sender.send(Message::Input(Input::Searched(Box::new(result))));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::{Game, GameSetup};
    use crate::messages::{Found, Wanted};

    #[test]
    fn a_panic_is_a_failed_search() {
        let task = SearchTask {
            ticket: 7,
            game: Game::new(GameSetup::default()),
            seed: 1,
            wanted: Wanted::Hint,
        };
        let result = or_failed(&task, |_| panic!("in the search"));
        assert_eq!((result.ticket, result.found), (7, Found::Failed));
        assert_eq!(or_failed(&task, SearchTask::failed), task.failed());
    }
}
