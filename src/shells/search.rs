//! Runs the searches that the app asks for.

use crate::game::opponent;
use crate::messages::{Found, SearchResult, SearchTask, Wanted};

/// Runs a search to its end. The same task always has the same result.
pub fn search(task: &SearchTask) -> SearchResult {
    let found = match task.wanted {
        Wanted::Stroke(strength) => Found::Stroke(opponent::think(&task.game, strength, task.seed)),
        Wanted::Hint => Found::Hint(opponent::hint(&task.game, task.seed)),
    };
    SearchResult {
        ticket: task.ticket,
        found,
    }
}
