//! The words of a question, and where its picture stands.

use super::play::ClassPlay;
use super::words::{Beside, Paragraph};
use crate::class::{Vote, WayOfVoting};
use crate::quiz::{Form, Illustration, Question, Response, letter};
use crate::widgets::hit::degrees;
use crate::widgets::{Role, brief};

/// A question with its choices; with `vote`, how many were for each.
pub(super) fn paragraphs(
    play: &ClassPlay,
    question: &Question,
    vote: Option<Vote>,
) -> Vec<Paragraph> {
    let votes = vote.map(|vote| play.round().said(play.number(), vote).collect::<Vec<_>>());
    let mut paragraphs = vec![Paragraph::new(question.text.as_str(), Role::Title)];
    for (i, choice) in choices(play, question).iter().enumerate() {
        let words = format!("{}: {}", letter(i), in_short(question, choice));
        let count = votes.as_ref().map(|votes| {
            let count = votes.iter().filter(|it| *it == choice);
            (count.count(), votes.len().max(1))
        });
        let words = match count {
            None => words,
            Some((count, _)) => format!("{words} ({count})"),
        };
        paragraphs.push(Paragraph {
            whole: true,
            share: count.map(|(count, all)| count as f64 / all as f64),
            ..Paragraph::new(words, Role::Text)
        });
    }
    paragraphs
}

/// A choice as short as it can be: of rays their degrees, with the letters of the discs.
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

/// What there is to choose from: the choices of a question that has any; where hands or cards are
/// counted, answers of every question.
fn choices(play: &ClassPlay, question: &Question) -> Vec<Response> {
    let has_any = matches!(question.form, Form::Choice { .. });
    match has_any || play.round().way() == WayOfVoting::Tally {
        true => play.round().choices(play.number()),
        false => Vec::new(),
    }
}

/// Whether the picture of a question says what its words do not.
pub(super) fn beside(question: &Question) -> Beside {
    match (&question.picture, &question.form) {
        (Illustration::Nothing, _) => Beside::Nothing,
        (Illustration::Before { shown, .. }, Form::Rays { .. }) if !shown.figures => Beside::Needed,
        (Illustration::Before { .. }, Form::Shot(_)) => Beside::Needed,
        (Illustration::Before { .. }, _) => Beside::Helps,
        (Illustration::After { .. } | Illustration::Tracks { .. }, _) => Beside::Needed,
    }
}
