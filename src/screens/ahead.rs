//! The player's next step, the reason for it, and the progress so far, as several screens show
//! them.

use super::recall::Recall;
use super::{Context, Next, Route};
use crate::lessons::Book;
use crate::messages::{Input, StoreRequest};
use crate::path::{NextStep, PathDone, Step};
use crate::quiz::{Course, Passage};
use crate::widgets::Role;
use crate::widgets::panel::Panel;

/// The player's record, and the next step once the whole record is known.
#[derive(Debug, Clone, Default)]
pub(super) struct Ahead {
    /// The player whose record this is.
    player: String,
    pub(super) history: Recall,
    found: Option<(NextStep, PathDone)>,
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
            ..Self::default()
        }
    }

    /// Requests the record again, because the player has done something; until it arrives, the
    /// earlier record of the same player is shown.
    pub(super) fn ask_again(&mut self, cx: &mut Context) {
        let fresh = Self::ask(cx);
        match fresh.player == self.player {
            true => self.history.ticket = fresh.history.ticket,
            false => *self = fresh,
        }
    }

    /// Handles an answer from the store, which may belong to one of the requests.
    pub(super) fn input(&mut self, input: &Input, cx: &Context) -> Next {
        let Input::Kept(answer) = input else {
            return Next::Ignored;
        };
        self.history.take(answer);
        if let Some(history) = self.history.known()
            && cx.book.is_known()
        {
            let so_far = cx.so_far(history);
            self.found = Some((so_far.next_step(), so_far.done()));
        }
        Next::Stay
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
        let step = self.step();
        step.map_or(Next::Stay, |it| Next::Open(route(&it.step, cx)))
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
    match (step, step.round()) {
        // The screen for choosing a round explains the round before it begins.
        (Step::FindOut, _) => Route::Quiz(None),
        (_, Some(kind)) => Route::Quiz(Some(cx.next_code(Course::new(kind)))),
        (&Step::ReadPage { chapter, page }, _) => Route::Page { chapter, page },
        (&Step::Read { chapter, page }, _) => {
            let left = cx.book.chapter(chapter).map(|it| cx.book.left_at(it));
            match page.filter(|page| left != Some(*page)) {
                Some(page) => Route::Page { chapter, page },
                None => Route::Chapter(chapter),
            }
        }
        (&Step::Level(number), _) => Route::Level(number),
        _ => Route::Table,
    }
}
