//! The page that explains a wrong answer, named and opened.

use super::{Context, Next, Route};
use crate::lessons::Book;
use crate::quiz::Passage;
use crate::widgets::panel::Panel;

/// Opens the page over the screen that names it, which is unchanged below.
pub(in crate::screens) fn open(passage: Option<Passage>, cx: &Context) -> Next {
    let found = passage.and_then(|passage| cx.book.find(passage));
    found.map_or(Next::Stay, |(number, page)| {
        Next::Open(Route::Page { number, page })
    })
}

/// Names the page, which `action` opens.
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
