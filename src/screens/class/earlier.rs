//! The list of earlier rounds, to take one up again.

use ratatui::buffer::Buffer;
use ratatui::layout::{Margin, Rect};

use super::play::ClassPlay;
use super::set_up::SetUp;
use super::view::column;
use crate::class::ClassRound;
use crate::messages::{Kept, Mouse, StoreAnswer, StoreReply, StoreRequest};
use crate::screens::kept_files::{KeptAction, KeptFiles};
use crate::screens::{Context, Next};
use crate::widgets::panels::draw_panel;
use crate::widgets::{Lines, Look, Outcome, Role, text};

/// Rows below the list for what is to be said of the chosen round.
const ABOUT: u16 = 7;

/// The list.
#[derive(Debug, Clone)]
pub(super) struct EarlierRounds {
    /// The page to go back to.
    pub(super) set_up: SetUp,
    pub(super) rounds: KeptFiles<ClassRound>,
}

impl EarlierRounds {
    /// The list, which is asked for.
    pub(super) fn ask(set_up: SetUp, cx: &mut Context) -> Self {
        cx.ask(StoreRequest::ListClasses);
        Self {
            set_up,
            rounds: KeptFiles::default(),
        }
    }

    /// Does what a key stands for.
    pub(super) fn act(&mut self, action: KeptAction, cx: &mut Context) -> Next {
        match action {
            KeptAction::List(action) => {
                let outcome = self.rounds.act(action);
                self.opened(outcome, cx)
            }
            KeptAction::Remove => Next::Confirm(KeptFiles::<ClassRound>::ask_to_remove("round")),
        }
    }

    /// Removes the chosen round.
    pub(super) fn remove(&self, cx: &mut Context) {
        if let Some(kept) = self.rounds.chosen() {
            cx.ask(StoreRequest::RemoveClass(kept.name.clone()));
        }
    }

    fn opened(&mut self, outcome: Outcome, cx: &mut Context) -> Next {
        match (outcome, self.rounds.chosen()) {
            (Outcome::Ignored, _) => return Next::Ignored,
            (Outcome::Done(()), Some(kept)) => {
                let ticket = cx.ask(StoreRequest::LoadClass(kept.name.clone()));
                self.rounds.load(ticket);
            }
            _ => {}
        }
        Next::Stay
    }

    /// Takes the mouse.
    pub(super) fn mouse(&mut self, mouse: &Mouse, cx: &mut Context) -> Next {
        let list = list(column(cx.body).inner(Margin::new(1, 1)));
        let shown = list.contains((mouse.column, mouse.row).into());
        let first = self.rounds.first_row(list.height.into());
        let line = shown.then(|| first + usize::from(mouse.row - list.y));
        let outcome = self.rounds.mouse(mouse, line);
        self.opened(outcome, cx)
    }

    /// Takes in what came of what was asked; gives the round that is to be taken up.
    pub(super) fn take_answer(
        &mut self,
        answer: &StoreAnswer,
        cx: &mut Context,
    ) -> Option<Box<ClassPlay>> {
        match &answer.done {
            StoreReply::Classes(rounds) => self.rounds.listed(rounds.clone()),
            StoreReply::Class(loaded) if self.rounds.take_loaded(answer.ticket) => match loaded {
                Ok(round) => {
                    let round = round.as_ref().clone();
                    return Some(Box::new(ClassPlay::with_ticket(round, answer.ticket, cx)));
                }
                Err(reason) => {
                    self.rounds.notice = Some(format!("It cannot be taken up: {reason}."));
                }
            },
            StoreReply::Removed(result) => {
                self.rounds.removed(result);
                cx.ask(StoreRequest::ListClasses);
            }
            _ => {}
        }
        None
    }

    /// Draws the list.
    pub(super) fn draw(&self, area: Rect, buf: &mut Buffer, look: &Look) {
        let frame = column(area);
        let inside = draw_panel(buf, frame, "earlier rounds", look.charset, &look.theme);
        let mut lines = Lines::new(inside, buf, *look);
        let rows = list(inside).height.into();
        let width = usize::from(lines.width());
        let title = |kept: &Kept<ClassRound>| {
            let age = kept.age.map(text::ago).unwrap_or_default();
            let title = match &kept.content {
                Ok(round) => format!("{}: {}", round.code(), round.teams().join(", ")),
                Err(_) => format!("{}: not readable", kept.name),
            };
            text::clipped(
                &look.charset.text(&title),
                width.saturating_sub(text::width(&age) + 4),
            )
        };
        let about = (
            "earlier rounds",
            "Every round is saved by itself, after each vote.",
        );
        self.rounds.write(rows, about, title, &mut lines);
        self.rounds.write_about(&mut lines, |round, lines| {
            let number = round.place().question + 1;
            let place = format!("Question {number} of {}.", round.questions().len());
            lines.paragraph(&place, Role::Text);
            lines.paragraph(&round.teams().join(", "), Role::Dim);
            lines.gap();
            lines.paragraph("Enter: take it up where it was left.", Role::Key);
        });
    }
}

/// The place of the list.
fn list(inside: Rect) -> Rect {
    Rect {
        height: inside.height.saturating_sub(ABOUT).max(1),
        ..inside
    }
}
