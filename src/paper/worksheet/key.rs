//! The key as HTML.

use maud::{Markup, html};

use super::{Worksheet, html::figure, html::head, pictures, words};
use crate::quiz::{Question, WrongAnswer};

/// All answers: at a glance, and then each with its reasons.
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
                (one(number, question))
            }
        }
    }
}

fn one(number: usize, question: &Question) -> Markup {
    html! {
        article.solution {
            div.worked {
                h2 { (number) " " span.dim { (question.topic) } }
                div {
                    p.asked { (question.text) }
                    p.truth { (words::truth(question)) }
                    p { (question.why) }
                }
                @if let Some(picture) = pictures::of_answer(question) { (figure(&picture)) }
            }
            @if !question.beliefs.is_empty() {
                table.beliefs {
                    thead { tr { th { "Who says" } th { "may think" } } }
                    tbody { @for belief in &question.beliefs { (row(question, belief)) } }
                }
            }
        }
    }
}

fn row(question: &Question, belief: &WrongAnswer) -> Markup {
    html! {
        tr {
            td { (words::said(question, &belief.said)) }
            td { strong { (belief.misconception.name()) } " " (belief.says) }
        }
    }
}
