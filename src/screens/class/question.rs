//! The text of a question, and how much its picture adds to it.

use super::ClassAction;
use super::stage::Stage;
use crate::class::{Vote, WayOfVoting};
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
    for (i, choice) in choices(play, question).iter().enumerate() {
        let words = format!("{}: {}", letter(i), in_short(question, choice));
        let count = votes.as_ref().map(|votes| {
            let count = votes.iter().filter(|it| *it == choice).count();
            (count, count as f64 / votes.len().max(1) as f64)
        });
        let words = match count {
            None => words,
            Some((count, _)) => format!("{words} ({count})"),
        };
        panel.large_choice(words, count.map(|(_, share)| share), picks(i));
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

/// The choices of a question. If hands or cards are counted and a question has no choices, its
/// possible answers are used instead.
fn choices(play: &Stage, question: &Question) -> Vec<Response> {
    let has_any = matches!(question.form, Form::Choice { .. });
    match has_any || play.round().way() == WayOfVoting::Tally {
        true => play.round().choices(play.number()),
        false => Vec::new(),
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
