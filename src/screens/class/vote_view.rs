//! What stands below the question while the teams vote: who has, or the team that just does.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::play::ClassPlay;
use super::vote_entry::VoteEntry;
use crate::class::{ClassRound, Vote};
use crate::quiz::{Form, Question, letter};
use crate::widgets::panel::written;
use crate::widgets::{AnswerInput, Lines, Look, Role, rehearsed, text};

/// Columns beside a team's name: a mark, its number, and what it has done.
const BESIDE: u16 = 10;
/// Rows of teams at most, of ten rows of the screen.
const MOST_ROWS: u16 = 3;

/// Where each team stands: so many in a row of so many columns, the first rows left out where
/// there are too many.
struct TeamGrid {
    place: Rect,
    per_row: u16,
    first_row: u16,
}

impl TeamGrid {
    /// The teams as close together as their names go.
    fn new(round: &ClassRound, at: usize, place: Rect) -> Self {
        let per_row = per_row(round, place.width);
        let at = at.min(round.participants().len().saturating_sub(1)) as u16 / per_row;
        Self {
            place,
            per_row,
            first_row: (at + 1).saturating_sub(place.height),
        }
    }

    /// The cell of a team; of no rows where it is left out.
    fn cell(&self, team: usize) -> Rect {
        let (row, column) = (team as u16 / self.per_row, team as u16 % self.per_row);
        let width = self.place.width / self.per_row;
        let seen = row.checked_sub(self.first_row);
        let seen = seen.filter(|row| *row < self.place.height);
        Rect {
            x: self.place.x + column * width,
            y: self.place.y + seen.unwrap_or(0),
            width,
            height: u16::from(seen.is_some()),
        }
    }
}

/// How many teams stand beside each other.
fn per_row(round: &ClassRound, columns: u16) -> u16 {
    let widest = round.teams().iter().map(|name| text::width(name)).max();
    let widest = widest.unwrap_or(0) as u16 + BESIDE;
    (columns / widest).max(1)
}

/// Rows of the teams, and of going on below them.
fn team_rows(round: &ClassRound, area: Rect) -> u16 {
    let needed = (round.participants().len() as u16).div_ceil(per_row(round, area.width));
    needed.min((area.height * MOST_ROWS / 10).max(1))
}

/// Rows of what stands below a question that is voted on.
pub(super) fn foot_rows(
    play: &ClassPlay,
    question: &Question,
    entry: &VoteEntry,
    area: Rect,
    look: &Look,
) -> u16 {
    match &entry.input {
        None => team_rows(play.round(), area) + 1,
        Some(input) => rehearsed(area, *look, |lines| {
            write_booth(play, question, entry, input, lines);
            lines.written()
        }),
    }
}

/// The row at a cell of the foot: a team, or after the last team going on.
pub(super) fn row_at(
    round: &ClassRound,
    entry: &VoteEntry,
    foot: Rect,
    cell: (u16, u16),
) -> Option<usize> {
    if !foot.contains(cell.into()) {
        return None;
    }
    if cell.1 + 1 == foot.bottom() {
        return Some(round.participants().len());
    }
    let grid = TeamGrid::new(round, entry.at(round), above_last(foot));
    (0..round.participants().len()).find(|team| grid.cell(*team).contains(cell.into()))
}

/// An area but for its last row.
fn above_last(foot: Rect) -> Rect {
    Rect {
        height: foot.height.saturating_sub(1),
        ..foot
    }
}

/// Draws who has voted, and not what; or the team that is just doing so.
pub(super) fn draw(
    play: &ClassPlay,
    question: &Question,
    entry: &VoteEntry,
    foot: Rect,
    buf: &mut Buffer,
    look: &Look,
) {
    if let Some(input) = &entry.input {
        let mut lines = Lines::new(foot, buf, *look);
        return write_booth(play, question, entry, input, &mut lines);
    }
    let round = play.round();
    let at = entry.at(round);
    let grid = TeamGrid::new(round, at, above_last(foot));
    for (team, name) in round.teams().iter().enumerate() {
        let cell = grid.cell(team);
        let sign = sign(round, play.number(), team, entry.vote);
        let room = usize::from(cell.width.saturating_sub(BESIDE));
        let name = text::clipped(name, room);
        Lines::new(cell, buf, *look).choice(team == at, Role::Title, |lines, mark, role| {
            lines.line(&format!("{mark} {} {name} {sign}", team + 1), role);
        });
    }
    let last = round.participants().len();
    let next = match entry.vote {
        Vote::First => "Go on: talk",
        Vote::Second => "Go on: the shot",
    };
    let row = Rect {
        y: foot.y + grid.place.height,
        height: foot.height.min(1),
        ..foot
    };
    let note = note(round, play.number(), entry.vote);
    Lines::new(row, buf, *look).choice(at == last, Role::Text, |lines, mark, role| {
        lines.pair(&format!("{mark} {next} "), &note, role, Role::Text);
    });
}

/// A sign of what a team has done: it has voted or changed its vote; it keeps it; nothing.
fn sign(round: &ClassRound, question: usize, team: usize, vote: Vote) -> &'static str {
    let ballot = round.ballot(question, team);
    match (vote, ballot.vote(Vote::First), ballot.vote(Vote::Second)) {
        (Vote::First, Some(_), _) | (Vote::Second, _, Some(_)) => "[x]",
        (Vote::Second, Some(_), None) => "[=]",
        (_, None, _) => "[ ]",
    }
}

/// How many have voted, changed their vote, keep it.
fn note(round: &ClassRound, question: usize, vote: Vote) -> String {
    let all = round.participants().len();
    let missing = all - round.said(question, Vote::Second).count();
    let missing = match missing {
        0 => String::new(),
        count => format!("{} without a vote", round.way().voters(count)),
    };
    let voted = round.voted(question, vote);
    match vote {
        Vote::First if missing.is_empty() => "all have voted".into(),
        Vote::First => missing,
        Vote::Second if missing.is_empty() => format!("changed: {voted}"),
        Vote::Second => format!("changed: {voted}, {missing}"),
    }
}

/// Writes who is to say what. What is typed is seen only where they ask for it.
fn write_booth(
    play: &ClassPlay,
    question: &Question,
    entry: &VoteEntry,
    input: &AnswerInput,
    lines: &mut Lines,
) {
    let name = play.round().name_of(entry.at(play.round()));
    let hidden = match entry.is_open {
        true => "v: hide what is typed",
        false => "what is typed is hidden; v shows it",
    };
    lines.pair(name, hidden, Role::Title, Role::Key);
    if let Form::Choice { options, .. } = &question.form {
        let letters: Vec<String> = (0..options.len()).map(|i| letter(i).to_string()).collect();
        let words = format!("One key is the vote: {}.", letters.join(", "));
        lines.line(&words, Role::Key);
        return;
    }
    if entry.is_open {
        written(lines, |panel| input.write(&question.form, Some(1), panel));
    }
    let next = match (input, &question.form) {
        (AnswerInput::Rays(rays), Form::Rays { target, .. }) if !rays.is_last() => {
            format!("Enter: then the {target}.")
        }
        _ => "Enter: that is our vote.".into(),
    };
    let about = input.about(&question.form);
    lines.paragraph(&format!("{about} {next}"), Role::Text);
}
