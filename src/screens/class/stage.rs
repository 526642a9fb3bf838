//! Where a round stands, and what each of its steps is shown on.

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

/// A round as it stands, and what is shown of it.
#[derive(Debug, Clone)]
pub(super) struct Stage {
    pub(super) session: Session,
    /// The time that is left of a countdown, where one is shown.
    pub(super) countdown: Option<Duration>,
    /// Whether the words of the question have the screen to themselves.
    pub(super) words_alone: bool,
    /// Whether the names of pupils on devices may stand on the scoreboard.
    pub(super) names_shown: bool,
}

impl Stage {
    /// The round as it stands.
    pub(super) fn round(&self) -> &ClassRound {
        self.session.round()
    }

    pub(super) fn question(&self) -> Option<&Question> {
        self.session.round().questions().get(self.number())
    }

    /// Its number, from 0.
    pub(super) fn number(&self) -> usize {
        self.session.round().place().question
    }

    pub(super) fn step(&self) -> ClassStep {
        self.session.round().place().step
    }

    /// A panel for the words of the step at hand, which are read from their beginning.
    pub(super) fn words(&self) -> Panel<ClassAction> {
        let mut panel = Panel::new("");
        panel.open = true;
        panel.subject = 8 * self.number() + self.step() as usize;
        panel
    }

    /// A step of a question: what it is called and what to do, the picture, and words as large
    /// as they fit.
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
