//! The panel beside the quiz's picture: the question, how sure one is, the answer
//! and why.

use super::{AnsweredQuestion, OpenQuestion};
use crate::lessons::Book;
use crate::quiz::{Confidence, Form, Grade, Ray, Response, explain, letter};
use crate::screens::leads;
use crate::widgets::bar::bar;
use crate::widgets::panel::written;
use crate::widgets::panels::said_and_true;
use crate::widgets::{AnswerInput, Lines, Role, Words};

/// The question, and what is being said to it.
pub(super) fn asked(asked: &OpenQuestion, lines: &mut Lines) {
    let form = &asked.question.form;
    let about = asked.input.about(form);
    let next = match (&asked.input, form) {
        (AnswerInput::Rays(rays), Form::Rays { target, .. }) if rays.turning() == Ray::Striker => {
            format!("Enter: then the {target}.")
        }
        _ => "Enter: then how sure.".into(),
    };
    let head = lines.rows_of(&asked.question.text) + 1;
    let left = lines.left().saturating_sub(head);
    let needed = head + AnswerInput::rows(form, lines, left);
    let mut spare = lines.spare(needed);
    let about = spare.take(lines.rows_of(&about) + 1).then_some(about);
    let next = spare.take(lines.rows_of(&next) + 1).then_some(next);
    lines.paragraph(&asked.question.text, Role::Text);
    lines.gap();
    asked.input.write(form, lines);
    for (text, role) in [(about, Role::Dim), (next, Role::Key)] {
        if let Some(text) = text {
            lines.gap();
            lines.paragraph(&text, role);
        }
    }
}

/// How sure one is, what that may bring, and what one is to be sure of.
pub(super) fn confidence(
    asked: &OpenQuestion,
    chosen: Confidence,
    told_at_end: bool,
    lines: &mut Lines,
) {
    lines.line("How sure are you?", Role::Title);
    let head = |text| (text, Role::Dim);
    lines.columns(head("points if"), &["wrong", "right"].map(head));
    for (number, confidence) in (1..).zip(Confidence::ALL) {
        let points = [0.0, 1.0].map(|credit| format!("{:.0}", confidence.points(credit)));
        lines.target(confidence as usize, |lines| {
            lines.choice(confidence == chosen, Role::Text, |lines, mark, role| {
                let name = format!("{mark} {number} {}", confidence.name());
                let points = points.each_ref().map(|p| (p.as_str(), Role::Text));
                lines.columns((&name, role), &points);
            });
        });
    }
    lines.gap();
    lines.line("You said", Role::Dim);
    said(asked, lines);
    let advice = "Be honest with yourself: that is what brings most points.";
    let mut spare = lines.spare(0);
    if spare.take(lines.rows_of(advice) + 1) {
        lines.gap();
        lines.paragraph(advice, Role::Dim);
    }
    if spare.take(2) {
        lines.gap();
        let next = match asked.question.picture.collision() {
            _ if told_at_end => "Enter: on to the next.",
            Some(_) => "Enter: watch what happens.",
            None => "Enter: see how it is.",
        };
        lines.line(next, Role::Key);
    }
}

fn said(asked: &OpenQuestion, lines: &mut Lines) {
    match (&asked.input, &asked.question.form) {
        (AnswerInput::Rays(rays), Form::Rays { target, .. }) => {
            for (ray, name) in [(Ray::Striker, "striker"), (Ray::Target, *target)] {
                let name = format!("  {name}");
                lines.pair(&name, &rays.shown(ray), Role::Dim, Role::Predicted);
            }
        }
        (input, form) => {
            if let Some(said) = input.said() {
                lines.paragraph(&lettered(form, &said), Role::Predicted);
            }
        }
    }
}

/// An answer in words, a choice with its letter.
fn lettered(form: &Form, said: &Response) -> String {
    match said {
        Response::Choice(i) => format!("{}: {}", letter(*i), form.words(said)),
        _ => form.words(said),
    }
}

/// What the picture is just showing.
pub(super) fn untold(watched: &AnsweredQuestion, lines: &mut Lines) {
    lines.paragraph(&watched.question.text, Role::Dim);
    lines.gap();
    if let Some(watch) = watched.reveal.watch() {
        written::<()>(lines, |panel| watch.write_telling(panel));
    }
}

/// The points, the answer beside the truth, and the one explanation, which comes
/// whole: where there is not room for all, other things give way.
pub(super) fn told(watched: &AnsweredQuestion, lines: &mut Lines, book: &Book) {
    let question = &watched.question;
    let grade = Grade::new(question, &watched.answer);
    let explanation = explain(question, &watched.answer);
    let again = &question.text;
    let title_rows = lines.rows_of(explanation.title);
    let answers = answer_rows(watched, lines);
    let lead = |lines: &mut Lines| leads::write(explanation.passage, book, lines);
    let needed = 1 + answers + title_rows + lines.rows_of(&explanation.text) + lines.rows_by(lead);
    let mut spare = lines.spare(needed);
    let credit = spare.take(1);
    let gap = spare.take(1);
    let gap_before = spare.take(1);
    let apart = spare.take(1);
    let next = spare.take(1);
    if spare.take(lines.rows_of(again) + 1) {
        lines.paragraph(again, Role::Dim);
        lines.gap();
    }
    let role = if grade.right { Role::Good } else { Role::Text };
    lines.pair(&grade.score(), grade.confidence.name(), role, Role::Dim);
    if credit {
        credit_bar(&grade, lines);
    }
    if gap_before {
        lines.gap();
    }
    write_answers(watched, lines);
    if gap {
        lines.gap();
    }
    lines.paragraph(explanation.title, Role::Title);
    lines.paragraph(&explanation.text, Role::Text);
    if apart {
        lines.gap();
    }
    lead(lines);
    if next {
        let next = match watched.opened {
            _ if watched.remedy.is_some() => "Enter: the right shot.",
            Some(_) => "Enter: back to the list.",
            None => "Enter: go on.",
        };
        lines.line(next, Role::Key);
    }
}

fn credit_bar(grade: &Grade, lines: &mut Lines) {
    let percent = format!("{:.0} %", 100.0 * grade.credit);
    // A name of eight columns, five and a blank for the share.
    let width = lines.width().saturating_sub(8 + 1 + 6);
    let bar = bar(grade.credit, width, lines.charset());
    lines.written_as(
        |_| Words::meter("credit", grade.credit, &percent, Role::Text),
        |lines| lines.pair(&format!("credit  {bar}"), &percent, Role::Text, Role::Text),
    );
}

/// Rows of [`write_answers`].
fn answer_rows(watched: &AnsweredQuestion, lines: &Lines) -> u16 {
    match said_and_truth(watched) {
        Some([said, truth]) => {
            lines.rows_of_hanging(YOU, &said) + lines.rows_of_hanging(TRUTH, &truth)
        }
        None => 3,
    }
}

/// What stands before an answer and before the true one.
const YOU: &str = "you    ";
const TRUTH: &str = "truth  ";

/// The answer and the true one in words; `None` for rays of a hit, which make a table.
fn said_and_truth(watched: &AnsweredQuestion) -> Option<[String; 2]> {
    let form = &watched.question.form;
    let both = [watched.answer.said, form.truth()];
    // Without a hit to be seen, rays have no sides to count from.
    let table = matches!(form, Form::Rays { .. }) && watched.reveal.watch().is_some();
    (!table).then(|| both.map(|said| lettered(form, &said)))
}

fn write_answers(watched: &AnsweredQuestion, lines: &mut Lines) {
    if let Some([said, truth]) = said_and_truth(watched) {
        lines.hanging(YOU, &said, Role::Predicted);
        lines.hanging(TRUTH, &truth, Role::Good);
    } else if let (Some(watch), Form::Rays { target, .. }, Response::Rays(said)) = (
        watched.reveal.watch(),
        &watched.question.form,
        &watched.answer.said,
    ) {
        let names = ["striker", target].map(Some);
        written::<()>(lines, |panel| {
            said_and_true(watch.collision(), said, names, true, panel);
        });
    }
}
