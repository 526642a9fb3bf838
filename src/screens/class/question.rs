//! The text of a question, and how much its picture adds to it.

use super::ClassAction;
use super::stage::Stage;
use crate::class::Vote;
use crate::quiz::{Form, Illustration, Question, Response, letter};
use crate::widgets::hit::degrees;
use crate::widgets::panel::{Beside, Panel};
use crate::widgets::{Role, brief};

/// Writes a question with its choices and, if `vote` is given, the number of votes for each.
pub(super) fn write(
    play: &Stage,
    question: &Question,
    vote: Option<Vote>,
    picks: impl Fn(usize) -> Option<ClassAction>,
    panel: &mut Panel<ClassAction>,
) {
    let votes = vote.map(|vote| play.round().said(play.number(), vote).collect::<Vec<_>>());
    panel.large_text(question.text.as_str(), Role::Title);
    for (i, choice) in play.round().offered(play.number()).iter().enumerate() {
        let mut words = format!("{}: {}", letter(i), in_short(question, choice));
        let share = votes.as_ref().map(|votes| {
            let count = votes.iter().filter(|it| *it == choice).count();
            words += &format!(" ({count})");
            count as f64 / votes.len().max(1) as f64
        });
        panel.large_choice(words, share, picks(i));
    }
}

/// An answer in short form; for rays, their angles in degrees with the letters of the discs.
fn in_short(question: &Question, choice: &Response) -> String {
    match (choice, question.picture.collision()) {
        (Response::Rays(rays), Some(collision)) => {
            let [striker, target] = degrees(collision, rays).map(|angle| match angle {
                Some(_) => format!("{}°", brief(angle)),
                None => brief(angle),
            });
            format!("S {striker}, C {target}")
        }
        _ => question.form.words(choice),
    }
}

/// How much the picture of a question adds to its text.
pub(super) fn beside(question: &Question) -> Beside {
    match (&question.picture, &question.form) {
        (Illustration::Nothing, _) => Beside::Nothing,
        (Illustration::Before { shown, .. }, Form::Rays { .. }) if !shown.figures => Beside::Needed,
        (Illustration::Before { .. }, Form::Shot(_)) => Beside::Needed,
        (Illustration::Before { .. }, _) => Beside::Helps,
        (Illustration::After { .. } | Illustration::Tracks { .. }, _) => Beside::Needed,
    }
}
