//! After the last question: the final board, what the class believed, what each
//! question showed.

use ratatui::layout::Rect;

use super::play::{ClassPlay, EndPage};
use super::view::{Text, column};
use crate::class::{ClassRound, ItemAnalysis, Vote, items};
use crate::numbers::fixed;
use crate::physics::units::deg_from_rad;
use crate::quiz::Misconception;
use crate::widgets::{Lines, Role, text};

/// The words of a page beside the scoreboard.
pub(super) fn text<'a>(play: &'a ClassPlay, page: EndPage, area: Rect) -> Text<'a> {
    let write = match page {
        EndPage::Items => write_items,
        _ => write_held,
    };
    let mut place = column(area);
    // The last row is for the word that there is more.
    place.height = place.height.saturating_sub(1);
    (place, Box::new(move |lines| write(&play.round, lines)))
}

/// What the class believed, the commonest first: each misconception with how many first
/// votes fitted it, and how many votes after talking.
fn held(round: &ClassRound) -> Vec<(Misconception, [usize; 2])> {
    let fitted = Vote::BOTH.map(|vote| {
        let questions = 0..round.questions().len();
        let held = questions.flat_map(|question| round.held(question, vote));
        held.map(|(misconception, _)| misconception)
            .collect::<Vec<_>>()
    });
    let counts = |it| {
        fitted
            .each_ref()
            .map(|held| held.iter().filter(|other| **other == it).count())
    };
    let mut held: Vec<_> = Misconception::ALL
        .iter()
        .map(|it| (*it, counts(*it)))
        .filter(|(_, counts)| *counts != [0, 0])
        .collect();
    held.sort_by_key(|(_, [first, second])| std::cmp::Reverse(first + second));
    held
}

fn write_held(round: &ClassRound, lines: &mut Lines) {
    let held = held(round);
    if held.is_empty() {
        lines.paragraph(
            "No vote fitted a misconception that is known. That is rare, and good.",
            Role::Text,
        );
        return;
    }
    lines.paragraph(
        "How often a vote fitted a misconception that many have: at first, and after talking.",
        Role::Dim,
    );
    for (misconception, [first, second]) in held {
        lines.gap();
        let counts = format!("{first}, then {second}");
        lines.pair(misconception.name(), &counts, Role::Title, Role::Title);
        lines.paragraph(misconception.advice(), Role::Text);
    }
}

/// Columns of the numbers of a row.
const NUMBERS: usize = 34;

fn write_items(round: &ClassRound, lines: &mut Lines) {
    let room = usize::from(lines.width()).saturating_sub(1);
    let topic = room.saturating_sub(NUMBERS + 3).min(28);
    let (number, name, right) = ("", "", "right");
    lines.line(
        &format!(
            "{number:>2} {name:topic$} {right:>11} {:>12} {:>8}",
            "degrees off", "tells"
        ),
        Role::Dim,
    );
    lines.line(
        &format!(
            "{number:>2} {name:topic$} {:>5} {:>5} {:>6} {:>5} {:>8}",
            "first", "then", "first", "then", "apart"
        ),
        Role::Dim,
    );
    let asked = round.questions();
    for item in items(round, asked.len()) {
        let about = text::clipped(&asked[item.question].topic.name(), topic);
        lines.line(&row(&item, &about, topic), Role::Title);
        if let Some((misconception, count)) = item.commonest {
            let held = format!("{}: {count}", misconception.name());
            lines.hanging("     ", &held, Role::Text);
        }
    }
    lines.gap();
    lines.paragraph(
        "\"right\": how many of the votes were. \"degrees off\": the mean error of angles; of two rays the one further off counts. \"tells apart\": how well a question tells the better teams from the others, -1 to 1; it needs three teams.",
        Role::Dim,
    );
}

fn row(item: &ItemAnalysis, about: &str, topic: usize) -> String {
    let percent =
        |share: Option<f64>| share.map_or("-".into(), |it| format!("{:.0} %", 100.0 * it));
    let mean =
        |vote: usize| item.spread[vote].map_or("-".into(), |it| fixed(deg_from_rad(it.mean), 1));
    let tells = item.discrimination.map_or("-".into(), |it| fixed(it, 2));
    let filled = " ".repeat(topic.saturating_sub(text::width(about)));
    format!(
        "{:>2} {about}{filled} {:>5} {:>5} {:>6} {:>5} {tells:>8}",
        item.question + 1,
        percent(item.right[0]),
        percent(item.right[1]),
        mean(0),
        mean(1),
    )
}
