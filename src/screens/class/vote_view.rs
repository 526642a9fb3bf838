//! How the teams' voting looks: who has voted, and the team that is just doing so.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::heading::Heading;
use super::play::ClassPlay;
use super::view::{Text, column, teams, vote_name};
use super::vote_entry::VoteEntry;
use crate::class::{ClassRound, Vote};
use crate::quiz::{Form, Illustration, Question};
use crate::widgets::big::{Align, Big};
use crate::widgets::{AnswerInput, Lines, Look, Role, SplitLayout, draw_question, text};

/// Columns before a name: a mark and a number.
const MARK: u16 = 5;
/// Columns of a list in plain type at most.
const NARROW: u16 = 64;
/// Columns behind a name: what the team has done.
const STATE: u16 = 18;

fn heading(vote: Vote) -> Heading<'static> {
    match vote {
        Vote::First => Heading::new(
            &["First vote", "Vote 1"],
            "Each team in turn. What was said before is hidden.",
        ),
        Vote::Second => Heading::new(
            &["Second vote", "Vote 2"],
            "Who wants to change? All others keep their vote.",
        ),
    }
}

/// The rows of the teams, and of going on at the end: their place, how high each is,
/// and the names if they are in large type.
struct TeamRows {
    place: Rect,
    height: u16,
    names: Option<Vec<Big>>,
}

fn rows(round: &ClassRound, vote: Vote, area: Rect, look: &Look) -> TeamRows {
    let rest = heading(vote).rest(area, look);
    let place = column(rest);
    let count = round.teams().len() as u16 + 1;
    let height = place.height / count;
    let width = place.width.saturating_sub(MARK + STATE);
    let names: Vec<&str> = round.teams().iter().map(String::as_str).collect();
    let names = Big::fit_lines(&names, width, look.charset).filter(|_| height >= 5);
    let place = match &names {
        Some(_) => place,
        None => {
            let width = place.width.min(NARROW);
            let x = rest.x + (rest.width - width) / 2;
            Rect { x, width, ..place }
        }
    };
    TeamRows {
        place,
        height: match &names {
            Some(_) => height.min(6),
            None => height.clamp(1, 2),
        },
        names,
    }
}

/// The row at a cell: a team, or after the last team going on.
pub(super) fn row_at(
    round: &ClassRound,
    vote: Vote,
    area: Rect,
    look: &Look,
    cell: (u16, u16),
) -> Option<usize> {
    let rows = rows(round, vote, area, look);
    if !rows.place.contains(cell.into()) {
        return None;
    }
    let row = usize::from((cell.1 - rows.place.y) / rows.height);
    (row <= round.teams().len()).then_some(row)
}

/// Draws who has voted, and not what.
pub(super) fn draw_teams(
    play: &ClassPlay,
    entry: &VoteEntry,
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
) {
    let round = &play.round;
    heading(entry.vote).draw(area, buf, look);
    let rows = rows(round, entry.vote, area, look);
    let at = entry.at(round);
    let place = |row: usize| {
        let from = rows.place.y + (row as u16).saturating_mul(rows.height);
        Rect {
            y: from,
            height: rows.height,
            ..rows.place
        }
        .intersection(rows.place)
    };
    for (team, name) in round.teams().iter().enumerate() {
        let place = place(team);
        let role = if team == at {
            Role::Selected
        } else {
            Role::Title
        };
        let mark = if team == at { '>' } else { ' ' };
        let (ticked, state) = state(round, play.number(), team, entry.vote);
        let tick = if ticked { "[x]" } else { "[ ]" };
        let state = format!("{tick} {state}");
        let state_role = if ticked { Role::Title } else { Role::Text };
        let mut lines = Lines::new(place, buf, *look);
        match &rows.names {
            Some(names) => {
                lines.pair(&format!("{mark} {}", team + 1), &state, role, state_role);
                let of_name = Rect {
                    x: place.x + MARK,
                    width: place.width.saturating_sub(MARK),
                    ..place
                };
                names[team].draw(of_name, buf, look, Role::Title, Align::Left);
            }
            None => {
                let room = usize::from(place.width.saturating_sub(MARK + STATE + 2));
                let name = text::clipped(name, room);
                let name = format!("{mark} {} {name} ", team + 1);
                lines.pair(&name, &state, role, state_role);
            }
        }
    }
    let last = round.teams().len();
    let (mark, role) = if entry.at(round) == last {
        ('>', Role::Selected)
    } else {
        (' ', Role::Text)
    };
    let ballots = (0..last).map(|team| round.ballot(play.number(), team));
    let missing = ballots.filter(|ballot| ballot.counts().is_none()).count();
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

/// Whether a team has done what it was to do, and in words.
fn state(round: &ClassRound, question: usize, team: usize, vote: Vote) -> (bool, &'static str) {
    let ballot = round.ballot(question, team);
    match (vote, ballot.first, ballot.second) {
        (Vote::First, Some(_), _) => (true, "has voted"),
        (Vote::Second, Some(_), Some(_)) => (true, "has changed"),
        (Vote::Second, None, Some(_)) => (true, "has voted"),
        (Vote::Second, Some(_), None) => (true, "keeps its vote"),
        (_, None, _) => (false, "not yet"),
    }
}

/// Where a team votes: picture and panel.
pub(super) fn entry_layout(question: &Question, area: Rect) -> SplitLayout {
    match question.picture {
        Illustration::Nothing => SplitLayout::text_alone(area),
        _ => SplitLayout::new(area),
    }
}

/// Draws what a team is about to say.
pub(super) fn draw_entry(
    play: &ClassPlay,
    entry: &VoteEntry,
    input: &AnswerInput,
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
) {
    let Some(question) = play.question() else {
        return;
    };
    let layout = entry_layout(question, area);
    layout.draw(buf, look, vote_name(entry.vote), "what they say");
    draw_question(layout.picture, buf, look, question, Some(input));
}

/// The words beside a team's vote.
pub(super) fn text<'a>(play: &'a ClassPlay, entry: &'a VoteEntry, area: Rect) -> Option<Text<'a>> {
    let question = play.question()?;
    let input = entry.input.as_ref()?;
    let layout = entry_layout(question, area);
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
