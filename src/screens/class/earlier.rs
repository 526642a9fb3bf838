//! The list of earlier rounds, to take one up again.

use jiff::civil::Date;
use ratatui::buffer::Buffer;
use ratatui::layout::{Margin, Rect};

use super::heading::column;
use super::play::ClassPlay;
use super::set_up::SetUp;
use crate::class::{ClassRound, Vote, WayOfVoting};
use crate::messages::{Kept, Mouse, StoreAnswer, StoreReply, StoreRequest};
use crate::numbers::counted;
use crate::progress::long_day;
use crate::screens::kept_files::{KeptFiles, KeptKind};
use crate::screens::{Context, Next};
use crate::widgets::panels::draw_panel;
use crate::widgets::{Lines, Look, Role, text};

const ROUNDS: KeptKind = KeptKind {
    one: "round",
    all: "earlier rounds",
    saved: "Every round is saved by itself, after each vote.",
    about: 7,
    list: StoreRequest::ListClasses,
    load: StoreRequest::LoadClass,
    remove: StoreRequest::RemoveClass,
};

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
        let rounds = KeptFiles::ask(ROUNDS, cx);
        Self { set_up, rounds }
    }

    pub(super) fn mouse(&mut self, mouse: &Mouse, cx: &mut Context) -> Next {
        let list = column(cx.body).inner(Margin::new(1, 1));
        self.rounds.mouse(mouse, list, cx)
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
            StoreReply::Removed(result) => self.rounds.removed(result, cx),
            _ => {}
        }
        None
    }

    pub(super) fn draw(&self, area: Rect, buf: &mut Buffer, look: &Look) {
        let frame = column(area);
        let inside = draw_panel(buf, frame, "earlier rounds", look.charset, &look.theme);
        let mut lines = Lines::new(inside, buf, *look);
        let width = usize::from(lines.width());
        let title = |kept: &Kept<ClassRound>| {
            let age = kept.age.map(text::ago).unwrap_or_default();
            let title = match &kept.content {
                Ok(round) => titled(round, kept.day),
                Err(_) => format!("{}: not readable", kept.name),
            };
            text::clipped(
                &look.charset.text(&title),
                width.saturating_sub(text::width(&age) + 4),
            )
        };
        self.rounds.write(title, &mut lines);
        self.rounds.write_about(&mut lines, |round, lines| {
            let number = round.place().question + 1;
            let place = format!("Question {number} of {}.", round.questions().len());
            lines.paragraph(&place, Role::Text);
            let names = round.teams().join(", ");
            let names = text::clipped(&look.charset.text(&names), 2 * width);
            lines.paragraph(&names, Role::Dim);
            lines.gap();
            lines.paragraph("Enter: take it up where it was left.", Role::Key);
        });
    }
}

/// A round in a line: its class, its code, how many were in, and the day.
fn titled(round: &ClassRound, day: Option<Date>) -> String {
    let class = match round.class() {
        "" => String::new(),
        class => format!("{class}: "),
    };
    let day = day.map_or(String::new(), |day| format!(", {}", long_day(day)));
    format!("{class}{}, {}{day}", round.code(), head_count(round))
}

/// How many there were: "27 pupils", "4 teams"; of hands the most that were counted at once.
pub(super) fn head_count(round: &ClassRound) -> String {
    let people = round.participants().len();
    match round.way() {
        WayOfVoting::Teams => counted(people, "team"),
        WayOfVoting::Devices => counted(people, "pupil"),
        WayOfVoting::Tally => {
            let questions = 0..round.questions().len();
            let votes = questions.flat_map(|at| Vote::BOTH.map(|vote| round.voted(at, vote)));
            counted(votes.max().unwrap_or(0), "vote")
        }
    }
}
