//! The suggestions of the home screen.

use crate::lessons::Book;
use crate::numbers::counted;
use crate::progress::Due;
use crate::quiz::{Code, Course, CourseKind};
use crate::screens::recall::Recall;
use crate::screens::{Context, Route};

/// Something to do next, above the menu.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Suggestion {
    /// Return to the class that the pupil left.
    Class(Route),
    /// Continue a chapter.
    Continue {
        /// Its index among all chapters.
        chapter: usize,
        /// The line in the menu.
        text: String,
    },
    /// Review what is due.
    Review(Due),
    /// Find out what the player believes.
    FindOut,
}

/// Whether the player has done nothing yet, as far as is known.
pub(super) fn is_new(history: &Recall, book: &Book) -> bool {
    let nothing = matches!(history, Recall::Known(known) if known.attempts.is_empty());
    nothing && book.is_known() && !book.is_begun()
}

/// What to do next. Suggestions from the player's answers appear only once these are loaded.
pub(super) fn suggestions(history: &Recall, cx: &Context) -> Vec<Suggestion> {
    let class = cx.class.clone().map(Suggestion::Class);
    let next = alone(history, &cx.book).into_iter();
    class.into_iter().chain(next).collect()
}

/// What to do next, outside a class.
fn alone(history: &Recall, book: &Book) -> Vec<Suggestion> {
    if is_new(history, book) {
        return vec![Suggestion::FindOut];
    }
    let due = history
        .history()
        .map(|it| Due::of(&it.attempts, &it.calendar))
        .filter(|due| !due.now.is_empty());
    let reading = book.reading_on().and_then(|(chapter, page)| {
        let number = book.chapter(chapter)?.number;
        let text = match page {
            Some(page) => format!("Continue chapter {number}, page {}", page + 1),
            None => format!("Continue with chapter {number}"),
        };
        Some(Suggestion::Continue { chapter, text })
    });
    reading
        .into_iter()
        .chain(due.map(Suggestion::Review))
        .collect()
}

impl Suggestion {
    /// The letter that opens the suggestion.
    pub(super) fn key(&self) -> char {
        match self {
            Self::Class(_) => 'j',
            Self::Continue { .. } => 'n',
            Self::Review(_) => 'r',
            Self::FindOut => 'b',
        }
    }

    /// Its line in the menu.
    pub(super) fn text(&self) -> String {
        match self {
            Self::Class(_) => "Back to your class".into(),
            Self::Continue { text, .. } => text.clone(),
            Self::Review(due) => format!("{} due: review", counted(due.now.len(), "topic")),
            Self::FindOut => "Find out what you believe".into(),
        }
    }

    /// The route that the suggestion opens.
    pub(super) fn route(&self, cx: &mut Context) -> Route {
        let kind = match self {
            Self::Class(route) => return route.clone(),
            Self::Continue { chapter, .. } => return Route::Chapter { number: *chapter },
            Self::Review(due) => due.course(),
            Self::FindOut => CourseKind::with_id("find-out"),
        };
        let code = kind.map(|kind| Code {
            course: Course::new(kind),
            seed: cx.next_seed(),
        });
        Route::Quiz { code }
    }
}
