//! How the page looks on which a round is set up.

use ratatui::buffer::Buffer;
use ratatui::layout::{Margin, Rect};

use super::heading::Heading;
use super::set_up::{RoundKind, SetUp, SetUpRow};
use crate::class::MOST_TEAMS;
use crate::quiz::{Course, CourseKind, Family};
use crate::widgets::input::TextField;
use crate::widgets::panels::draw_panel;
use crate::widgets::{Charset, Lines, Look, Role, text};

/// Columns of both panels together at most.
const WIDEST: u16 = 100;

/// The frames of the teams and of the round, and the rows below them.
fn layout(set_up: &SetUp, area: Rect) -> [Rect; 3] {
    // Two rows a kind of round, and the frame.
    let panel = 2 * set_up.kinds().len() as u16 + 2;
    let width = area.width.min(WIDEST);
    let x = area.x + (area.width - width) / 2;
    // The heading is the same height in both charsets at any size that it is shown at.
    let head = area.height.saturating_sub(panel + 5).min(6);
    let top = Rect {
        x,
        y: area.y + head,
        width,
        height: panel.min(area.height.saturating_sub(head)),
    };
    let half = width / 2;
    let teams = Rect { width: half, ..top };
    let round = Rect {
        x: x + half,
        width: width - half,
        ..top
    };
    let below = Rect {
        x,
        y: top.bottom(),
        width,
        height: area.bottom().saturating_sub(top.bottom()),
    };
    [teams, round, below]
}

fn inside(frame: Rect) -> Rect {
    frame.inner(Margin::new(1, 1))
}

/// The row at a cell.
pub(super) fn row_at(set_up: &SetUp, area: Rect, cell: (u16, u16)) -> Option<SetUpRow> {
    let [teams, round, below] = layout(set_up, area);
    let at = |frame: Rect| {
        frame
            .contains(cell.into())
            .then(|| usize::from(cell.1 - frame.y))
    };
    let rows = set_up.rows();
    if let Some(row) = at(inside(teams)) {
        let rows = rows
            .into_iter()
            .filter(|row| matches!(row, SetUpRow::Team(_) | SetUpRow::Add));
        return rows.collect::<Vec<_>>().get(row).copied();
    }
    if let Some(row) = at(inside(round)) {
        return set_up.kinds().get(row / 2).copied().map(SetUpRow::Kind);
    }
    match at(below)? {
        0 => Some(SetUpRow::Start),
        1 => Some(SetUpRow::Earlier),
        _ => None,
    }
}

/// Draws the page.
pub(super) fn draw(set_up: &SetUp, area: Rect, buf: &mut Buffer, look: &Look) {
    let [teams, round, below] = layout(set_up, area);
    let head = Rect {
        height: teams.y.saturating_sub(area.y),
        ..area
    };
    if head.height >= 4 {
        let texts = ["A class round", "Class"];
        // As high as a body that has a heading.
        let room = Rect {
            height: area.height.max(21),
            ..head
        };
        Heading::new(&texts, "").draw(room, buf, look);
    }
    let title = format!("teams, 1 to {MOST_TEAMS}");
    draw_panel(buf, teams, &title, look.charset, &look.theme);
    draw_panel(buf, round, "the questions", look.charset, &look.theme);
    let mut lines = Lines::new(inside(teams), buf, *look);
    for row in set_up.rows() {
        let chosen = row == set_up.at();
        match row {
            SetUpRow::Team(team) => {
                let name = typed(&set_up.teams[team], lines.width(), chosen, look.charset);
                line(&format!("{} {name}", team + 1), chosen, &mut lines);
            }
            SetUpRow::Add => line("+ add a team: type its name", chosen, &mut lines),
            _ => {}
        }
    }
    let mut lines = Lines::new(inside(round), buf, *look);
    for kind in set_up.kinds() {
        let chosen = set_up.at() == SetUpRow::Kind(kind);
        let mark = if set_up.kind == kind { "(*)" } else { "( )" };
        let (name, about) = words(set_up, kind, lines.width(), chosen, look.charset);
        line(&format!("{mark} {name}"), chosen, &mut lines);
        lines.line(&format!("      {about}"), Role::Dim);
    }
    let mut lines = Lines::new(below, buf, *look);
    line("Start", set_up.at() == SetUpRow::Start, &mut lines);
    line(
        "take up an earlier round",
        set_up.at() == SetUpRow::Earlier,
        &mut lines,
    );
    if let Some(trouble) = &set_up.trouble {
        lines.paragraph(trouble, Role::Warn);
    }
}

fn line(words: &str, chosen: bool, lines: &mut Lines) {
    let (mark, role) = if chosen {
        (">", Role::Selected)
    } else {
        (" ", Role::Text)
    };
    lines.line(&format!("{mark} {words} "), role);
}

/// What is typed, as far as there is room; where it is `chosen` up to the cursor, with
/// a mark where that is, else its end.
fn typed(field: &TextField, width: u16, chosen: bool, charset: Charset) -> String {
    let shown = |text: &str| {
        let text: String = text.chars().filter(|c| !c.is_control()).collect();
        charset.text(&text).into_owned()
    };
    let (before, after) = match chosen {
        true => field.around_cursor(),
        false => (field.text(), ""),
    };
    let room = usize::from(width).saturating_sub(9);
    let before = shown(before);
    let mut from = before.as_str();
    while text::width(from) > room {
        let mut letters = from.chars();
        letters.next();
        from = letters.as_str();
    }
    let mark = if chosen { "_" } else { "" };
    text::clipped(&format!("{from}{mark}{}", shown(after)), room + 1)
}

/// What a kind of round is called, and what it is.
fn words(
    set_up: &SetUp,
    kind: RoundKind,
    width: u16,
    chosen: bool,
    charset: Charset,
) -> (String, String) {
    let course = |kind: CourseKind, about: &str| {
        let count = Course::new(kind.clone()).count;
        (
            kind.name().to_owned(),
            format!("{count} questions, {about}"),
        )
    };
    match kind {
        RoundKind::Mixed => course(CourseKind::Mixed, "all kinds mixed"),
        RoundKind::Quick => course(CourseKind::Quick, "all kinds mixed"),
        RoundKind::Hits => course(CourseKind::Hits, "where to?"),
        RoundKind::Topic => {
            let family = CourseKind::topics().nth(set_up.topic);
            let name = family.map_or("", Family::name);
            let name = match chosen {
                true => format!("< {name} >"),
                false => name.to_owned(),
            };
            let count = family.map_or(0, |family| CourseKind::Topic(family).length());
            (format!("one topic, {count} questions"), name)
        }
        RoundKind::Own => {
            let count = set_up.own.concepts.len();
            let left = match set_up.own.problems.len() {
                0 => String::new(),
                1 => ", one file left out".into(),
                left => format!(", {left} files left out"),
            };
            ("your own questions".into(), format!("of {count}{left}"))
        }
        RoundKind::Code => {
            let code = typed(&set_up.code, width.saturating_sub(14), chosen, charset);
            (format!("by its code: {code}"), "such as mixed-7".into())
        }
    }
}
