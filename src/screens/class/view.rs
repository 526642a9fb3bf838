//! How a round being played looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::heading::{Heading, below, centred};
use super::hosting::door_page;
use super::play::{ClassPhase, ClassPlay, EndPage};
use super::step_view::StepView;
use super::{ClassAction, ending_view, scores_view, vote_view};
use crate::class::{ClassStep, Vote};
use crate::messages::{Mouse, MouseKind};
use crate::widgets::big::{Align, Big};
use crate::widgets::input::ListAction;
use crate::widgets::panel::Panel;
use crate::widgets::{AnswerAction, Item, Look, Role, Room, Words, sheet};

impl ClassPlay {
    /// What the step at hand is called, and what to do.
    pub(super) fn heading(&self) -> Option<Heading> {
        let number = format!("Question {}", self.number() + 1);
        let (texts, line): (&[&str], String) = match (&self.phase, self.step()) {
            (ClassPhase::End(EndPage::Board), _) => {
                let tables = "e: write the answers as tables for a spreadsheet";
                let handed = self.session.handed_in();
                let line = match handed {
                    0 => tables.into(),
                    handed => format!("{handed} handed in their own answers. {tables}"),
                };
                (&["The end"], line)
            }
            // They are lists of blocks.
            (ClassPhase::End(_), _) => return None,
            (ClassPhase::Tally(entry), _) => match entry.vote {
                Vote::First => (
                    &["First vote", "Vote 1"],
                    "Show your card, or raise your hand.".into(),
                ),
                Vote::Second => (
                    &["Second vote", "Vote 2"],
                    "Who has changed their mind? Show your card once more.".into(),
                ),
            },
            (ClassPhase::Vote(_), step) => match step {
                ClassStep::SecondVote => (
                    &["Second vote", "Vote 2"],
                    "Who wants to change? All others keep their vote.".into(),
                ),
                _ => (
                    &["First vote", "Vote 1"],
                    "Each team in turn. What is said is hidden.".into(),
                ),
            },
            (ClassPhase::Shot(shown), _) if shown.reveal.is_telling() => {
                (&["The shot"], String::new())
            }
            (ClassPhase::Shot(_), _) => (&["And why"], self.right_in_words()),
            (ClassPhase::Look, ClassStep::FirstVote | ClassStep::SecondVote) => {
                return self.turnout();
            }
            (ClassPhase::Look, ClassStep::Talk) => (
                &["Talk"],
                "These are the votes. Find someone who thinks otherwise, and say why.".into(),
            ),
            (ClassPhase::Look, ClassStep::Scores) => (&["Scores"], String::new()),
            (ClassPhase::Look, _) if self.words_alone => return None,
            (ClassPhase::Look, ClassStep::Predict) => (
                &["Predict in silence", "In silence"],
                "Everyone writes down an answer. Nobody speaks.".into(),
            ),
            (ClassPhase::Look, _) => (&[&number], String::new()),
        };
        Some(Heading::new(texts, line))
    }

    /// How many have voted on devices of their own.
    fn turnout(&self) -> Option<Heading> {
        let (vote, line) = match self.step() {
            ClassStep::SecondVote => (
                Vote::Second,
                "Who wants to change? All others keep their vote.",
            ),
            _ => (
                Vote::First,
                "Everyone predicts in silence, and votes on their own device.",
            ),
        };
        let words = self.session.turnout(vote);
        Some(Heading::new(&[&words], line))
    }

    /// "right at first: 1 of 3, after talking: 2 of 3"
    fn right_in_words(&self) -> String {
        let [first, second] = Vote::BOTH.map(|vote| {
            let results = self.round().results(self.number(), vote);
            format!("{} of {}", results.right, results.attempts)
        });
        format!("right at first: {first}, after talking: {second}")
    }

    /// The step at hand laid out, where it is one of a question.
    pub(super) fn step_view(&self, room: Room, look: &Look) -> Option<StepView<'_>> {
        match (&self.phase, self.step()) {
            (ClassPhase::End(_), _) | (ClassPhase::Look, ClassStep::Scores) => None,
            _ => StepView::new(self, room, look),
        }
    }

    /// What is below the heading where that has all the room it wants.
    fn below_heading(&self, area: Rect, look: &Look) -> Rect {
        self.heading().map_or(area, |it| it.rest(area, look))
    }
}

pub(super) fn draw(play: &ClassPlay, room: Room, buf: &mut Buffer, look: &Look) {
    let area = room.area;
    if play.host_page.is_some() {
        return door_page::draw(&play.session, area, buf, look);
    }
    if let Some(step) = play.step_view(room, look) {
        return step.draw(buf, look);
    }
    if let Some(heading) = play.heading() {
        heading.draw(area, buf, look);
    }
    let rest = play.below_heading(area, look);
    scores_view::draw(play, rest, buf, look);
}

/// What it shows as a list of blocks, where it does.
pub(super) fn panel(play: &ClassPlay) -> Option<Panel<ClassAction>> {
    if let Some(page) = &play.host_page {
        let list = page.panel(&play.session)?;
        let mut panel = Panel::new(list.title.clone());
        panel.part(ClassAction::Hosting, |panel| *panel = list);
        return Some(panel);
    }
    match play.phase {
        ClassPhase::End(page @ (EndPage::Held | EndPage::Items)) => {
            Some(ending_view::panel(play.round(), page))
        }
        _ => None,
    }
}

/// Turns the page of a step, or scrolls a text.
pub(super) fn scroll(play: &mut ClassPlay, rows: i16, room: Room, look: &Look) {
    if let Some(step) = play.step_view(room, look) {
        let last = step.pages().saturating_sub(1);
        let by = isize::from(rows.signum());
        play.page = play.page.min(last).saturating_add_signed(by).min(last);
        return;
    }
    let rest = play.below_heading(room.area, look);
    let text = scores_view::text(play, rest);
    let scrolled = text.map(|(place, write)| play.scroll.by(rows, place, *look, write));
    play.scroll = scrolled.unwrap_or(play.scroll);
}

/// What a click or a turn of the wheel does: it chooses a team or makes its vote, or scrolls.
pub(super) fn meant_by(
    play: &ClassPlay,
    mouse: &Mouse,
    room: Room,
    look: &Look,
) -> Option<ClassAction> {
    let step = play.step_view(room, look)?;
    let entry = match &play.phase {
        ClassPhase::Vote(entry) => Some(entry),
        _ => None,
    };
    let wheel = match mouse.kind {
        MouseKind::ScrollUp => -1,
        MouseKind::ScrollDown => 1,
        MouseKind::Down => {
            let entry = entry?;
            return match &entry.input {
                None => {
                    let row = vote_view::row_at(play.round(), entry, step.foot(), mouse.cell());
                    row.map(|row| ClassAction::Teams(ListAction::Point(row)))
                }
                Some(_) => {
                    let choice = step.choice_at(mouse.cell());
                    choice.map(|choice| ClassAction::Vote(AnswerAction::Choose(choice)))
                }
            };
        }
        _ => return None,
    };
    Some(match entry.is_some_and(|entry| entry.input.is_none()) {
        true => ClassAction::Teams(ListAction::Choose(wheel)),
        false => ClassAction::Scroll(wheel as i16),
    })
}

/// The calm screen of a pause.
pub(super) fn paused(area: Rect, buf: &mut Buffer, look: &Look) {
    let big = Big::fit("paused", area.width, area.height / 2, look.charset);
    let rows = big.as_ref().map_or(1, Big::rows);
    let place = below(area, area.height.saturating_sub(rows) / 2);
    sheet::note(area, || Item::new(Words::large("paused", Role::Dim)));
    match big {
        Some(big) => big.draw(place, buf, look, Role::Dim, Align::Centre),
        None => centred("paused", place, buf, look, Role::Dim),
    }
}
