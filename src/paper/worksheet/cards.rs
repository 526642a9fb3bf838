//! Voting cards: A to D on a sheet that is folded twice.

use maud::html;

use crate::paper::{Paper, html_page};
use crate::quiz::letter;

const STYLE: &str = include_str!("cards.css");
/// The instruction in the middle of the sheet.
const HOW: &str = "Fold twice along the lines so that your answer shows, and hold it up.";

/// One sheet for each of `count` pupils.
pub fn cards(count: usize, paper: Paper) -> String {
    let sheet = html! {
        div.cards {
            @for choice in 0..4 { div.card data-card=(letter(choice)) { (letter(choice)) } }
            p.how { (HOW) }
        }
    };
    let sheets = std::iter::repeat_n(sheet, count);
    html_page("carrom: cards A to D", STYLE, paper, sheets)
}
