//! The words of a question, and where its picture stands.

use super::words::{Beside, Paragraph};
use crate::quiz::{Form, Illustration, Question, Response, letter};
use crate::widgets::Role;

/// A question with its choices; with `votes`, how many are for each.
pub(super) fn paragraphs(question: &Question, votes: Option<&[Response]>) -> Vec<Paragraph> {
    let mut paragraphs = vec![Paragraph::new(question.text.as_str(), Role::Title)];
    for (i, option) in options(question).iter().enumerate() {
        let words = format!("{}: {option}", letter(i));
        let count = votes.map(|votes| {
            let count = votes.iter().filter(|it| **it == Response::Choice(i));
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

/// The choices of a question that has any.
fn options(question: &Question) -> &[String] {
    match &question.form {
        Form::Choice { options, .. } => options,
        _ => &[],
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
