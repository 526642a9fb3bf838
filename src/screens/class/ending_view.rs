//! After the last question: the final board, what the class believed, what each
//! question showed.

use std::cmp::Reverse;

use ratatui::layout::Rect;

use super::play::{ClassPlay, EndPage};
use super::view::{Text, column};
use crate::class::{ClassRound, ItemAnalysis, Vote, WayOfVoting, items};
use crate::numbers::fixed;
use crate::progress::words::percent;
use crate::quiz::{Evidence, Form, Misconception, Question, letter};
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
    (place, Box::new(move |lines| write(play.round(), lines)))
}

/// What shows in the votes of a class: a misconception, how many teams hold it by the
/// evidence of their first votes and after talking, and how many votes fitted it.
struct ClassBelief {
    misconception: Misconception,
    teams: [usize; 2],
    votes: [usize; 2],
    /// The evidence of those teams for whom there is any, at first.
    weight: f64,
}

/// What the class believed: first what most teams hold, then that for which there is most
/// evidence.
fn held(round: &ClassRound) -> Vec<ClassBelief> {
    // Of counted hands nobody knows whose they were: they are weighed question by question.
    let all = match round.way() {
        WayOfVoting::Tally => round.questions().len(),
        WayOfVoting::Teams | WayOfVoting::Devices => round.participants().len(),
    };
    let clues = Vote::BOTH.map(|vote| {
        let each = (0..all).map(|number| match round.way() {
            WayOfVoting::Tally => round.clues(number, vote),
            WayOfVoting::Teams | WayOfVoting::Devices => round.clues_of(number, vote),
        });
        each.collect::<Vec<_>>()
    });
    let of = |misconception| {
        let [first, second] = clues.each_ref().map(|teams| {
            let each = teams.iter().map(|clues| Evidence::of(misconception, clues));
            each.collect::<Vec<_>>()
        });
        let both = [&first, &second];
        ClassBelief {
            misconception,
            teams: both.map(|teams| teams.iter().filter(|it| it.names()).count()),
            votes: both.map(|teams| teams.iter().map(|it| it.times).sum()),
            weight: first.iter().map(|it| it.weight.max(0.0)).sum(),
        }
    };
    let mut held: Vec<_> = Misconception::ALL.iter().map(|it| of(*it)).collect();
    held.retain(|it| it.votes != [0, 0]);
    let rank = |it: &ClassBelief| (it.teams[0], it.teams[1], (1e6 * it.weight) as i64);
    held.sort_by_key(|it| Reverse(rank(it)));
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
    let about = match round.way() {
        WayOfVoting::Teams => {
            "Teams whose votes show that they hold it: at first, and after talking. It takes two \
             questions to say so of a team. Below: how many votes fitted it."
        }
        WayOfVoting::Devices => {
            "How many of you show by their votes that they hold it: at first, and after talking. \
             It takes two questions to say so of anybody. Below: how many votes fitted it."
        }
        WayOfVoting::Tally => "How many of all votes fitted it: at first, and after talking.",
    };
    lines.paragraph(about, Role::Dim);
    for it in held {
        lines.gap();
        let [first, second] = it.teams;
        let teams = match it.teams {
            [0, 0] => String::new(),
            _ => format!("{first}, then {second}"),
        };
        lines.pair(it.misconception.name(), &teams, Role::Title, Role::Title);
        let [first, second] = it.votes;
        lines.line(&format!("votes: {first}, then {second}"), Role::Dim);
        lines.paragraph(it.misconception.advice(), Role::Text);
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
        lines.hanging("     ", &told(&asked[item.question], &item), Role::Text);
        if let Some((misconception, count)) = item.commonest {
            let held = format!("{}: {count}", misconception.name());
            lines.hanging("     ", &held, Role::Text);
        }
    }
    lines.gap();
    lines.paragraph(
        "\"right\": how many of the votes were. \"degrees off\": the mean error of angles; of two rays the one further off counts. \"tells apart\": how well a question tells the better teams from the others, -1 to 1; it needs ten of them. \"gain\": the share of what could be gained by talking.",
        Role::Dim,
    );
}

/// "A 4 then 2, B 17 then 28; gain 60 %; to right 5, to wrong 1"
fn told(question: &Question, item: &ItemAnalysis) -> String {
    let is_choice = matches!(question.form, Form::Choice { .. });
    let each = item.counts.iter().enumerate();
    let counts = each.map(|(i, (said, [first, second]))| {
        let words = match is_choice {
            true => letter(i).to_string(),
            false => question.form.words(said),
        };
        format!("{words}: {first} then {second}")
    });
    let counts: Vec<String> = counts.take(MOST_COUNTS).collect();
    let mut told = vec![counts.join("; ")];
    if let Some(gain) = item.gain {
        told.push(format!("gain {:.0} %", 100.0 * gain));
    }
    if let Some([right, wrong]) = item.changed {
        told.push(format!("changed to right {right}, to wrong {wrong}"));
    }
    told.retain(|it| !it.is_empty());
    told.join(". ")
}

/// Most answers that are told with their counts.
const MOST_COUNTS: usize = 5;

fn row(item: &ItemAnalysis, about: &str, topic: usize) -> String {
    let right = item.votes.map(|it| percent(it.share_right()));
    let mean = |vote: usize| {
        item.votes[vote]
            .spread_deg()
            .map_or("-".into(), |[mean, _]| fixed(mean, 1))
    };
    let tells = item.discrimination.map_or("-".into(), |it| fixed(it, 2));
    let filled = " ".repeat(topic.saturating_sub(text::width(about)));
    format!(
        "{:>2} {about}{filled} {:>5} {:>5} {:>6} {:>5} {tells:>8}",
        item.question + 1,
        right[0],
        right[1],
        mean(0),
        mean(1),
    )
}
