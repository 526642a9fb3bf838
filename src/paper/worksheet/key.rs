//! The answer key as HTML.

use maud::{Markup, html};

use super::{Worksheet, html::figure, html::head, pictures, words};
use crate::quiz::Question;
use crate::widgets::text::unbroken;

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
                    p.asked { (unbroken(&question.text)) }
                    p.truth { (words::truth(question)) }
                    p { (unbroken(&question.why)) }
                }
                @if let Some(picture) = pictures::of_answer(question) { (figure(&picture)) }
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
