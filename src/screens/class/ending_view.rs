//! After the last question: the final board, what the class believed, what each
//! question showed.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::heading::Heading;
use super::play::{ClassPlay, EndPage};
use super::scores_view;
use super::view::{Text, column};
use crate::class::{ClassRound, ItemAnalysis, items};
use crate::physics::units::deg_from_rad;
use crate::quiz::Misconception;
use crate::widgets::{Lines, Look, Role, text};

fn heading(page: EndPage) -> Heading<'static> {
    match page {
        EndPage::Board => Heading::new(
            &["The end"],
            "e: write the answers as tables for a spreadsheet",
        ),
        EndPage::Held => Heading::new(&["What you held", "You held"], ""),
        EndPage::Items => Heading::new(&["Questions"], ""),
    }
}

/// Draws a page.
pub(super) fn draw(play: &ClassPlay, page: EndPage, area: Rect, buf: &mut Buffer, look: &Look) {
    let rest = heading(page).draw(area, buf, look);
    if page == EndPage::Board {
        let asked = play.round.questions().len();
        scores_view::draw(&play.round, asked, rest, buf, look);
    }
}

/// The words of a page that has some.
pub(super) fn text<'a>(play: &'a ClassPlay, page: EndPage, area: Rect, look: &Look) -> Text<'a> {
    let place = column(heading(page).rest(area, look));
    // The last row is for the word that there is more.
    let place = Rect {
        height: place.height.saturating_sub(1),
        ..place
    };
    let round = &play.round;
    match page {
        EndPage::Items => (place, Box::new(move |lines| write_items(round, lines))),
        _ => (place, Box::new(move |lines| write_held(round, lines))),
    }
}

/// A misconception with how many first votes fitted it, and how many votes after
/// talking.
struct Held {
    misconception: Misconception,
    first: usize,
    second: usize,
}

/// What the class believed, the commonest first.
fn held(round: &ClassRound) -> Vec<Held> {
    let ballots: Vec<_> = (0..round.questions().len())
        .flat_map(|question| (0..round.teams().len()).map(move |team| (question, team)))
        .map(|(question, team)| (question, round.ballot(question, team)))
        .collect();
    let count = |it: Misconception, after: bool| {
        let fits = ballots.iter().filter(|(question, ballot)| {
            let said = if after { ballot.counts() } else { ballot.first };
            round
                .diagnose(*question, said)
                .is_some_and(|diagnosis| diagnosis.misconception == it)
        });
        fits.count()
    };
    let mut held: Vec<Held> = Misconception::ALL
        .iter()
        .map(|&misconception| Held {
            misconception,
            first: count(misconception, false),
            second: count(misconception, true),
        })
        .filter(|it| it.first + it.second > 0)
        .collect();
    held.sort_by_key(|it| std::cmp::Reverse(it.first + it.second));
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
    for Held {
        misconception,
        first,
        second,
    } in held
    {
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
    let most = round.questions().len();
    for item in items(round, most) {
        let about = round
            .questions()
            .get(item.question)
            .map_or(String::new(), |question| {
                text::clipped(&question.topic.name(), topic)
            });
        lines.line(&row(&item, &about, topic), Role::Title);
        if let Some((misconception, count)) = item.commonest {
            lines.hanging(
                "     ",
                &format!("{}: {count}", misconception.name()),
                Role::Text,
            );
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
    let mean = |vote: usize| {
        item.spread[vote].map_or("-".into(), |it| format!("{:.1}", deg_from_rad(it.mean)))
    };
    let tells = item
        .discrimination
        .map_or("-".into(), |it| format!("{:.2}", it + 0.0));
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
