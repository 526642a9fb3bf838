//! The list of earlier rounds, from which one can be resumed.

use jiff::civil::Date;

use super::ClassAction;
use super::play::ClassPlay;
use super::set_up::SetUp;
use crate::class::{ClassRound, Vote, WayOfVoting};
use crate::messages::{Kept, StoreAnswer, StoreReply, StoreRequest};
use crate::numbers::counted;
use crate::progress::long_day;
use crate::screens::kept_files::{KeptAction, KeptFiles, KeptKind};
use crate::screens::view::WIDEST;
use crate::screens::{Context, View};
use crate::widgets::input::ListAction;
use crate::widgets::panel::Panel;
use crate::widgets::{Role, SplitLayout, text};

/// The maximum width, in columns, of the names in the row of a round.
const NAMES: usize = 180;

const ROUNDS: KeptKind = KeptKind {
    one: "round",
    all: "earlier rounds",
    saved: "carrom saves every round after each vote.",
    list: StoreRequest::ListClasses,
    load: StoreRequest::LoadClass,
    remove: StoreRequest::RemoveClass,
};

#[derive(Debug, Clone)]
pub(super) struct EarlierRounds {
    /// The page to go back to.
    pub(super) set_up: SetUp,
    pub(super) rounds: KeptFiles<ClassRound>,
}

impl EarlierRounds {
    /// Requests the list, which is empty until the answer arrives.
    pub(super) fn ask(set_up: SetUp, cx: &mut Context) -> Self {
        let rounds = KeptFiles::ask(ROUNDS, cx);
        Self { set_up, rounds }
    }

    /// Handles the answer to a request; returns the round to resume.
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
                    self.rounds.notice = Some(format!("The round cannot be resumed: {reason}."));
                }
            },
            StoreReply::Removed(result) => self.rounds.removed(result, cx),
            _ => {}
        }
        None
    }

    /// The list, and below it the description of the chosen round.
    pub(super) fn view(&self) -> View<'_, ClassAction> {
        let mut panel = Panel::new("earlier rounds");
        let title = |kept: &Kept<ClassRound>| match &kept.content {
            Ok(round) => titled(round, kept.day),
            Err(_) => format!("{}: cannot be read", kept.name),
        };
        panel.part(ClassAction::Earlier, |panel| {
            self.rounds.write_list(title, panel);
        });
        panel.pin_below();
        self.rounds.write_chosen(&mut panel, |round, panel| {
            let number = round.place().question + 1;
            let place = format!("Question {number} of {}.", round.questions().len());
            panel.paragraph(place, Role::Text);
            panel.paragraph(text::clipped(&round.teams().join(", "), NAMES), Role::Dim);
            panel.gap();
            let take_up = ClassAction::Earlier(KeptAction::List(ListAction::Open));
            panel.prompt("resume it where it stopped", take_up);
        });
        View::alone(|room| SplitLayout::text_of(room, WIDEST), panel)
    }
}

/// A round in one line: its class, its code, the number of participants, and the day.
fn titled(round: &ClassRound, day: Option<Date>) -> String {
    let class = match round.class() {
        "" => String::new(),
        class => format!("{class}: "),
    };
    let day = day.map_or(String::new(), |day| format!(", {}", long_day(day)));
    format!("{class}{}, {}{day}", round.code(), head_count(round))
}

/// The number of participants: "27 pupils", "4 teams"; for counted hands, the largest count.
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
