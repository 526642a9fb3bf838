//! The question sheet and the answer key as HTML.

use maud::{Markup, html};

use super::{Worksheet, pictures, words};
use crate::numbers;
use crate::quiz::{Confidence, Form, Measure, Question, letter};
use crate::widgets::text::unbroken;

/// The maximum width of a picture beside its question, in CSS pixels: 96 mm.
const BESIDE: f64 = 363.0;

/// The head of a sheet: its kind, and the command that opens the round on a screen.
fn head(worksheet: &Worksheet, kind: &str, title: &str) -> Markup {
    html! {
        header {
            div {
                p.dim { "carrom · " (kind) " · " (numbers::counted(worksheet.round.questions().len(), "question")) }
                h1 { bdi { (title) } }
            }
            div.code {
                span.dim { "code" }
                strong { (worksheet.code()) }
                @if let Some(command) = worksheet.command() {
                    span.dim { "on screen: " code { (command) } }
                }
            }
        }
    }
}

/// All questions, with space for the answers.
pub(super) fn questions(worksheet: &Worksheet) -> Markup {
    let questions = worksheet.round.questions();
    html! {
        div.worksheet {
            (head(worksheet, "worksheet", &worksheet.title))
            div.fields {
                @for (field, class) in [("Name", "wide"), ("Class", "short"), ("Date", "short")] {
                    div class=(class) { span { (field) } }
                }
            }
            p.advice { (words::ADVICE) " " (words::worth(questions)) }
            @for (number, question) in (1..).zip(questions) {
                (one(number, question))
            }
        }
    }
}

fn one(number: usize, question: &Question) -> Markup {
    let picture = pictures::of_question(question);
    let is_wide = picture.as_ref().is_some_and(|it| it.size()[0] > BESIDE);
    html! {
        article.question.wide[is_wide] {
            h2 { (number) }
            div.said {
                p { (unbroken(&question.text)) }
                @if let Some(task) = words::task(question) { p.task { (task) } }
                (room(&question.form))
                p.sure {
                    span.dim { "How sure?" }
                    @for sure in Confidence::ALL { span.tick { (ticked(sure.name())) } }
                    span.points { span.blank {} (words::of_points(question)) }
                }
            }
            @if let Some(picture) = picture { figure { (picture) } }
        }
    }
}

/// A tick box with its label.
fn ticked(text: &str) -> Markup {
    html! { span.box {} " " (text) }
}

/// Space for an answer of this form.
fn room(form: &Form) -> Markup {
    match form {
        Form::Rays { target, .. } => html! {
            table.rays {
                @for name in ["striker", target] {
                    tr {
                        td { (numbers::capital(name)) }
                        td { (blank("°")) }
                        @for way in ["left", "right", "stays still"] { td { (ticked(way)) } }
                    }
                }
            }
        },
        Form::Number { quantity, .. } => html! {
            (work())
            p.answer {
                "Answer: "
                @if *quantity == Measure::Restitution { "e = " }
                (blank(quantity.unit()))
            }
        },
        Form::Choice { options, .. } => html! {
            ol.choices {
                @for (i, option) in options.iter().enumerate() {
                    li { span.box {} strong { (letter(i)) } span { (unbroken(option)) } }
                }
            }
        },
        Form::Shot(_) => html! {
            (work())
            p.answer { "Offset: " (blank("mm")) span.tick { (ticked("left")) } span.tick { (ticked("right")) } }
        },
    }
}

fn work() -> Markup {
    html! { div.work { @for _ in 0..3 { div {} } } }
}

/// A line to write on, followed by the unit.
fn blank(unit: &str) -> Markup {
    html! { span.blank {} @if unit == "°" { (unit) } @else { "\u{a0}" (unit) } }
}

/// All answers: first in a list, and then each with its explanation.
pub(super) fn answers(worksheet: &Worksheet) -> Markup {
    let questions = worksheet.round.questions();
    html! {
        div.worksheet.key {
            (head(worksheet, "key", &worksheet.key_title()))
            p.advice { (words::KEY_ADVICE) }
            h2 { "At a glance" }
            ol.glance {
                @for question in questions { li { (words::truth(question)) } }
            }
            p.dim { (words::tolerance()) " " (words::points()) }
            @for (number, question) in (1..).zip(questions) {
                (solution(number, question))
            }
        }
    }
}

fn solution(number: usize, question: &Question) -> Markup {
    html! {
        article.solution {
            div.worked {
                h2 { (number) " " span.dim { (question.topic) } }
                div {
                    p.asked { (unbroken(&question.text)) }
                    p.truth { (words::truth(question)) }
                    p { (unbroken(&question.why)) }
                }
                @if let Some(picture) = pictures::of_answer(question) { figure { (picture) } }
            }
            @let wrong = question.wrong_answers();
            @if !wrong.is_empty() {
                table.beliefs {
                    thead { tr { @for head in words::WRONG_ANSWERS { th { (head) } } } }
                    tbody {
                        @for (said, misconception, says) in wrong {
                            tr {
                                td { (words::said(question, &said)) }
                                td {
                                    @if let Some(it) = misconception { strong { (it.name()) } " " }
                                    (unbroken(says))
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}
