//! The player's next step, the reason for it, and the progress so far, as several screens show
//! them.

use super::recall::Recall;
use super::{Context, Next, Route};
use crate::lessons::Book;
use crate::messages::{StoreAnswer, StoreRequest};
use crate::path::{NextStep, PathDone, PathSoFar, Step};
use crate::quiz::{Code, Course, Passage};
use crate::widgets::Role;
use crate::widgets::panel::Panel;

/// The player's record, and the next step once the whole record is known.
#[derive(Debug, Clone)]
pub(super) struct Ahead {
    /// The player whose record this is.
    player: String,
    pub(super) history: Recall,
    /// The request for the updated record. Until the reply arrives, the earlier record is shown.
    again: Option<Recall>,
    found: Option<(NextStep, PathDone)>,
}

impl Default for Ahead {
    /// Nothing has been requested yet.
    fn default() -> Self {
        Self {
            player: String::new(),
            history: Recall::Asked(0),
            again: None,
            found: None,
        }
    }
}

impl Ahead {
    /// Requests everything that the next step depends on.
    pub(super) fn ask(cx: &mut Context) -> Self {
        cx.ask_for_marks();
        let player = cx.settings.player.clone();
        cx.ask(StoreRequest::Stars(player.clone()));
        Self {
            player,
            history: Recall::ask(cx),
            again: None,
            found: None,
        }
    }

    /// Requests the record again, because the player has done something.
    pub(super) fn ask_again(&mut self, cx: &mut Context) {
        let fresh = Self::ask(cx);
        match fresh.player == self.player {
            true => self.again = Some(fresh.history),
            false => *self = fresh,
        }
    }

    /// Handles `answer`, if it belongs to one of the requests.
    pub(super) fn take(&mut self, answer: &StoreAnswer, cx: &Context) {
        self.history.take(answer);
        if let Some(again) = &mut self.again {
            again.take(answer);
            if !matches!(again, Recall::Asked(_)) {
                self.history = again.clone();
                self.again = None;
            }
        }
        let Recall::Known(history) = &self.history else {
            return;
        };
        if cx.book.is_known() {
            let so_far = PathSoFar {
                attempts: &history.attempts,
                calendar: &history.calendar,
                book: &cx.book,
                shelf: &cx.shelf,
            };
            self.found = Some((so_far.next_step(), so_far.done()));
        }
    }

    /// The next step, once it is known.
    pub(super) fn step(&self) -> Option<&NextStep> {
        self.found.as_ref().map(|(step, _)| step)
    }

    /// Whether the next step is to read this page.
    pub(super) fn is_page(&self, passage: Passage, book: &Book) -> bool {
        let page = book.find(passage);
        self.step().is_some_and(|next| match next.step {
            Step::ReadPage { chapter, page: at } => page == Some((chapter, at)),
            _ => false,
        })
    }

    /// Opens the next step on top of the screen that shows it.
    pub(super) fn follow(&self, cx: &mut Context) -> Next {
        let step = self.step().map(|it| it.step.clone());
        step.map_or(Next::Stay, |step| Next::Open(route(&step, cx)))
    }

    /// Writes the next step, which `action` opens, and the reason for it.
    pub(super) fn write<A>(&self, action: A, panel: &mut Panel<A>) {
        if let Some((next, _)) = &self.found {
            panel.paragraph(&next.why, Role::Text);
            panel.prompt(&next.words, action);
        }
    }

    /// Writes how much of the path is done.
    pub(super) fn write_done<A>(&self, panel: &mut Panel<A>) {
        let Some((_, done)) = self.found else {
            return;
        };
        for (name, (some, all)) in [
            ("chapters", done.chapters),
            ("misconceptions settled", done.beliefs),
            ("level packs", done.packs),
        ] {
            if all > 0 {
                panel.meter(name, some as f64 / all as f64, format!("{some} of {all}"));
            }
        }
    }
}

/// The route that a step opens.
fn route(step: &Step, cx: &mut Context) -> Route {
    if let Step::FindOut = step {
        // The screen for choosing a round explains the round before it begins.
        return Route::Quiz { code: None };
    }
    if let Some(kind) = step.round() {
        let code = Code {
            course: Course::new(kind),
            seed: cx.next_seed(),
        };
        return Route::Quiz { code: Some(code) };
    }
    match *step {
        Step::ReadPage { chapter, page } => Route::Page {
            number: chapter,
            page,
        },
        Step::Read { chapter, page } => {
            let left = cx.book.chapter(chapter).map_or(0, |of_it| {
                cx.book.mark(&of_it.id).map_or(0, |mark| mark.page(of_it))
            });
            match page.filter(|page| *page != left) {
                Some(page) => Route::Page {
                    number: chapter,
                    page,
                },
                None => Route::Chapter { number: chapter },
            }
        }
        Step::Level(number) => Route::Level { number },
        _ => Route::Table,
    }
}
