//! Reading a chapter.

use std::time::Duration;

use carrom::lessons::{ChapterPage, CheckpointKind};
use carrom::shells::Headless;

/// Presses keys that answer a page's question, if it has one; any answer is sufficient.
pub(crate) fn answer(game: &mut Headless, page: &ChapterPage) {
    match page.checkpoint.as_ref().map(|checkpoint| &checkpoint.asked) {
        None => return,
        Some(CheckpointKind::Rays) => game.press("40<Enter>40<Enter><End>"),
        Some(CheckpointKind::Number { .. }) => game.press("1<Enter>"),
        Some(CheckpointKind::Choice(_)) => game.press("2<Enter>"),
    }
    // The second try is skipped, if there is one.
    let rows = game.app().keys();
    if rows.rows().iter().any(|row| row.id == "reading.show-it") {
        let is_hit = matches!(
            page.checkpoint.as_ref().map(|checkpoint| &checkpoint.asked),
            Some(CheckpointKind::Rays)
        );
        // The explanation of a collision is shown to its last step.
        game.press(if is_hit { "s<End>" } else { "s" });
    }
    assert!(game.settle(Duration::from_secs(120)));
}
