//! The link to the page that explains a wrong answer or introduces a term.

use super::{Context, Next, Route};
use crate::lessons::Book;
use crate::quiz::Passage;
use crate::widgets::panel::Panel;

/// Opens the page on top of the screen that names it; that screen does not change.
pub(in crate::screens) fn open(passage: Option<Passage>, cx: &Context) -> Next {
    let found = passage.and_then(|passage| cx.book.find(passage));
    found.map_or(Next::Stay, |(chapter, page)| {
        Next::Open(Route::Page { chapter, page })
    })
}

/// Writes the name of the page; `action` opens the page.
pub(in crate::screens) fn write<A>(
    passage: Option<Passage>,
    book: &Book,
    action: A,
    panel: &mut Panel<A>,
) {
    if let Some(words) = passage.and_then(|passage| book.named(passage)) {
        panel.prompt(words, action);
    }
}
