//! How the page looks on which a round is set up.

use ratatui::buffer::Buffer;
use ratatui::layout::{Margin, Rect};

use super::heading::{Heading, below};
use super::set_up::{RoundKind, SetUp, SetUpRow};
use super::view::{column, slot};
use crate::class::MOST_TEAMS;
use crate::quiz::CourseKind;
use crate::widgets::flow::Run;
use crate::widgets::input::{ListView, TextField};
use crate::widgets::panels::draw_panel;
use crate::widgets::{Charset, Lines, Look, Role, Words, text};

/// Rows below the frames: the ways to start, and the list of earlier rounds.
const BELOW: u16 = 4;
/// Rows of what is wrong.
const TROUBLE: u16 = 3;

/// The frames of the teams and of the round, and the rows below them.
fn layout(set_up: &SetUp, area: Rect) -> [Rect; 3] {
    // Two rows a kind of round, and the frame.
    let panel = 2 * set_up.kinds().len() as u16 + 2;
    // The heading is the same height in both charsets at any size that it is shown at. It makes
    // room for what is wrong.
    let trouble = if set_up.trouble.is_some() { TROUBLE } else { 0 };
    let head = area.height.saturating_sub(panel + BELOW + trouble).min(6);
    let page = below(column(area), head);
    let half = page.width / 2;
    let top = slot(page, 0, panel);
    let teams = Rect { width: half, ..top };
    let round = Rect {
        x: top.x + half,
        width: top.width - half,
        ..top
    };
    [teams, round, below(page, panel)]
}

fn inside(frame: Rect) -> Rect {
    frame.inner(Margin::new(1, 1))
}

/// The row at a cell.
pub(super) fn row_at(set_up: &SetUp, area: Rect, cell: (u16, u16)) -> Option<SetUpRow> {
    let [teams, round, below] = layout(set_up, area);
    if let Some(row) = ListView::row_at(inside(teams), cell) {
        let is_here = |row: &SetUpRow| !matches!(row, SetUpRow::Kind(_));
        return set_up.rows().into_iter().take_while(is_here).nth(row);
    }
    if let Some(row) = ListView::row_at(inside(round), cell) {
        return set_up.kinds().get(row / 2).copied().map(SetUpRow::Kind);
    }
    match ListView::row_at(below, cell)? {
        0 => Some(SetUpRow::Start),
        1 => Some(SetUpRow::Tally),
        2 => Some(SetUpRow::Devices),
        3 => Some(SetUpRow::Earlier),
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
                let field = &set_up.teams[team];
                let name = typed(field, lines.width(), chosen, look.charset);
                let words = format!("{} {name}", team + 1);
                let label = format!("team {}", team + 1);
                field_line(&words, &label, field.text(), chosen, &mut lines);
            }
            SetUpRow::Add => {
                let words = "+ add a team: type its name";
                field_line(words, words, "", chosen, &mut lines);
            }
            SetUpRow::Class => {
                let width = lines.width().saturating_sub(8);
                let name = typed(&set_up.class, width, chosen, look.charset);
                let label = match set_up.class.text().is_empty() {
                    true => "the class, for tables: no name",
                    false => "class",
                };
                let words = match set_up.class.text().is_empty() && !chosen {
                    true => "the class, for tables: no name",
                    false => &format!("class: {name}"),
                };
                field_line(words, label, set_up.class.text(), chosen, &mut lines);
            }
            _ => {}
        }
    }
    let mut lines = Lines::new(inside(round), buf, *look);
    for kind in set_up.kinds() {
        let chosen = set_up.at() == SetUpRow::Kind(kind);
        let mark = if set_up.kind == kind { "(*)" } else { "( )" };
        let (name, about) = words(set_up, kind, lines.width(), chosen, look.charset);
        let sign = if set_up.kind == kind { "●" } else { "○" };
        let recorded = |charset| Words::Text {
            mark: sign.to_owned(),
            runs: vec![Run::new(name.trim(), Role::Text).spelt(charset)],
        };
        lines.clicked_as(recorded, Some(chosen), |lines| {
            if kind == RoundKind::Code {
                // What is typed of it, wherever the cursor is.
                let recorded = |_| Words::text_field("the code", set_up.code.text());
                lines.recorded_too(recorded);
            }
            line(&format!("{mark} {name}"), chosen, lines);
        });
        lines.line(&format!("      {about}"), Role::Dim);
    }
    let mut lines = Lines::new(below, buf, *look);
    line(
        "Start with these teams",
        set_up.at() == SetUpRow::Start,
        &mut lines,
    );
    let tally = set_up.at() == SetUpRow::Tally;
    line(
        "Start with hands or cards that are counted",
        tally,
        &mut lines,
    );
    let devices = set_up.at() == SetUpRow::Devices;
    line("Start on devices of their own", devices, &mut lines);
    let earlier = set_up.at() == SetUpRow::Earlier;
    line("Take up an earlier round", earlier, &mut lines);
    if let Some(trouble) = &set_up.trouble {
        lines.paragraph(trouble, Role::Warn);
    }
}

fn line(words: &str, chosen: bool, lines: &mut Lines) {
    lines.choice(chosen, Role::Text, |lines, mark, role| {
        lines.line(&format!("{mark} {words} "), role);
    });
}

/// The line of a field, which is called `label` where it has one beside it.
fn field_line(words: &str, label: &str, typed: &str, chosen: bool, lines: &mut Lines) {
    let recorded = |_| Words::text_field(label, typed);
    lines.clicked_as(recorded, Some(chosen), |lines| line(words, chosen, lines));
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
    let course = set_up.course(kind);
    let count = course.as_ref().map_or(0, CourseKind::length);
    let name = course.as_ref().map_or("", CourseKind::name);
    match kind {
        RoundKind::Mixed | RoundKind::Quick => {
            (name.into(), format!("{count} questions, all kinds mixed"))
        }
        RoundKind::Hits => (name.into(), format!("{count} questions, where to?")),
        RoundKind::Topic => {
            let name = match chosen {
                true => format!("< {name} >"),
                false => name.into(),
            };
            (format!("one topic, {count} questions"), name)
        }
        RoundKind::Own => {
            let count = set_up.own.concepts.len();
            let left = match set_up.own.problems.len() {
                0 => String::new(),
                1 => ", one file left out".into(),
                left => format!(", {left} files left out"),
            };
            (name.into(), format!("of {count}{left}"))
        }
        RoundKind::Code => {
            let code = typed(&set_up.code, width.saturating_sub(14), chosen, charset);
            (format!("by its code: {code}"), "such as mixed-7".into())
        }
    }
}
