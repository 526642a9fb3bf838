//! The state of a round, and the layout of its steps.

use std::time::Duration;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::ClassAction;
use crate::class::{ClassRound, ClassStep, Session};
use crate::quiz::Question;
use crate::screens::View;
use crate::screens::view::Layout;
use crate::widgets::Look;
use crate::widgets::panel::{Beside, Panel};
use crate::widgets::panels::Heading;

/// The state of a round, and how it is shown.
#[derive(Debug, Clone)]
pub(super) struct Stage {
    pub(super) session: Session,
    /// The remaining time of a countdown, if one is shown.
    pub(super) countdown: Option<Duration>,
    /// Whether only the text of the question is shown.
    pub(super) words_alone: bool,
    /// Whether the scoreboard shows the names of pupils on devices.
    pub(super) names_shown: bool,
}

impl Stage {
    /// The current state of the round.
    pub(super) fn round(&self) -> &ClassRound {
        self.session.round()
    }

    pub(super) fn question(&self) -> Option<&Question> {
        self.session.round().questions().get(self.number())
    }

    /// The number of the current question, counted from 0.
    pub(super) fn number(&self) -> usize {
        self.session.round().place().question
    }

    pub(super) fn step(&self) -> ClassStep {
        self.session.round().place().step
    }

    /// A panel for the text of the current step. While the class votes and talks, the panel's first
    /// page shows all choices. The panel stays on the page to which the teacher has turned.
    pub(super) fn words(&self) -> Panel<ClassAction> {
        let mut panel = Panel::new("");
        panel.open = true;
        panel.subject = 1 + 8 * self.number() + self.step() as usize;
        panel.together = !matches!(self.step(), ClassStep::Describe | ClassStep::Predict);
        panel.stays = true;
        panel
    }

    /// The view of a step: its name and instruction, the picture, and the text as large as
    /// possible.
    pub(super) fn step_view<'s>(
        &self,
        heading: Option<Heading>,
        beside: Beside,
        draw: impl Fn(Rect, &mut Buffer, &Look) + 's,
        words: Panel<ClassAction>,
    ) -> View<'s, ClassAction> {
        let corner = self.countdown.map(|left| {
            let seconds = left.as_nanos().div_ceil(1_000_000_000);
            format!("{}:{:02}", seconds / 60, seconds % 60)
        });
        View {
            heading,
            corner,
            layout: Layout::ForTheBackRow(beside),
            ..View::picture("", draw, words)
        }
    }
}
