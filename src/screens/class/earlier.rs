//! The list of earlier rounds, from which one can be resumed.

use jiff::civil::Date;

use super::{ClassAction, ClassScene};
use crate::class::{ClassRound, Vote, WayOfVoting};
use crate::messages::{FileKind, Kept, StoreAnswer, StoreReply};
use crate::numbers::counted;
use crate::progress::long_day;
use crate::screens::kept_files::{KeptAction, KeptFiles, KeptKind};
use crate::screens::{Context, View};
use crate::widgets::input::ListAction;
use crate::widgets::panel::Panel;
use crate::widgets::{Role, text};

/// The maximum width, in columns, of the names in the description of a round.
const NAMES: usize = 180;

pub(super) const ROUNDS: KeptKind = KeptKind {
    file: FileKind::Class,
    one: "round",
    all: "earlier rounds",
    saved: "carrom saves every round after each vote.",
};

/// Handles the answer to a request; returns the round to resume.
pub(super) fn take_answer(
    rounds: &mut KeptFiles<ClassRound>,
    answer: &StoreAnswer,
    cx: &mut Context,
) -> Option<ClassScene> {
    match &answer.done {
        StoreReply::Classes(found) => rounds.listed(found.clone()),
        StoreReply::Class(loaded) if rounds.take_loaded(answer.ticket) => {
            let resumed = ClassScene::resume(loaded, answer.ticket, cx);
            return resumed
                .map_err(|trouble| rounds.notice = Some(trouble))
                .ok();
        }
        StoreReply::Removed(result) => rounds.removed(result, cx),
        _ => {}
    }
    None
}

/// The list, and below it the description of the chosen round.
pub(super) fn view(rounds: &KeptFiles<ClassRound>) -> View<'_, ClassAction> {
    let mut panel = Panel::new("earlier rounds");
    let title = |kept: &Kept<ClassRound>| match &kept.content {
        Ok(round) => titled(round, kept.day),
        Err(_) => format!("{}: cannot be read", kept.name),
    };
    panel.part(ClassAction::Earlier, |panel| {
        rounds.write_list(title, panel);
    });
    panel.pin_below();
    rounds.write_chosen(&mut panel, |round, panel| {
        let number = round.place().question + 1;
        let place = format!("Question {number} of {}.", round.questions().len());
        panel.paragraph(place, Role::Text);
        panel.paragraph(text::clipped(&round.teams().join(", "), NAMES), Role::Dim);
        panel.gap();
        let take_up = ClassAction::Earlier(KeptAction::List(ListAction::Open));
        panel.prompt("resume it where it stopped", take_up);
    });
    View::text(panel)
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

/// The number of participants: "27 pupils", "4 teams"; if hands are counted, the largest number of
/// votes on a question.
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
