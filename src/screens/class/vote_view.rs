//! How the teams' voting looks: who has voted, and the team that is just doing so.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::play::ClassPlay;
use super::view::{Text, column, slot, teams};
use super::vote_entry::VoteEntry;
use crate::class::{ClassRound, Vote};
use crate::quiz::{Form, Illustration, Question};
use crate::widgets::big::{Align, Big};
use crate::widgets::input::ListView;
use crate::widgets::{AnswerInput, Lines, Look, Role, SplitLayout, areas, draw_question, text};

/// Columns before a name: a mark and a number.
const MARK: u16 = 5;
/// Columns of a list in plain type at most.
const NARROW: u16 = 64;
/// Columns behind a name: what the team has done.
const STATE: u16 = 18;

/// The rows of the teams, and of going on at the end: their place, how high each is,
/// and the names if they are in large type.
struct TeamRows {
    place: Rect,
    height: u16,
    names: Option<Vec<Big>>,
}

fn rows(round: &ClassRound, area: Rect, look: &Look) -> TeamRows {
    let place = column(area);
    let count = round.teams().len() as u16 + 1;
    let height = place.height / count;
    let width = place.width.saturating_sub(MARK + STATE);
    let names: Vec<&str> = round.teams().iter().map(String::as_str).collect();
    let names = Big::fit_lines(&names, width, look.charset).filter(|_| height >= 5);
    let (place, height) = match names {
        Some(_) => (place, height.min(6)),
        None => (areas::middle(area, NARROW), height.clamp(1, 2)),
    };
    TeamRows {
        place,
        height,
        names,
    }
}

/// The row at a cell: a team, or after the last team going on.
pub(super) fn row_at(
    round: &ClassRound,
    area: Rect,
    look: &Look,
    cell: (u16, u16),
) -> Option<usize> {
    let rows = rows(round, area, look);
    let row = ListView::row_at(rows.place, cell)? / usize::from(rows.height);
    (row <= round.teams().len()).then_some(row)
}

/// Draws who has voted, and not what.
fn draw_teams(play: &ClassPlay, entry: &VoteEntry, area: Rect, buf: &mut Buffer, look: &Look) {
    let round = &play.round;
    let rows = rows(round, area, look);
    let place = |row: usize| slot(rows.place, row, rows.height);
    let at = entry.at(round);
    for (team, name) in round.teams().iter().enumerate() {
        let place = place(team);
        let (mark, role) = Role::Title.of_choice(team == at);
        let number = format!("{mark} {}", team + 1);
        let (state, state_role) = match state(round, play.number(), team, entry.vote) {
            Some(done) => (format!("[x] {done}"), Role::Title),
            None => ("[ ] not yet".into(), Role::Text),
        };
        let mut lines = Lines::new(place, buf, *look);
        match &rows.names {
            Some(names) => {
                lines.pair(&number, &state, role, state_role);
                let of_name = Rect {
                    x: place.x + MARK,
                    width: place.width.saturating_sub(MARK),
                    ..place
                };
                names[team].draw(of_name, buf, look, Role::Title, Align::Left);
            }
            None => {
                let room = usize::from(place.width.saturating_sub(MARK + STATE + 2));
                let name = format!("{number} {} ", text::clipped(name, room));
                lines.pair(&name, &state, role, state_role);
            }
        }
    }
    let last = round.teams().len();
    let (mark, role) = Role::Text.of_choice(at == last);
    let missing = last - round.said(play.number(), Vote::Second).count();
    let note = match missing {
        0 => String::new(),
        count => format!("{} without a vote", teams(count)),
    };
    let next = match entry.vote {
        Vote::First => "Go on: talk",
        Vote::Second => "Go on: the shot",
    };
    Lines::new(place(last), buf, *look).pair(&format!("{mark} {next} "), &note, role, Role::Text);
}

/// What a team has done of what it was to do.
fn state(round: &ClassRound, question: usize, team: usize, vote: Vote) -> Option<&'static str> {
    let ballot = round.ballot(question, team);
    match (vote, ballot.first, ballot.second) {
        (Vote::First, Some(_), _) | (Vote::Second, None, Some(_)) => Some("has voted"),
        (Vote::Second, Some(_), Some(_)) => Some("has changed"),
        (Vote::Second, Some(_), None) => Some("keeps its vote"),
        (_, None, _) => None,
    }
}

/// Where a team votes: picture and panel.
pub(super) fn entry_layout(question: &Question, area: Rect) -> SplitLayout {
    match question.picture {
        Illustration::Nothing => SplitLayout::text_alone(area),
        _ => SplitLayout::new(area),
    }
}

/// Draws who has voted, or the team that is just doing so, and gives the words beside it.
pub(super) fn draw<'a>(
    play: &'a ClassPlay,
    question: &'a Question,
    entry: &'a VoteEntry,
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
) -> Option<Text<'a>> {
    let Some(input) = &entry.input else {
        draw_teams(play, entry, area, buf, look);
        return None;
    };
    let layout = entry_layout(question, area);
    let title = match entry.vote {
        Vote::First => "First vote",
        Vote::Second => "Second vote",
    };
    layout.draw(buf, look, title, "what they say");
    draw_question(layout.picture, buf, look, question, Some(input));
    let write = move |lines: &mut Lines| {
        if let Some(name) = play.round.teams().get(entry.at(&play.round)) {
            lines.paragraph(name, Role::Title);
            lines.gap();
        }
        lines.paragraph(&question.text, Role::Text);
        lines.gap();
        input.write(&question.form, lines);
        lines.gap();
        lines.paragraph(&input.about(&question.form), Role::Dim);
        let next = match (input, &question.form) {
            (AnswerInput::Rays(rays), Form::Rays { target, .. }) if !rays.is_last() => {
                format!("Enter: then the {target}.")
            }
            _ => "Enter: that is our vote.".into(),
        };
        lines.gap();
        lines.paragraph(&next, Role::Key);
    };
    Some((layout.panel, Box::new(write)))
}
