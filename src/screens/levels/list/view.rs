//! How the list of levels looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::levels::{Level, Shelf};
use crate::screens::Context;
use crate::screens::levels::play::dial_name;
use crate::screens::levels::words;
use crate::widgets::input::ListView;
use crate::widgets::{Lines, Role, SplitLayout, text};

/// What stands beside the level that is to be won next.
const NEXT: &str = "next";
/// Columns of the panel on a narrow screen, where the titles need the room.
const NARROW_PANEL: u16 = 24;

/// Where the list and the panel are.
fn layout(area: Rect) -> SplitLayout {
    if area.width < 80 {
        SplitLayout::with_panel(area, NARROW_PANEL)
    } else {
        SplitLayout::new(area)
    }
}

/// A line of the list.
enum LevelRow {
    /// Nothing, between two packs.
    Gap,
    /// The name of a pack and how much of it is won.
    Head(String),
    /// A level or a problem, by its number among what can be chosen.
    Choice(usize),
}

/// All lines of the list.
fn rows(shelf: &Shelf) -> Vec<LevelRow> {
    let mut rows = Vec::new();
    let head = |rows: &mut Vec<LevelRow>, text: String| {
        if !rows.is_empty() {
            rows.push(LevelRow::Gap);
        }
        rows.push(LevelRow::Head(text));
    };
    let mut number = 0;
    for pack in &shelf.library().packs {
        let members = number..number + pack.levels.len();
        let won = members.clone().filter(|n| shelf.stars(*n) > 0).count();
        let title = format!("{}: {won} of {} won", pack.title(), pack.levels.len());
        head(&mut rows, title);
        rows.extend(members.clone().map(LevelRow::Choice));
        number = members.end;
    }
    let problems = shelf.library().problems.len();
    if problems > 0 {
        let files = if problems == 1 { "file" } else { "files" };
        head(&mut rows, format!("left out: {problems} {files}"));
        rows.extend((number..number + problems).map(LevelRow::Choice));
    }
    rows
}

/// The first line shown.
fn first_line(shelf: &Shelf, rows: &[LevelRow], height: u16) -> usize {
    let chosen = |row: &LevelRow| matches!(row, LevelRow::Choice(at) if *at == shelf.at);
    let at = rows.iter().position(chosen).unwrap_or(0);
    ListView::first_shown(at, rows.len(), height)
}

/// The level or problem whose line is at this cell.
pub(super) fn choice_at(shelf: &Shelf, area: Rect, cell: (u16, u16)) -> Option<usize> {
    let list = layout(area).picture;
    if !list.contains(cell.into()) {
        return None;
    }
    let rows = rows(shelf);
    let first = first_line(shelf, &rows, list.height);
    match rows.get(first + usize::from(cell.1 - list.y))? {
        LevelRow::Choice(at) => Some(*at),
        LevelRow::Gap | LevelRow::Head(_) => None,
    }
}

/// Draws the list and what the chosen level is about.
pub(super) fn draw(area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = layout(area);
    let shelf = &cx.shelf;
    let problem = shelf
        .at
        .checked_sub(shelf.count())
        .and_then(|i| shelf.library().problems.get(i));
    let side_title = if problem.is_some() {
        "what is wrong"
    } else {
        "the level"
    };
    layout.draw(buf, &look, "levels", side_title);
    let rows = rows(shelf);
    let first = first_line(shelf, &rows, layout.picture.height);
    let mut lines = Lines::new(layout.picture, buf, look);
    for row in rows.iter().skip(first) {
        match row {
            LevelRow::Gap => lines.line("", Role::Text),
            LevelRow::Head(text) => lines.line(text, Role::Title),
            LevelRow::Choice(at) => choice(shelf, *at, &mut lines),
        }
    }
    let mut lines = Lines::new(layout.panel, buf, look);
    if let Some(problem) = problem {
        lines.paragraph(&problem.to_string(), Role::Warn);
        lines.gap();
        lines.paragraph("The other levels can be played all the same.", Role::Text);
    } else if let Some((_, level)) = shelf.get(shelf.at) {
        about(level, shelf.stars(shelf.at), &mut lines);
    } else {
        lines.paragraph("There are no levels here.", Role::Text);
    }
}

/// The line of a level or a problem.
fn choice(shelf: &Shelf, at: usize, lines: &mut Lines) {
    let level = shelf.get(at).map(|(_, level)| level);
    let usual = if level.is_some() {
        Role::Text
    } else {
        Role::Warn
    };
    let (mark, role) = usual.of_choice(at == shelf.at);
    let Some(level) = level else {
        let problem = shelf.library().problems.get(at - shelf.count());
        let path = problem.map_or("", |problem| &problem.file);
        let file = path.rsplit(['/', '\\']).next().unwrap_or_default();
        lines.line(&format!("{mark} {}", file.escape_debug()), role);
        return;
    };
    let stars = match shelf.stars(at) {
        0 => "   ".to_owned(),
        stars => words::stars(stars),
    };
    let name = format!("{mark} {:2} {stars} {}", at + 1, level.title);
    let free = usize::from(lines.width()).saturating_sub(text::width(&name));
    let is_next = shelf.next() == Some(at) && free > NEXT.len() + 1;
    let next = if is_next { NEXT } else { "" };
    lines.pair(&name, next, role, Role::Key);
}

/// What a level is about.
fn about(level: &Level, stars: u8, lines: &mut Lines) {
    lines.paragraph(&level.title, Role::Title);
    if stars > 0 {
        lines.line(&words::stars(stars), Role::Good);
    }
    lines.gap();
    for goal in &level.goals {
        lines.paragraph(&goal.describe(&level.scene), Role::Text);
    }
    lines.gap();
    let dials = level.adjust.dials().map(|(dial, _)| dial_name(dial));
    let dials = dials.collect::<Vec<_>>().join(", ");
    lines.paragraph(&format!("You set: {dials}."), Role::Dim);
    lines.gap();
    lines.paragraph("Enter: play it.", Role::Key);
}
