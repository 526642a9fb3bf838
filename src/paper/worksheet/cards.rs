//! Cards to vote with: A to D on a sheet that is folded twice.

use maud::html;

use crate::paper::{HtmlPage, Paper};
use crate::quiz::letter;

/// How to use it, in the middle of the sheet.
const HOW: &str = "Fold twice along the lines so that your answer shows, and hold it up.";

/// A sheet for each of so many pupils.
#[must_use]
pub fn cards(count: usize, paper: Paper) -> String {
    let sheet = || {
        html! {
            div.cards {
                @for choice in 0..4 { div.card data-card=(letter(choice)) { (letter(choice)) } }
                p.how { (HOW) }
            }
        }
    };
    let page = HtmlPage::new("carrom: cards A to D").paper(paper);
    let page = page.style(include_str!("cards.css"));
    (0..count).fold(page, |page, _| page.sheet(sheet())).html()
}
